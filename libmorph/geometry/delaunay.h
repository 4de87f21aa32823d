#pragma once

#include "libmorph/mesh/mesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace morph {

/// Triangles that know their neighbours.
struct Triangulation {
    std::vector<std::array<Index, 3>> corners;    ///< vertices, counter-clockwise unless inverted
    std::vector<std::array<Index, 3>> neighbours; ///< [t][k]: across the edge opposite corner k; -1: none
};

/// The elements of a mesh as triangles, quads cut along the diagonal from their first corner.
Triangulation triangulate(const Mesh& mesh);

/// Mark these edges as constraints: flips never remove them.
/// Edges that the triangulation does not have are ignored.
void cut_along(Triangulation& triangulation, const std::vector<std::array<Index, 2>>& edges);

/// Flip edges until the triangulation of its vertices is constrained Delaunay: for no edge between
/// two neighbours lies the far corner of one inside the circumcircle of the other [Lawson 1977,
/// Mathematical Software III, 161-194]. Edges without a neighbour are the constraints.
///
/// The signs are exact, so that it ends and the opposite angles at every edge sum to at most 180
/// degrees. An inverted or flat triangle is flipped with a neighbour whenever that leaves two positive
/// ones; what a tangled mesh has left of them stays.
///
/// @param points  n x 3, z is ignored
/// @return the number of flips
std::size_t make_delaunay(const Eigen::Ref<const Points>& points, Triangulation& triangulation);

} // namespace morph
