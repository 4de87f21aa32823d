#include "libmorph/deform/least_distance.h"

#include <gtest/gtest.h>

namespace {

using namespace morph;

// A few products of 12 x 8 matrices with condition numbers under 1000.
constexpr double kSolveTol = 1e-11;

/// What makes a point the nearest: Karush, Kuhn and Tucker's conditions, which are sufficient here.
void expect_nearest(const Eigen::VectorXd& target, const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                    Eigen::Index equations)
{
    const LeastDistance found = least_distance(target, A, b, equations);
    ASSERT_TRUE(found.feasible);
    const Eigen::VectorXd slack = A * found.point - b;
    const Eigen::VectorXd& multipliers = found.multipliers;
    EXPECT_LE((found.point - target - A.transpose() * multipliers).norm(), kSolveTol);
    EXPECT_LE(slack.head(equations).norm(), kSolveTol);
    for (Eigen::Index j = equations; j < b.size(); ++j) {
        EXPECT_GE(slack[j], -kSolveTol) << j;
        EXPECT_GE(multipliers[j], 0) << j;
        EXPECT_LE(std::abs(multipliers[j] * slack[j]), kSolveTol) << j;
    }
}

TEST(LeastDistance, StaysAtATargetThatSatisfiesEverything)
{
    const Eigen::Vector2d target(3, 4);
    const LeastDistance found =
        least_distance(target, Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(1, 1), 0);
    EXPECT_EQ(found.point, target);
    EXPECT_EQ(found.multipliers, Eigen::Vector2d::Zero());
}

TEST(LeastDistance, GoesToTheCornerOfAQuadrant)
{
    const LeastDistance found =
        least_distance(Eigen::Vector2d(-1, -2), Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(1, 1), 0);
    EXPECT_LE((found.point - Eigen::Vector2d(1, 1)).norm(), kSolveTol);
    EXPECT_LE((found.multipliers - Eigen::Vector2d(2, 3)).norm(), kSolveTol);
}

TEST(LeastDistance, LeavesAConditionThatAnotherMakesNeedless)
{
    Eigen::MatrixXd A(2, 2);
    A << 1, 0, 0.25, 0.25;
    const LeastDistance found = least_distance(Eigen::Vector2d(0, 0), A, Eigen::Vector2d(1, 0.9), 0);
    EXPECT_LE((found.point - Eigen::Vector2d(1.8, 1.8)).norm(), kSolveTol);
    EXPECT_EQ(found.multipliers[0], 0);
}

// Conditions that became active and are let go of again are among these trials.
TEST(LeastDistance, SatisfiesTheConditionsOfKarushKuhnAndTucker)
{
    for (int trial = 0; trial < 200; ++trial) {
        const Eigen::Index equations = trial % 4;
        const Eigen::MatrixXd A = Eigen::MatrixXd::Random(12, 8);
        Eigen::VectorXd b = A * Eigen::VectorXd::Random(8); // feasible, some inequalities with room
        b.tail(12 - equations) -= Eigen::VectorXd::Random(12 - equations).cwiseAbs();
        expect_nearest(3 * Eigen::VectorXd::Random(8), A, b, equations);
    }
}

TEST(LeastDistance, AcceptsEquationsThatRepeatEachOther)
{
    Eigen::MatrixXd A = Eigen::MatrixXd::Random(4, 6);
    A.row(1) = 2 * A.row(0);
    A.row(3) = A.row(0) - 3 * A.row(2);
    const Eigen::VectorXd b = A * Eigen::VectorXd::Random(6);
    expect_nearest(Eigen::VectorXd::Random(6), A, b, 4);
}

TEST(LeastDistance, RecognisesContradictions)
{
    const Eigen::Vector2d target(0, 0);
    Eigen::MatrixXd A(2, 2);
    A << 1, 2, -2, -4;
    EXPECT_FALSE(least_distance(target, A, Eigen::Vector2d(1, -1), 2).feasible);
    EXPECT_FALSE(least_distance(target, A, Eigen::Vector2d(1, -1), 1).feasible);
    EXPECT_FALSE(least_distance(target, A, Eigen::Vector2d(1, -1), 0).feasible);
    EXPECT_TRUE(least_distance(target, A, Eigen::Vector2d(1, -3), 0).feasible);
    EXPECT_FALSE(least_distance(target, Eigen::MatrixXd::Zero(1, 2), Eigen::VectorXd::Ones(1), 0).feasible);
}

} // namespace
