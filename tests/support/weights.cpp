#include "tests/support/weights.h"

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

} // namespace morph::test
