#pragma once

#include "libmorph/mesh/mesh.h"

#include <array>
#include <vector>

namespace morph {

/// The two vertices of each edge with an element on one side only, in the order of the kernel's edges. Copies
/// of a split vertex are as they are.
std::vector<std::array<Index, 2>> boundary_edges(const Mesh& mesh);

/// The vertices of each closed polygon of a mesh's boundary in order, the mesh on its left. Where fans of
/// elements meet in a split vertex the polygons pass through its copies.
std::vector<std::vector<Index>> boundary_loops(const Mesh& mesh);

} // namespace morph
