#pragma once

#include "formats/format.h"
#include "formats/tecplot/zone.h"

namespace morph {

/// Read the variables and zones of an ASCII Tecplot file, POINT or BLOCK, each zone with its values and its
/// connectivity (that of ordered zones is made up). Texts, geometries and labels are passed over with a
/// warning.
/// @throws InputError  "path:line: …"; "path: byte 0: …" for a binary file
TecplotFile read_tecplot_file(const InputBytes& input);

} // namespace morph
