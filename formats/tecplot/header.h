#pragma once

#include "formats/format.h"
#include "formats/tecplot/zone.h"
#include "formats/text/text_scanner.h"

namespace morph {

/// Read what follows the word ZONE up to the data of the zone, in the spelling of today (ZONETYPE,
/// DATAPACKING, VARLOCATION, VARSHARELIST) or of old (F, ET, NV, D). Keys that say nothing about the mesh are
/// passed over, unknown ones with a warning.
/// @param file      the variables and the zones so far
/// @param position  of the word ZONE
/// @throws InputError  "path:line: …": a type that is not supported, a count that is missing or that the file
///                     could not hold, a list of variables or zones out of range
TecplotZone read_tecplot_zone_header(TextScanner& in, const TecplotFile& file, std::size_t position,
                                     const InputBytes& input);

} // namespace morph
