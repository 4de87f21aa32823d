#include "tests/support/weights.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace morph::test {

namespace {

constexpr Index kInARow = 4;

std::vector<ControlPoint> columns_of(Index count)
{
    std::vector<ControlPoint> columns(static_cast<std::size_t>(count));
    for (std::size_t k = 0; k < columns.size(); ++k)
        columns[k] = {"body", static_cast<Index>(k)};
    return columns;
}

} // namespace

Weights random_weights(Index rows, Index columns)
{
    return {columns_of(columns), Matrix::Random(rows, columns)};
}

SparseWeights random_sparse_weights(Index rows, Index columns)
{
    std::vector<Eigen::Triplet<double>> entries;
    const Matrix values = Matrix::Random(rows, kInARow);
    for (Index i = 0; i < rows; ++i)
        for (Index k = 0; k < kInARow; ++k)
            entries.emplace_back(i, i % (columns - kInARow + 1) + k, values(i, k));
    SparseWeights weights{columns_of(columns), {rows, columns}};
    weights.values.setFromTriplets(entries.begin(), entries.end());
    return weights;
}

SparseWeights sparse(const Weights& weights)
{
    return {weights.columns, weights.values.sparseView()};
}

ControlledPoints nodes_on(const Curve& curve, Index count)
{
    const Points2& P = curve.definition().control_points;
    ControlledPoints nodes{Points::Zero(count, 3), {count, static_cast<Index>(P.rows())}};
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < count; ++i) {
        const BasisRow row = curve.basis(static_cast<double>(i) / count);
        for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
            entries.emplace_back(i, row.control[k], row.value[k]);
    }
    nodes.weights.setFromTriplets(entries.begin(), entries.end());
    nodes.positions.leftCols<2>() = nodes.weights * P;
    return nodes;
}

Curve ellipse_curve(Index control_points, double height)
{
    CurveDefinition curve;
    curve.degree = 3;
    curve.closed = true;
    curve.control_points.resize(control_points, 2);
    for (Index k = 0; k < control_points; ++k) {
        const double angle = 2 * std::numbers::pi * k / control_points;
        curve.control_points.row(k) << std::cos(angle), height * std::sin(angle);
    }
    return Curve(curve);
}

} // namespace morph::test
