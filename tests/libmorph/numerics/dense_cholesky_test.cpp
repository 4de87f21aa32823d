#include "libmorph/numerics/dense_cholesky.h"

#include "libmorph/core/error.h"

#include <gtest/gtest.h>

namespace {

using namespace morph;

/// n x n, symmetric, with eigenvalues from 1 on.
Eigen::MatrixXd positive_definite(Index n)
{
    Eigen::MatrixXd A(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            A(i, j) = std::sin(1 + i * j + i);
    return A.transpose() * A + Eigen::MatrixXd::Identity(n, n);
}

TEST(DenseCholesky, SolvesForSeveralColumnsInPlace)
{
    constexpr Index kRows = 40;
    const Eigen::MatrixXd A = positive_definite(kRows);
    Eigen::MatrixXd x(kRows + 2, 3);
    for (Index i = 0; i < x.rows(); ++i)
        x.row(i) << i, 1, std::cos(i);
    Eigen::MatrixXd b = x;
    b.bottomRows(kRows) = A * x.bottomRows(kRows);
    DenseCholesky(A).solve(b.bottomRows(kRows)); // a block: rows are farther apart than the matrix is high
    EXPECT_LE((b - x).cwiseAbs().maxCoeff(), 1e-10); // the condition is some 1e3
}

TEST(DenseCholesky, KnowsItsLeastPivotAndRefusesWhatIsNotPositiveDefinite)
{
    Eigen::MatrixXd A = Eigen::Vector3d(4, 0.25, 9).asDiagonal();
    EXPECT_EQ(DenseCholesky(A).least_pivot(), 0.25);
    A(1, 1) = -1e-9;
    EXPECT_THROW(DenseCholesky{A}, SolverError);
    EXPECT_EQ(DenseCholesky(Eigen::MatrixXd(0, 0)).least_pivot(), 0);
}

} // namespace
