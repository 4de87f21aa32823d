#pragma once

#include "formats/cgns/zone.h"

#include <array>
#include <functional>
#include <vector>

namespace morph {

/// Vertices of a structured zone between two corners, which belong to it; indices from 0.
struct CgnsBox {
    std::array<Index, 3> low, high;
};

/// All vertices of a structured zone.
CgnsBox whole_grid(const CgnsZone& zone);

/// Along which indices a box holds more than one vertex: 0, 1, 2 for i, j, k.
std::vector<int> long_axes(const CgnsBox& box);

/// Number of a vertex.
Index grid_vertex(const CgnsZone& zone, const std::array<Index, 3>& at);

/// From a vertex to the next along an index.
Index grid_stride(const CgnsZone& zone, int axis);

/// Each vertex of a box, i fastest.
void for_each_point(const CgnsBox& box, const std::function<void(const std::array<Index, 3>&)>& visit);

/// For each edge, quad or hexahedron between the vertices of a box its vertex of least indices, i fastest.
void for_each_cell_of(const CgnsBox& box, const std::function<void(const std::array<Index, 3>&)>& visit);

/// The quad from a vertex along two indices.
Element grid_quad(const CgnsZone& zone, const std::array<Index, 3>& at, int first_axis, int second_axis);

} // namespace morph
