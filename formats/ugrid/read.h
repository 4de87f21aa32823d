#pragma once

#include "formats/format.h"

namespace morph {

/// Read an AFLR/UGRID file of any layout and the names of its surfaces next to it. Of a volume mesh the
/// boundary is taken in any case, as the format is one of volumes; unless @p file.options ask for it, the
/// cells are warned of.
/// @throws InputError  "path:line: …", in binary "path: byte 12: …"
MeshData read_ugrid(const InputBytes& file);

} // namespace morph
