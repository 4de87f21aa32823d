#include "libmorph/deform/gradient.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <algorithm>
#include <vector>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 16384;
constexpr std::size_t kBlocks = 256; ///< at most, since each has a sum of its own

template <int components>
Matrix sum_over_rows(const WeightsView& weights, const Matrix& gradient, std::size_t begin, std::size_t end)
{
    using Row = Eigen::Matrix<double, 1, components>;
    Matrix sum = Matrix::Zero(weights.cols(), components);
    double* sums = sum.data();
    for (std::size_t i = begin; i < end; ++i) {
        const Row g = Eigen::Map<const Row>(gradient.data() + i * components);
        weights.for_each(static_cast<Eigen::Index>(i), [&](Eigen::Index k, double weight) {
            Eigen::Map<Row>(sums + k * components) += weight * g;
        });
    }
    return sum;
}

void require_fit(const WeightsView& weights, const Matrix& gradient)
{
    if (gradient.rows() != weights.rows() || (gradient.cols() != 2 && gradient.cols() != 3))
        throw InputError("the gradient is " + std::to_string(gradient.rows()) + " x " +
                         std::to_string(gradient.cols()) + ", but the weights are for " +
                         std::to_string(weights.rows()) + " vertices in 2 or 3 dimensions");
}

} // namespace

Matrix control_point_gradient(WeightsView weights, const Matrix& gradient)
{
    require_fit(weights, gradient);
    const auto sum_of = gradient.cols() == 2 ? sum_over_rows<2> : sum_over_rows<3>;
    const auto rows = static_cast<std::size_t>(gradient.rows());
    const std::size_t grain = std::max(kRowsPerBlock, rows / kBlocks + 1);
    std::vector<Matrix> sums(rows / grain + 1, Matrix::Zero(weights.cols(), gradient.cols()));
    parallel_for(rows, grain, [&](std::size_t begin, std::size_t end) {
        sums[begin / grain] = sum_of(weights, gradient, begin, end);
    });
    for (std::size_t block = 1; block < sums.size(); ++block)
        sums[0] += sums[block];
    return sums[0];
}

} // namespace morph
