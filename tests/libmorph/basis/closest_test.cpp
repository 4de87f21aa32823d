#include "libmorph/basis/closest.h"

#include "libmorph/core/error.h"
#include "tests/support/curves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace {

using namespace morph;
using test::wobbly_curve;

// A node that lies on its curve comes back onto it, relative to the size of the curve.
constexpr double kOnCurve = 1e-13;

double size_of(const Curve& curve)
{
    const Points2& P = curve.definition().control_points;
    return (P.colwise().maxCoeff() - P.colwise().minCoeff()).norm();
}

double brute_force_distance(const Curve& curve, const Eigen::Vector2d& q, int samples)
{
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i <= samples; ++i)
        least = std::min(least, (curve.point(static_cast<double>(i) / samples) - q).norm());
    return least;
}

/// A double spiral band: it goes in and comes back at a distance of @p gap.
CurveDefinition spiral(double gap)
{
    CurveDefinition curve;
    curve.closed = true;
    std::vector<Eigen::Vector2d> points;
    constexpr int steps = 60;
    const auto at = [&](int i, double side) {
        const double angle = 4 * std::numbers::pi * i / steps;
        const double radius = 0.2 + 0.8 * i / steps + side * gap / 2;
        return Eigen::Vector2d(radius * std::cos(angle), radius * std::sin(angle));
    };
    points.reserve(2 * (steps + 1));
    for (int i = 0; i <= steps; ++i)
        points.push_back(at(i, -1));
    for (int i = steps; i >= 0; --i)
        points.push_back(at(i, 1));
    curve.control_points.resize(std::ssize(points), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        curve.control_points.row(static_cast<Eigen::Index>(i)) = points[i];
    return curve;
}

Points2 points_at(const Curve& curve, const std::vector<double>& u)
{
    Points2 points(std::ssize(u), 2);
    for (std::size_t i = 0; i < u.size(); ++i)
        points.row(static_cast<Eigen::Index>(i)) = curve.point(u[i]);
    return points;
}

std::vector<double> even_parameters(int count, bool closed, double shift = 0)
{
    std::vector<double> u;
    for (int i = 0; i < count; ++i)
        u.push_back(closed ? (i + shift) / count : static_cast<double>(i) / (count - 1));
    return u;
}

double cyclic_difference(double a, double b)
{
    const double gap = std::abs(a - b);
    return std::min(gap, std::abs(1 - gap));
}

TEST(ClosestParameter, IsNeverFartherThanAnyOfManySamples)
{
    constexpr int samples = 4000;
    std::mt19937 random(7);
    for (int degree = 1; degree <= kMaxDegree; ++degree)
        for (const bool closed : {false, true})
            for (const bool rational : {false, true}) {
                const Curve curve(wobbly_curve(degree, degree + 6, closed, rational, 100U + random() % 1000));
                for (int trial = 0; trial < 25; ++trial) {
                    const Eigen::Vector2d q =
                        3.0 * Eigen::Vector2d(random() / 4294967296.0 - 0.5, random() / 4294967296.0 - 0.5);
                    const CurveParameter found = closest_parameter(curve, q);
                    const double sampled = brute_force_distance(curve, q, samples);
                    EXPECT_LE(found.distance, sampled + kOnCurve) << "degree " << degree;
                    // Samples lie within half a step of the closest point; speeds here are below 60.
                    EXPECT_GE(found.distance, sampled - 60.0 / samples);
                    EXPECT_NEAR((curve.point(found.u) - q).norm(), found.distance, 1e-15);
                }
            }
}

TEST(ClosestParameter, FindsThePlaceOfAPointOnTheCurveToRoundOff)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree)
        for (const bool closed : {false, true}) {
            const Curve curve(wobbly_curve(degree, degree + 6, closed, degree % 2 == 0, 11));
            for (int i = 0; i < 200; ++i) {
                const Eigen::Vector2d q = curve.point(i / 199.0);
                EXPECT_LE(closest_parameter(curve, q).distance, kOnCurve * size_of(curve)) << degree;
            }
        }
}

TEST(ClosestParameter, SurvivesTheCentreOfACircleAndAPointFarAway)
{
    CurveDefinition circle;
    circle.degree = 2;
    circle.control_points.resize(9, 2);
    circle.control_points << 1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0;
    circle.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
    const double s = std::numbers::sqrt2 / 2;
    circle.weights = {1, s, 1, s, 1, s, 1, s, 1};
    const Curve curve(circle);
    EXPECT_NEAR(closest_parameter(curve, {0, 0}).distance, 1, 1e-14);
    EXPECT_NEAR(closest_parameter(curve, {1e9, 0}).distance, 1e9 - 1, 1e-6);
    EXPECT_THROW(closest_parameter(curve, {0, std::numeric_limits<double>::quiet_NaN()}), InputError);
}

TEST(ClosestParameter, SurvivesACurveThatIsOnePoint)
{
    CurveDefinition point;
    point.control_points = Points2::Constant(5, 2, 3.0);
    EXPECT_NEAR(closest_parameter(Curve(point), {0, 0}).distance, std::sqrt(18.0), 1e-14);
}

TEST(ClosestParameter, DoesNotDependOnTheUnitOfLength)
{
    const CurveDefinition metres = wobbly_curve(3, 12, true, true, 21);
    for (const double unit : {1e-6, 1e3, 1e8}) {
        CurveDefinition other = metres;
        other.control_points *= unit;
        for (const Eigen::Vector2d& q : {Eigen::Vector2d(0.3, 0.1), Eigen::Vector2d(-2.0, 1.0)}) {
            const CurveParameter a = closest_parameter(Curve(metres), q);
            const CurveParameter b = closest_parameter(Curve(other), unit * q);
            EXPECT_NEAR(a.u, b.u, 1e-12);
            EXPECT_NEAR(a.distance, b.distance / unit, 1e-13);
        }
    }
}

TEST(NodeParameters, ReturnTheParametersTheNodesWereMadeFrom)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree)
        for (const bool closed : {false, true})
            for (const bool reversed : {false, true}) {
                const Curve curve(wobbly_curve(degree, degree + 8, closed, degree > 4, 31));
                std::vector<double> u = even_parameters(150, closed);
                if (reversed)
                    std::reverse(u.begin(), u.end());
                const Points2 nodes = points_at(curve, u);
                const auto found = node_parameters(curve, nodes, closed);
                for (std::size_t i = 0; i < u.size(); ++i) {
                    EXPECT_LE(cyclic_difference(found[i].u, u[i]), 1e-12)
                        << "degree " << degree << " node " << i;
                    EXPECT_LE(found[i].distance, kOnCurve * size_of(curve));
                }
            }
}

TEST(NodeParameters, StayOnTheirBranchWhereTheCurveNearlyTouchesItself)
{
    for (const double gap : {1e-2, 1e-4, 1e-7}) {
        const Curve curve(spiral(gap));
        const std::vector<double> u = even_parameters(600, true, 0.3);
        Points2 nodes = points_at(curve, u);
        // Every node is moved across, so that most lie nearer to the other branch than to their own.
        for (std::size_t i = 0; i < u.size(); ++i) {
            const Eigen::Vector2d tangent = curve.derivatives(u[i], 1)[1].normalized();
            nodes.row(static_cast<Eigen::Index>(i)) +=
                0.7 * gap * Eigen::RowVector2d(-tangent.y(), tangent.x());
        }
        const auto found = node_parameters(curve, nodes, true);
        for (std::size_t i = 0; i < u.size(); ++i)
            EXPECT_LE(cyclic_difference(found[i].u, u[i]), 5e-3) << "gap " << gap << ", node " << i;
    }
}

TEST(NodeParameters, AreExactAtCornersAndEnds)
{
    CurveDefinition definition = wobbly_curve(3, 9, true, false, 4);
    definition.knots = {0, 0.1, 0.3, 0.4, 0.4, 0.4, 0.8, 1, 1, 1};
    const Curve closed(definition);
    const auto corner = node_parameters(closed, points_at(closed, {0.0, 0.2, 0.4, 0.6, 0.9}), true);
    EXPECT_EQ(corner[0].u, 0);
    EXPECT_EQ(corner[2].u, 0.4);
    const Curve open(wobbly_curve(3, 9, false, true, 4));
    const auto ends = node_parameters(open, points_at(open, {1.0, 0.5, 0.0}), false);
    EXPECT_EQ(ends[0].u, 1);
    EXPECT_EQ(ends[2].u, 0);
}

TEST(NodeParameters, AcceptALoopOnAnOpenCurveWhoseEndsMeet)
{
    CurveDefinition definition = wobbly_curve(3, 12, false, false, 6);
    definition.control_points.row(11) = definition.control_points.row(0);
    const Curve curve(definition);
    const std::vector<double> u = even_parameters(80, true, 0.5);
    const auto found = node_parameters(curve, points_at(curve, u), true);
    for (std::size_t i = 0; i < u.size(); ++i)
        EXPECT_NEAR(found[i].u, u[i], 1e-12);
}

TEST(NodeParameters, RefuseWhatCannotBePlaced)
{
    const Curve open(wobbly_curve(3, 9, false, false, 4));
    EXPECT_THROW(node_parameters(open, points_at(open, {0.0, 0.5, 1.0}), true), InputError);
    EXPECT_THROW(node_parameters(open, Points2(0, 2), false), InputError);
    Points2 nodes = points_at(open, {0.0, 0.5, 1.0});
    nodes(1, 0) = std::numeric_limits<double>::infinity();
    EXPECT_THROW(node_parameters(open, nodes, false), InputError);
}

} // namespace
