#include "libmorph/numerics/stiffness.h"

#include "libmorph/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 8192; // triangles a thread takes at a time

// Half the cotangent of 60 degrees: what an equilateral triangle gives to each of its edges.
constexpr double kEquilateral = 0.5 * std::numbers::inv_sqrt3;

/// Half the cotangent of the angle at @p apex; nothing when the triangle has no positive area.
std::optional<double> half_cotangent(const Eigen::Ref<const Points>& points, Index apex, Index u, Index v)
{
    const double ux = points(u, 0) - points(apex, 0), uy = points(u, 1) - points(apex, 1);
    const double vx = points(v, 0) - points(apex, 0), vy = points(v, 1) - points(apex, 1);
    const double twice_area = ux * vy - uy * vx;
    if (!(twice_area > 0))
        return std::nullopt;
    return 0.5 * (ux * vx + uy * vy) / twice_area;
}

/// Corner of @p triangle that is neither u nor v.
Index far_corner(const std::array<Index, 3>& triangle, Index u, Index v)
{
    return *std::find_if(triangle.begin(), triangle.end(), [=](Index c) { return c != u && c != v; });
}

/// Edge opposite corner k of triangle t.
WeightedEdge edge_of(const Eigen::Ref<const Points>& points, const Triangulation& triangulation,
                     std::size_t t, std::size_t k)
{
    const auto& here = triangulation.corners[t];
    const Index u = here[(k + 1) % 3];
    const Index v = here[(k + 2) % 3];
    const Index other = triangulation.neighbours[t][k];
    const auto mine = half_cotangent(points, here[k], u, v);
    const auto theirs =
        other < 0
            ? std::optional(0.0)
            : half_cotangent(points, far_corner(triangulation.corners[static_cast<std::size_t>(other)], u, v),
                             v, u);
    const double weight = mine.value_or(kEquilateral) + theirs.value_or(kEquilateral);
    return {u, v, std::max(weight, mine && theirs ? 0.0 : kEquilateral)};
}

/// Calls body(t, k) for the edges that triangles [begin, end) own: a shared one has the higher number.
template <typename Body>
void for_owned_edges(const Triangulation& triangulation, std::size_t begin, std::size_t end, const Body& body)
{
    for (std::size_t t = begin; t < end; ++t)
        for (std::size_t k = 0; k < 3; ++k)
            if (triangulation.neighbours[t][k] < static_cast<Index>(t))
                body(t, k);
}

} // namespace

std::vector<WeightedEdge> stiffness_edges(const Eigen::Ref<const Points>& points,
                                          const Triangulation& triangulation)
{
    const std::size_t triangles = triangulation.corners.size();
    std::vector<std::size_t> first(triangles / kRowsPerBlock + 2);
    parallel_for(triangles, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for_owned_edges(triangulation, begin, end,
                        [&](std::size_t, std::size_t) { ++first[begin / kRowsPerBlock + 1]; });
    });
    for (std::size_t block = 1; block < first.size(); ++block)
        first[block] += first[block - 1];
    std::vector<WeightedEdge> edges(first.back());
    parallel_for(triangles, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        std::size_t next = first[begin / kRowsPerBlock];
        for_owned_edges(triangulation, begin, end, [&](std::size_t t, std::size_t k) {
            edges[next++] = edge_of(points, triangulation, t, k);
        });
    });
    return edges;
}

Eigen::SparseMatrix<double> stiffness_matrix(Index vertices, const std::vector<WeightedEdge>& edges)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * edges.size());
    for (const auto& [a, b, weight] : edges) {
        entries.emplace_back(a, b, -weight);
        entries.emplace_back(b, a, -weight);
        entries.emplace_back(a, a, weight);
        entries.emplace_back(b, b, weight);
    }
    Eigen::SparseMatrix<double> K(vertices, vertices);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

} // namespace morph
