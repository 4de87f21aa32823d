#include "libmorph/deform/apply.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <array>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 16384;
constexpr std::size_t kRowsAtOnce = 4; ///< rows
constexpr std::size_t kAhead = 24;     ///< rows: long enough for memory to answer

/// Ask for `kRowsAtOnce` rows from row @p first on, before they are needed: what the processor fetches by
/// itself reaches two thirds of the bandwidth that this does. Always inline, because GCC takes a function
/// that only prefetches for one without effect and drops the call.
[[gnu::always_inline]] inline void prefetch_rows(const Matrix& W, const Eigen::Map<Points>& X,
                                                 std::size_t first)
{
    constexpr std::size_t kLine = 64 / sizeof(double);
    const auto columns = static_cast<std::size_t>(W.cols());
    for (std::size_t k = 0; k < kRowsAtOnce * columns; k += kLine)
        __builtin_prefetch(W.data() + first * columns + k);
    for (std::size_t k = 0; k < kRowsAtOnce * 3; k += kLine)
        __builtin_prefetch(X.data() + first * 3 + k, 1);
}

/// Move `rows` rows from row @p first on. Several rows at a time keep several sums going, where one alone
/// would wait for each of its additions; the order of the sum in a row is the same either way.
template <int components, std::size_t rows>
void move_some(const Matrix& W, const Matrix& D, Eigen::Map<Points>& X, std::size_t first)
{
    using Row = Eigen::Matrix<double, 1, components>;
    const auto columns = static_cast<std::size_t>(W.cols());
    const double* weight = W.data() + first * columns;
    std::array<Row, rows> move;
    move.fill(Row::Zero());
    for (std::size_t k = 0; k < columns; ++k) {
        const Row d = Eigen::Map<const Row>(D.data() + k * components);
        for (std::size_t r = 0; r < rows; ++r)
            move[r] += weight[r * columns + k] * d;
    }
    for (std::size_t r = 0; r < rows; ++r)
        Eigen::Map<Row>(X.data() + 3 * (first + r)) += move[r];
}

template <int components>
void move_rows(const Matrix& W, const Matrix& D, Eigen::Map<Points>& X, std::size_t begin, std::size_t end)
{
    const auto last = static_cast<std::size_t>(W.rows());
    std::size_t i = begin;
    for (; i + kRowsAtOnce <= end; i += kRowsAtOnce) {
        if (i + kAhead + kRowsAtOnce <= last)
            prefetch_rows(W, X, i + kAhead);
        move_some<components, kRowsAtOnce>(W, D, X, i);
    }
    for (; i < end; ++i)
        move_some<components, 1>(W, D, X, i);
}

template <typename Weight>
void require_fit(const Weight& W, const Matrix& D, Eigen::Index points)
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

void apply_weights(const SparseWeights& weights, const Matrix& displacements, Eigen::Map<Points> positions)
{
    require_fit(weights.values, displacements, positions.rows());
    parallel_for(
        static_cast<std::size_t>(positions.rows()), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto row = static_cast<Eigen::Index>(i);
                Eigen::RowVector3d move = Eigen::RowVector3d::Zero();
                using Row = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>::InnerIterator;
                for (Row weight(weights.values, row); weight; ++weight)
                    move.head(displacements.cols()) += weight.value() * displacements.row(weight.col());
                positions.row(row) += move;
            }
        });
}

} // namespace morph
