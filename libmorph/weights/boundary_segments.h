#pragma once

#include "libmorph/geometry/segment_tree.h"
#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/dirichlet_boundary.h"
#include "libmorph/weights/unique_dirichlet_vertices.h"

#include <array>
#include <vector>

namespace morph {

/// Where the held vertices are: h x 3, in the order of UniqueDirichletVertices::vertices().
Points held_points(const DomainView& domain, const UniqueDirichletVertices& vertices);

/// An edge between two held vertices: rows of UniqueDirichletVertices::vertices().
using BoundarySegment = std::array<Index, 2>;

/// The edges along which held values are known. A held vertex without an edge is one from itself to itself.
struct BoundarySegments {
    std::vector<BoundarySegment> moving; ///< DirichletBoundary::moving_edges
    std::vector<BoundarySegment> still;  ///< the rest of the boundary and of the walls
};

/// @throws InputError  a moving edge ends at a vertex that is not held
BoundarySegments boundary_segments(const DomainView& domain, const DirichletBoundary& boundary,
                                   const UniqueDirichletVertices& vertices);

/// The point on held edges nearest to a point: the values there are those of the ends a and b at 1 - t and t.
struct EdgePoint {
    BoundarySegment edge{};
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
class NearestOnSegments {
public:
    /// @param points  h x 3, held_points()
    /// @param edges   at least one
    NearestOnSegments(Points points, std::vector<BoundarySegment> edges);

    /// @param hint  EdgePoint::segment of a point nearby: it only saves time
    EdgePoint nearest(const Eigen::Vector3d& point, Index hint = 0) const;

private:
    Points points_;
    std::vector<BoundarySegment> edges_;
    SegmentTree tree_;
};

} // namespace morph
