#pragma once

#include "libmorph/geometry/outline.h"
#include "libmorph/geometry/size_field.h"

#include <array>
#include <vector>

namespace morph {

/// A vertex of a refined triangulation.
struct RefinedVertex {
    Eigen::Vector2d point;
    Index loop = -1; ///< it is a node of this loop; -1: inside the domain
    double u = 0;    ///< and has this parameter on it
};

struct Refined {
    std::vector<RefinedVertex> vertices;         ///< the nodes of the loops, in their order, come first
    std::vector<std::array<Index, 3>> triangles; ///< counter-clockwise
};

/// Constrained Delaunay triangulation of the domain between the loops, refined until its triangles have
/// the target size and no angle is too small (see mesh_domain()).
///
/// @param loops  as make_outline() gives them: disjoint polygons, the box last
/// @param expected_vertices  about as many as there will be, for the progress
/// @throws InputError   more than @p max_vertices vertices
/// @throws SolverError  the loops cross after all
Refined refine(const std::vector<OutlineLoop>& loops, const SizeField& size, Index max_vertices,
               double expected_vertices);

} // namespace morph
