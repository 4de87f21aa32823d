#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// The vertices of each closed polygon of a mesh's boundary in order, the mesh on its left. Where fans of
/// elements meet in a split vertex the polygons pass through its copies.
std::vector<std::vector<Index>> boundary_loops(const Mesh& mesh);

} // namespace morph
