#include "libmorph/deform/controlled_points.h"

#include "libmorph/core/error.h"

#include <cassert>

namespace morph {

namespace {

using Triplets = std::vector<Eigen::Triplet<double, Index>>;

void require_fit(const WeightsView& weights, Eigen::Index vertices)
{
    if (weights.rows() != vertices)
        throw InputError("the weights are for " + std::to_string(weights.rows()) +
                         " vertices, but there are " + std::to_string(vertices));
}

void require_valid(const MeshPoint& point, Eigen::Index vertices)
{
    if (point.vertices.size() != point.shares.size())
        throw InputError("a point of the mesh has " + std::to_string(point.vertices.size()) +
                         " vertices and " + std::to_string(point.shares.size()) + " shares");
    for (const Index v : point.vertices)
        if (v < 0 || v >= vertices)
            throw InputError("a point names vertex " + std::to_string(v) + ", but the mesh has " +
                             std::to_string(vertices));
}

} // namespace

ControlledPoints controlled_points(WeightsView weights, const Eigen::Ref<const Points>& positions,
                                   const std::vector<MeshPoint>& points)
{
    require_fit(weights, positions.rows());
    const auto count = static_cast<Index>(points.size());
    ControlledPoints carried{Points::Zero(count, 3), {count, weights.cols()}};
    Triplets entries;
    for (Index i = 0; i < count; ++i) {
        const MeshPoint& point = points[static_cast<std::size_t>(i)];
        require_valid(point, positions.rows());
        for (std::size_t j = 0; j < point.vertices.size(); ++j) {
            const double share = point.shares[j];
            carried.positions.row(i) += share * positions.row(point.vertices[j]);
            weights.for_each(point.vertices[j], [&](Eigen::Index k, double weight) {
                if (weight * share != 0)
                    entries.emplace_back(i, static_cast<Index>(k), weight * share);
            });
        }
    }
    carried.weights.setFromTriplets(entries.begin(), entries.end());
    return carried;
}

ControlledPoints controlled_vertices(WeightsView weights, const Eigen::Ref<const Points>& positions,
                                     const std::vector<Index>& vertices)
{
    std::vector<MeshPoint> points;
    points.reserve(vertices.size());
    for (const Index v : vertices)
        points.push_back({{v}, {1.0}});
    return controlled_points(weights, positions, points);
}

Points moved(const ControlledPoints& points, const Matrix& displacements)
{
    assert(displacements.rows() == points.weights.cols());
    Points result = points.positions;
    result.leftCols(displacements.cols()) += points.weights * displacements;
    return result;
}

} // namespace morph
