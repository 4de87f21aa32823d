#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/weights.h"

#include <string>
#include <vector>

namespace morph {

/// Read weights that were saved as nodal fields on this mesh, or remapped to it, see weight_fields().
///
/// @param control_points  K, in this order
/// @return n x K, rows as the vertices of @p mesh
/// @throws InputError  the file's vertices are not those of the mesh, or a field is missing
Weights read_weights(const std::string& path, const Mesh& mesh,
                     const std::vector<ControlPoint>& control_points);

} // namespace morph
