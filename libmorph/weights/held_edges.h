#pragma once

#include "libmorph/geometry/segment_tree.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/held_vertices.h"

#include <array>
#include <vector>

namespace morph {

/// Where the held vertices are: h x 3, in the order of HeldVertices::vertices().
Points held_points(const Mesh& mesh, const HeldVertices& vertices);

/// An edge between two held vertices: rows of HeldVertices::vertices().
using HeldEdge = std::array<Index, 2>;

/// The edges along which held values are known. A held vertex without an edge is one from itself to itself.
struct HeldEdges {
    std::vector<HeldEdge> moving; ///< HeldBoundary::moving_edges
    std::vector<HeldEdge> still;  ///< the rest of the mesh's boundary and of the walls
};

/// @throws InputError  a moving edge ends at a vertex that is not held
HeldEdges held_edges(const Mesh& mesh, const HeldBoundary& held, const HeldVertices& vertices);

/// The point on held edges nearest to a point: the values there are those of the ends a and b at 1 - t and t.
struct EdgePoint {
    HeldEdge edge{};
    double t = 0;
    double distance = 0; ///< length unit of the mesh
    Index segment = 0;   ///< number of the edge: the hint for a point nearby

    template <typename Rows>
    auto value(const Rows& rows) const
    {
        return ((1 - t) * rows.row(edge[0]) + t * rows.row(edge[1])).eval();
    }
};

/// Finds the nearest point of held edges.
class NearestOnEdges {
public:
    /// @param points  h x 3, held_points()
    /// @param edges   at least one
    NearestOnEdges(Points points, std::vector<HeldEdge> edges);

    /// @param hint  EdgePoint::segment of a point nearby: it only saves time
    EdgePoint nearest(double x, double y, Index hint = 0) const;

private:
    Points points_;
    std::vector<HeldEdge> edges_;
    SegmentTree tree_;
};

} // namespace morph
