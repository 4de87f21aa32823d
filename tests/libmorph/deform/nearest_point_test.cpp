#include "libmorph/core/error.h"
#include "libmorph/deform/nearest_point.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace morph;
using ::testing::IsEmpty;

// The steps end below 1e-9 and the error is then their square; conditions are met to 1e-13.
constexpr double kFound = 1e-12;

/// c_j = (y - m_j)^T Q_j (y - m_j) / 2 - r_j: quadrics, the first of them equations.
class Quadrics : public Conditions {
public:
    struct Quadric {
        Eigen::MatrixXd Q;
        Eigen::VectorXd middle;
        double level;
    };

    Quadrics(std::vector<Quadric> quadrics, Eigen::Index equations)
        : quadrics_(std::move(quadrics)), equations_(equations)
    {
    }

    Eigen::Index equations() const override { return equations_; }

    Values at(const Eigen::VectorXd& y) const override
    {
        const auto count = static_cast<Eigen::Index>(quadrics_.size());
        Values result{Eigen::VectorXd(count), Eigen::MatrixXd(count, y.size())};
        for (Eigen::Index j = 0; j < count; ++j) {
            const Quadric& quadric = quadrics_[static_cast<std::size_t>(j)];
            const Eigen::VectorXd from = y - quadric.middle;
            result.values[j] = from.dot(quadric.Q * from) / 2 - quadric.level;
            result.jacobian.row(j) = (quadric.Q * from).transpose();
        }
        return result;
    }

    void add_hessian(const Eigen::VectorXd&, const Eigen::VectorXd& factors,
                     Eigen::MatrixXd& H) const override
    {
        for (std::size_t j = 0; j < quadrics_.size(); ++j)
            H += factors[static_cast<Eigen::Index>(j)] * quadrics_[j].Q;
    }

private:
    std::vector<Quadric> quadrics_;
    Eigen::Index equations_;
};

Quadrics::Quadric circle(double x, double y, double radius)
{
    return {Eigen::Matrix2d::Identity(), Eigen::Vector2d(x, y), radius * radius / 2};
}

TEST(NearestPoint, OfACircleLiesTowardsItsMiddle)
{
    const NearestPoint found = nearest_point(Quadrics({circle(3, 4, 2)}, 1), 2);
    EXPECT_LE((found.y - 0.6 * Eigen::Vector2d(3, 4)).norm(), kFound);
    EXPECT_THAT(found.missed, IsEmpty());
    EXPECT_LE(found.iterations, 8);
}

// Inside of a circle the second derivative is 1 - 3 / 2 along the circle's gradient, not definite; the far
// side of the circle would satisfy the conditions of first order as well.
TEST(NearestPoint, InsideOfACircleIsTheNearSide)
{
    const NearestPoint found = nearest_point(Quadrics({circle(1, 0, 3)}, 1), 2);
    EXPECT_LE((found.y - Eigen::Vector2d(-2, 0)).norm(), kFound);
}

TEST(NearestPoint, IsTheOriginWhenThatSatisfiesTheInequalities)
{
    const NearestPoint found = nearest_point(Quadrics({circle(3, 4, 2)}, 0), 2); // outside of the circle
    EXPECT_EQ(found.y, Eigen::Vector2d::Zero());
    EXPECT_EQ(found.multipliers[0], 0);
    EXPECT_EQ(found.iterations, 1);
}

TEST(NearestPoint, LeavesACircleThatTheOriginLiesIn)
{
    const NearestPoint found = nearest_point(Quadrics({circle(0.5, 0, 2)}, 0), 2);
    EXPECT_LE((found.y - Eigen::Vector2d(-1.5, 0)).norm(), kFound);
    EXPECT_GT(found.multipliers[0], 0);
}

TEST(NearestPoint, OfTwoCirclesIsWhereTheyMeet)
{
    const NearestPoint found = nearest_point(Quadrics({circle(1, 0, 1.5), circle(0, 1, 1.5)}, 2), 2);
    const double meet = (1 - std::sqrt(3.5)) / 2; // 2 y^2 - 2 y + 1 = 1.5^2
    EXPECT_LE((found.y - Eigen::Vector2d(meet, meet)).norm(), kFound);
}

TEST(NearestPoint, NeedsFewStepsBecauseTheirErrorIsSquared)
{
    for (int trial = 0; trial < 100; ++trial) {
        std::vector<Quadrics::Quadric> quadrics;
        for (int j = 0; j < 3; ++j) {
            const Eigen::MatrixXd half = Eigen::MatrixXd::Random(10, 10);
            quadrics.push_back({half + half.transpose(), 2 * Eigen::VectorXd::Random(10), 0});
            const Eigen::VectorXd at = quadrics.back().middle + 0.3 * Eigen::VectorXd::Random(10);
            quadrics.back().level = at.dot(quadrics.back().Q * at) / 20;
        }
        const Quadrics conditions(quadrics, 2);
        const NearestPoint found = nearest_point(conditions, 10);
        if (!found.missed.empty())
            continue; // random quadrics need not meet near the origin
        const Eigen::VectorXd pull = found.reached.jacobian.transpose() * found.multipliers;
        EXPECT_LE((found.y - pull).norm(), 1e-7 * (1 + found.multipliers.norm())) << trial;
        EXPECT_LE(conditions.at(found.y).values.head(2).norm(), kFound) << trial;
        EXPECT_GE(conditions.at(found.y).values[2], -kFound) << trial;
        EXPECT_LE(found.iterations, 40) << trial;
    }
}

TEST(NearestPoint, NamesTheConditionsThatContradictEachOther)
{
    const NearestPoint found =
        nearest_point(Quadrics({circle(5, 0, 1), circle(0, 7, 100), circle(-5, 0, 1)}, 3), 2);
    EXPECT_TRUE(found.contradiction);
    EXPECT_THAT(found.missed, ::testing::Contains(0));
}

/// a_j y - b_j = 0 for one unknown.
class Points1 : public Conditions {
public:
    Points1(Eigen::VectorXd a, Eigen::VectorXd b) : a_(std::move(a)), b_(std::move(b)) {}

    Eigen::Index equations() const override { return a_.size(); }
    Values at(const Eigen::VectorXd& y) const override { return {a_ * y[0] - b_, a_}; }
    void add_hessian(const Eigen::VectorXd&, const Eigen::VectorXd&, Eigen::MatrixXd&) const override {}

private:
    Eigen::VectorXd a_;
    Eigen::VectorXd b_;
};

TEST(NearestPoint, NamesTheMostInvolvedFirst)
{
    const NearestPoint found =
        nearest_point(Points1(Eigen::Vector3d(0.1, 1, 1), Eigen::Vector3d(1, 2, -3)), 1);
    EXPECT_TRUE(found.contradiction);
    EXPECT_THAT(found.missed, ::testing::ElementsAre(2, 1, 0)); // by 2.5, 2.5 and 0.1, but for a little
}

TEST(NearestPoint, AcceptsConditionsThatRepeatEachOtherInAnotherForm)
{
    Quadrics::Quadric same = circle(3, 4, 2);
    same.Q *= 5;
    same.level *= 5;
    const NearestPoint found = nearest_point(Quadrics({circle(3, 4, 2), same}, 2), 2);
    EXPECT_THAT(found.missed, IsEmpty());
    EXPECT_LE((found.y - 0.6 * Eigen::Vector2d(3, 4)).norm(), kFound);
}

TEST(NearestPoint, RefusesToStartWhereAConditionHasNoValue)
{
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(nearest_point(Quadrics({circle(none, 0, 1)}, 1), 2), SolverError);
}

} // namespace
