#pragma once

#include "formats/mesh/volume_cells.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace morph {

/// Read one zone of an SU2 file, or a file without zones: triangles and quads, or volume cells with the
/// faces of their markers as elements and groups.
/// @param text   the file up to the end of the zone, so that lines are counted from its start
/// @param begin  where the zone begins
/// @throws InputError  "path:line: what is wrong"
VolumeFile read_su2_zone(const std::string& path, std::string_view text, std::size_t begin);

} // namespace morph
