#include "libmorph/remap/mass_matrix.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <functional>
#include <string>

namespace morph {

namespace {

constexpr std::size_t kGrain = 8192; // rows

using Row = Eigen::RowVectorXd;

/// Sums over the rows, block by block so that they do not depend on the threads.
Row sum_over_rows(Index rows, Eigen::Index columns,
                  const std::function<Row(Index begin, Index count)>& block_sum)
{
    const auto n = static_cast<std::size_t>(rows);
    std::vector<Row> sums((n + kGrain - 1) / kGrain);
    parallel_for(n, kGrain, [&](std::size_t begin, std::size_t end) {
        sums[begin / kGrain] = block_sum(static_cast<Index>(begin), static_cast<Index>(end - begin));
    });
    Row total = Row::Zero(columns);
    for (const Row& sum : sums)
        total += sum;
    return total;
}

Row dot(const Matrix& A, const Matrix& B)
{
    return sum_over_rows(static_cast<Index>(A.rows()), A.cols(), [&](Index begin, Index count) {
        return Row(A.middleRows(begin, count).cwiseProduct(B.middleRows(begin, count)).colwise().sum());
    });
}

/// Y = Y * diag(y) + X * diag(x), by rows on every core.
void combine(const Row& y, Matrix& Y, const Row& x, const Matrix& X)
{
    parallel_for(static_cast<std::size_t>(Y.rows()), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto r = static_cast<Eigen::Index>(i);
            Y.row(r) = Y.row(r).cwiseProduct(y) + X.row(r).cwiseProduct(x);
        }
    });
}

/// a / b, 0 where b is: a column that has converged to the last bit stays as it is.
Row quotient(const Row& a, const Row& b)
{
    return (b.array() > 0).select(a.array() / b.array(), 0.0).matrix();
}

} // namespace

void MassMatrix::add_row(std::span<const MassEntry> entries)
{
    const Index row = rows();
    double diagonal = 0;
    for (const MassEntry& entry : entries)
        diagonal += entry.column == row ? entry.value : 0;
    entries_.insert(entries_.end(), entries.begin(), entries.end());
    start_.push_back(entries_.size());
    diagonal_.push_back(diagonal);
}

void MassMatrix::multiply(const Matrix& X, Matrix& result) const
{
    parallel_for(diagonal_.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            auto row = result.row(static_cast<Eigen::Index>(i));
            row.setZero();
            for (std::size_t e = start_[i]; e < start_[i + 1]; ++e)
                row += entries_[e].value * X.row(entries_[e].column);
        }
    });
}

Matrix MassMatrix::solve(const Matrix& B, Matrix start) const
{
    constexpr int kMostSteps = 2000;
    constexpr double kConverged = 1e-28; // the square of the residual against that of the right-hand side
    Matrix X = std::move(start);
    Matrix R(B.rows(), B.cols()), Q(B.rows(), B.cols()), Z(B.rows(), B.cols());
    const auto precondition = [&] {
        for (Eigen::Index i = 0; i < R.rows(); ++i)
            Z.row(i) = diagonal_[static_cast<std::size_t>(i)] > 0
                           ? Row(R.row(i) / diagonal_[static_cast<std::size_t>(i)])
                           : Row::Zero(R.cols());
    };
    R = B;
    precondition();
    const Row limit = kConverged * dot(R, Z);
    multiply(X, Q);
    R = B - Q;
    precondition();
    Matrix P = Z;
    Row rz = dot(R, Z);
    const Row one = Row::Ones(B.cols());
    for (int step = 0; (rz.array() > limit.array()).any(); ++step) {
        if (step == kMostSteps)
            throw SolverError("the projection did not converge in " + std::to_string(kMostSteps) +
                              " steps of conjugate gradients");
        multiply(P, Q);
        const Row alpha = quotient(rz, dot(P, Q));
        combine(one, X, alpha, P);
        combine(one, R, -alpha, Q);
        precondition();
        const Row next = dot(R, Z);
        combine(quotient(next, rz), P, one, Z);
        rz = next;
    }
    return X;
}

} // namespace morph
