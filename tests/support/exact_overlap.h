#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph::test {

/// What an element of the target and one of the source have in common.
struct ExactOverlap {
    Index target = -1; ///< numbers of the file
    Index source = -1;
    double area = 0;            ///< positive
    std::vector<Points2> parts; ///< convex polygons that it consists of
};

/// All overlaps of two planar meshes of convex elements, listed counter-clockwise: every pair, one after the
/// other, by CGAL's intersection of triangles with exact constructions. What they have in common is rounded
/// once, in the end. By target, then source.
std::vector<ExactOverlap> exact_overlaps(const MeshData& source, const MeshData& target);

} // namespace morph::test
