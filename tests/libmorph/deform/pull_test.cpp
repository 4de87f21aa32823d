#include "libmorph/core/error.h"
#include "libmorph/deform/pull.h"
#include "tests/support/errors.h"
#include "tests/support/weights.h"

#include <Eigen/SVD>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using ::testing::HasSubstr;

// The weights below have condition numbers under 100.
constexpr double kSolveTol = 1e-12;

/// Points with weights of their own for each control point, at the origin.
ControlledPoints random_points(Index count, Index control_points)
{
    const Weights weights = test::random_weights(count, control_points);
    return {Points::Zero(count, 3), test::sparse(weights).values};
}

Matrix pseudo_inverse(const Matrix& W)
{
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(W, Eigen::ComputeThinU | Eigen::ComputeThinV);
    return svd.matrixV() * svd.singularValues().cwiseInverse().asDiagonal() * svd.matrixU().transpose();
}

TEST(PullPoints, ReachesThePointsWithTheSmallestChange)
{
    const ControlledPoints points = random_points(3, 11);
    for (const int components : {2, 3}) {
        const Matrix wanted = Matrix::Random(3, components);
        const Matrix given = Matrix::Random(11, components);
        const Pulled pulled = pull_points(points, wanted, given);

        const Matrix reached = points.weights * pulled.displacements;
        EXPECT_LE((reached - wanted).norm(), kSolveTol);
        EXPECT_LE(pulled.residual.norm(), kSolveTol);
        EXPECT_EQ(pulled.rank, 3);
        const Matrix smallest = pseudo_inverse(points.weights) * (wanted - points.weights * given);
        EXPECT_LE((pulled.displacements - given - smallest).norm(), kSolveTol);
    }
}

TEST(PullPoints, ComesNearestWhenThereAreMorePointsThanControlPoints)
{
    const ControlledPoints points = random_points(12, 5);
    const Matrix wanted = Matrix::Random(12, 2);
    const Pulled pulled = pull_points(points, wanted, Matrix::Zero(5, 2));
    const Matrix missed = wanted - points.weights * pulled.displacements;
    EXPECT_GT(missed.norm(), 0.1);
    EXPECT_LE((pulled.residual - missed).norm(), kSolveTol);
    EXPECT_LE((points.weights.transpose() * missed).norm(), kSolveTol);
    EXPECT_LE((pulled.displacements - pseudo_inverse(points.weights) * wanted).norm(), kSolveTol);
}

TEST(PullPoints, MeetsContradictingWishesHalfway)
{
    ControlledPoints points = random_points(1, 4);
    const Matrix row = points.weights;
    points.weights = row.replicate(2, 1).sparseView();
    points.positions = Points::Zero(2, 3);
    Matrix wanted(2, 2);
    wanted << 1, 0, 0, 1;
    const Pulled pulled = pull_points(points, wanted, Matrix::Zero(4, 2));
    Matrix half(2, 2);
    half << 0.5, -0.5, -0.5, 0.5;
    EXPECT_LE((pulled.residual - half).norm(), kSolveTol);
    EXPECT_EQ(pulled.rank, 1);
}

/// Two points whose weights differ by @p difference in one control point.
ControlledPoints close_points(double difference)
{
    ControlledPoints points = random_points(1, 4);
    Matrix W = Matrix(points.weights).replicate(2, 1);
    W(1, 2) += difference;
    return {Points::Zero(2, 3), W.sparseView()};
}

TEST(PullPoints, PullsCloseNeighboursApartButNotTheSamePoint)
{
    Matrix wanted(2, 2);
    wanted << 1, 0, 0, 1;
    const Pulled apart = pull_points(close_points(1e-4), wanted, Matrix::Zero(4, 2));
    EXPECT_LE(apart.residual.norm(), 1e-10); // by a change of some 1e4
    EXPECT_EQ(apart.rank, 2);
    const Pulled same = pull_points(close_points(1e-14), wanted, Matrix::Zero(4, 2));
    EXPECT_LE(same.displacements.norm(), 10);
    EXPECT_EQ(same.rank, 1);
}

TEST(PullPoints, LeavesHeldControlPointsAndThoseThatMoveNothing)
{
    ControlledPoints points = random_points(2, 8);
    Matrix W = points.weights;
    W.col(6).setZero();
    points.weights = W.sparseView();
    const Matrix given = Matrix::Random(8, 2);
    const Matrix wanted = Matrix::Random(2, 2);
    const Pulled pulled = pull_points(points, wanted, given, {0, 3});
    for (const Index k : {0, 3, 6})
        EXPECT_EQ(pulled.displacements.row(k), given.row(k)) << k;
    EXPECT_LE((points.weights * pulled.displacements - wanted).norm(), kSolveTol);
}

TEST(PullPoints, ReportsWhatNothingCanReach)
{
    const ControlledPoints points = random_points(2, 3);
    const Matrix wanted = Matrix::Random(2, 2);
    const Pulled pulled = pull_points(points, wanted, Matrix::Zero(3, 2), {0, 1, 2});
    EXPECT_EQ(pulled.residual, wanted);
    EXPECT_EQ(pulled.displacements, Matrix::Zero(3, 2));
    EXPECT_EQ(pulled.rank, 0);
}

TEST(PullPoints, RefusesWhatDoesNotFit)
{
    const ControlledPoints points = random_points(2, 3);
    const Matrix wanted = Matrix::Zero(2, 2);
    const Matrix given = Matrix::Zero(3, 2);
    EXPECT_THAT(test::message_of([&] { pull_points(points, wanted, Matrix::Zero(4, 2)); }),
                HasSubstr("the displacements are 4 x 2, but the weights are for 3 control points"));
    EXPECT_THAT(test::message_of([&] { pull_points(points, Matrix::Zero(2, 3), given); }),
                HasSubstr("the requested displacements are 2 x 3, but there are 2 points in 2 dimensions"));
    EXPECT_THAT(test::message_of([&] { pull_points(points, wanted, given, {3}); }),
                HasSubstr("control point 3 is held, but there are 3"));
    EXPECT_THAT(test::message_of([&] { pull_points(points, wanted * (0.0 / 0.0), given); }),
                HasSubstr("not all finite"));
}

} // namespace
