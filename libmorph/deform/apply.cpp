#include "libmorph/deform/apply.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 16384;

template <int components>
void move_rows(const Matrix& W, const Matrix& D, Eigen::Map<Points>& X, std::size_t begin, std::size_t end)
{
    using Row = Eigen::Matrix<double, 1, components>;
    const auto columns = static_cast<std::size_t>(W.cols());
    for (std::size_t i = begin; i < end; ++i) {
        const double* weight = W.data() + i * columns;
        Row move = Row::Zero();
        for (std::size_t k = 0; k < columns; ++k)
            move += weight[k] * Eigen::Map<const Row>(D.data() + k * components);
        Eigen::Map<Row>(X.data() + 3 * i) += move;
    }
}

void require_fit(const Matrix& W, const Matrix& D, Eigen::Index points)
{
    if (W.rows() != points)
        throw InputError("the weights are for " + std::to_string(W.rows()) + " vertices, but there are " +
                         std::to_string(points));
    if (D.rows() != W.cols() || (D.cols() != 2 && D.cols() != 3))
        throw InputError("the displacements are " + std::to_string(D.rows()) + " x " +
                         std::to_string(D.cols()) + ", but the weights are for " + std::to_string(W.cols()) +
                         " control points in 2 or 3 dimensions");
}

} // namespace

void apply_weights(const Weights& weights, const Matrix& displacements, Eigen::Map<Points> positions)
{
    require_fit(weights.values, displacements, positions.rows());
    const auto move = displacements.cols() == 2 ? move_rows<2> : move_rows<3>;
    parallel_for(static_cast<std::size_t>(positions.rows()), kRowsPerBlock,
                 [&](std::size_t begin, std::size_t end) {
                     move(weights.values, displacements, positions, begin, end);
                 });
}

} // namespace morph
