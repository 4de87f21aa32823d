#pragma once

#include "libmorph/mesh/mesh.h"

#include <string>

namespace morph::tools {

/// Positions of a file that holds the same mesh before it was moved, in the numbering of the mesh (n x 3).
/// @param path  the file that @p mesh was read from, for messages
/// @param from  format of the reference, empty: by its extension
/// @throws InputError  it cannot be read, or has other vertices or elements than the mesh
Points reference_points(const std::string& reference, const std::string& from, const Mesh& mesh,
                        const std::string& path);

} // namespace morph::tools
