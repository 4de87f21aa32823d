#pragma once

#include "formats/format.h"
#include "formats/mesh/volume_cells.h"

#include <string>

namespace morph {

/// The zones of the first base of a CGNS file that has any, with libcgns. To be called in a process of its
/// own: libcgns and HDF5 do not survive every damaged file.
/// @param path  of a copy of the file that may be changed; @p input is for messages, options and notes
/// @throws InputError  "path: zone 'a': what is wrong"
VolumeFile read_cgns(const InputBytes& input, const std::string& path);

} // namespace morph
