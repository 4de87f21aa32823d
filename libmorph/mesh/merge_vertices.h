#pragma once

#include "libmorph/mesh/mesh_data.h"

namespace morph {

/// What merging took away.
struct Merged {
    Index vertices = 0;
    Index elements = 0; ///< triangles and quads left with fewer than three corners
    Index edges = 0;    ///< of markers, whose ends became one
};

/// Make one vertex of those nearer to each other than a tolerance, so that parts which only touch share
/// vertices. In the order of the file, each vertex goes to the first kept one within the tolerance, or is
/// kept: vertices do not drift along chains. A quad that loses one corner becomes a triangle.
///
/// Vertex fields keep the values of the kept vertex. Linear time for points that do not crowd within the
/// tolerance.
/// @param tolerance  greater than 0, in the unit of the coordinates
Merged merge_vertices(MeshData& mesh, double tolerance);

} // namespace morph
