#include "libmorph/weights/boundary_segments.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <set>
#include <string>

namespace morph {

namespace {

BoundarySegment sorted(BoundarySegment edge)
{
    if (edge[1] < edge[0])
        std::swap(edge[0], edge[1]);
    return edge;
}

} // namespace

Points held_points(const DomainView& domain, const UniqueDirichletVertices& vertices)
{
    return domain.positions()(vertices.vertices(), Eigen::all);
}

BoundarySegments boundary_segments(const DomainView& domain, const DirichletBoundary& boundary,
                                   const UniqueDirichletVertices& vertices)
{
    const std::vector<Index> row_of = vertices.rows();
    const auto rows = [&](const std::array<Index, 2>& edge) {
        return BoundarySegment{row_of[static_cast<std::size_t>(edge[0])],
                               row_of[static_cast<std::size_t>(edge[1])]};
    };
    BoundarySegments edges;
    std::set<BoundarySegment> known;
    for (const auto& edge : boundary.moving_edges) {
        edges.moving.push_back(rows(edge));
        known.insert(sorted(edges.moving.back()));
        for (const Index v : edge)
            if (row_of[static_cast<std::size_t>(v)] < 0)
                throw InputError("vertex " + std::to_string(domain.file_vertex(v)) +
                                 " is the end of a moving edge, but it is not held");
    }
    std::vector<std::array<Index, 2>> others = domain.boundary_facets();
    others.insert(others.end(), boundary.fixed_edges.begin(), boundary.fixed_edges.end());
    for (const auto& edge : others)
        if (const BoundarySegment e = rows(edge); e[0] >= 0 && e[1] >= 0 && known.insert(sorted(e)).second)
            edges.still.push_back(e);
    std::vector<bool> has_edge(vertices.vertices().size());
    for (const BoundarySegment& edge : known)
        for (const Index row : edge)
            has_edge[static_cast<std::size_t>(row)] = true;
    for (std::size_t row = 0; row < has_edge.size(); ++row)
        if (!has_edge[row])
            edges.still.push_back({static_cast<Index>(row), static_cast<Index>(row)});
    return edges;
}

NearestOnSegments::NearestOnSegments(Points points, std::vector<BoundarySegment> edges)
    : points_(std::move(points)), edges_(std::move(edges)), tree_(points_, edges_)
{
}

EdgePoint NearestOnSegments::nearest(const Eigen::Vector3d& point, Index hint) const
{
    const SegmentTree::Nearest found = tree_.nearest(point, hint);
    const BoundarySegment& edge = edges_[static_cast<std::size_t>(found.segment)];
    const Eigen::Vector3d a = points_.row(edge[0]).transpose();
    const Eigen::Vector3d along = points_.row(edge[1]).transpose() - a;
    const double length2 = along.squaredNorm();
    const double t = length2 > 0 ? along.dot(point - a) / length2 : 0;
    return {edge, std::clamp(t, 0.0, 1.0), found.distance, found.segment};
}

} // namespace morph
