#include "libmorph/basis/fit.h"

#include "libmorph/basis/closest.h"
#include "libmorph/basis/least_squares.h"
#include "libmorph/core/error.h"
#include "tests/support/curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace morph;
using test::wobbly_curve;

/// NACA 0012 with a sharp trailing edge at (1, 0), chord 1, nodes clustered at both edges.
Points2 airfoil(Index nodes)
{
    Points2 points(nodes, 2);
    for (Index i = 0; i < nodes; ++i) {
        const double angle = 2 * std::numbers::pi * i / nodes;
        const double x = 0.5 + 0.5 * std::cos(angle);
        const double half = 0.6 * (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x -
                                   0.1036 * x * x * x * x);
        points.row(i) << x, (angle < std::numbers::pi ? half : -half);
    }
    return points;
}

Points2 circle(Index nodes)
{
    Points2 points(nodes, 2);
    for (Index i = 0; i < nodes; ++i)
        points.row(i) << std::cos(2 * std::numbers::pi * i / nodes),
            std::sin(2 * std::numbers::pi * i / nodes);
    return points;
}

/// A box with sides of 4 and 1, @p side nodes on each of its sides.
Points2 box(Index side)
{
    Points2 points(4 * side, 2);
    for (Index k = 0; k < side; ++k) {
        const double s = static_cast<double>(k) / side;
        points.row(k) << 4 * s, 0;
        points.row(side + k) << 4, s;
        points.row(2 * side + k) << 4 - 4 * s, 1;
        points.row(3 * side + k) << 0, 1 - s;
    }
    return points;
}

/// How often the curvature changes its sign along a curve.
int inflections(const Curve& curve)
{
    int changes = 0;
    double last = 0;
    for (int i = 0; i < 2000; ++i) {
        const auto d = curve.derivatives((i + 0.5) / 2000, 2);
        const double bend = d[1].x() * d[2].y() - d[1].y() * d[2].x();
        changes += bend * last < 0 ? 1 : 0;
        last = bend;
    }
    return changes;
}

std::string message_of(const Points2& nodes, bool closed, const FitSettings& settings)
{
    try {
        fit_curve(nodes, closed, settings);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(LeastSquaresPoints, GiveBackTheCurveThePointsWereTakenFrom)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree)
        for (const bool closed : {false, true})
            for (const bool rational : {false, true}) {
                const Curve curve(wobbly_curve(degree, degree + 9, closed, rational, 41));
                constexpr Index count = 300;
                Points2 points(count, 2);
                std::vector<double> u;
                for (Index i = 0; i < count; ++i) {
                    u.push_back(closed ? static_cast<double>(i) / count
                                       : static_cast<double>(i) / (count - 1));
                    points.row(i) = curve.point(u.back());
                }
                const std::vector<Index> ends =
                    closed ? std::vector<Index>{} : std::vector<Index>{0, count - 1};
                const Points2 found = least_squares_points(curve, points, u, ends);
                // The B-spline basis of degree 7 has a condition number below 1e3.
                EXPECT_LE((found - curve.definition().control_points).norm(), 1e-12) << "degree " << degree;
            }
}

TEST(LeastSquaresPoints, RefuseParametersThatLeaveAControlPointLoose)
{
    const Curve curve(wobbly_curve(3, 10, true, false, 41));
    const std::vector<double> u(50, 0.2);
    EXPECT_THROW(least_squares_points(curve, Points2::Ones(50, 2), u, {}), InputError);
}

TEST(FindCorners, TellsATrailingEdgeFromALeadingEdge)
{
    for (const Index nodes : {40, 200, 2000})
        EXPECT_EQ(find_corners(airfoil(nodes), true, 30), std::vector<Index>{0}) << nodes << " nodes";
    EXPECT_TRUE(find_corners(circle(10), true, 30).empty()) << "36 degrees at each node, but evenly";
    EXPECT_EQ(find_corners(box(5), true, 30), (std::vector<Index>{0, 5, 10, 15}));
}

TEST(FitCurve, KeepsTheSharpTrailingEdgeOfAnAirfoilExactly)
{
    const Points2 nodes = airfoil(200);
    const CurveFit fit = fit_curve(nodes, true, {});
    const Curve curve(fit.curve);
    EXPECT_EQ(fit.corners, std::vector<Index>{0});
    EXPECT_EQ(curve.corners(), std::vector<double>{0.0});
    EXPECT_EQ(curve.point(0), nodes.row(0).transpose());
    EXPECT_EQ(curve.control_point_count(), 12);
    EXPECT_LE(fit.max_distance, 2e-3);
    EXPECT_LE(fit.mean_distance, fit.max_distance);
    EXPECT_EQ(inflections(curve), 0) << "no wiggles";
}

TEST(FitCurve, ComesNearerWithMoreControlPoints)
{
    const auto distance = [](const Points2& nodes, Index control_points) {
        FitSettings settings;
        settings.control_points = control_points;
        return fit_curve(nodes, true, settings).max_distance;
    };
    // A cubic comes nearer with the fourth power of the spacing of its knots; two thirds of the rate are
    // asked.
    EXPECT_LE(distance(airfoil(400), 24), distance(airfoil(400), 12) / 6);
    EXPECT_LE(distance(circle(400), 20), distance(circle(400), 10) / 6);
    EXPECT_LE(distance(circle(400), 40), distance(circle(400), 20) / 6);
}

TEST(FitCurve, FitsABoxExactlyWithItsFourCorners)
{
    for (const int degree : {1, 2, 3, 5}) {
        FitSettings settings;
        settings.degree = degree;
        settings.control_points = 4 * degree;
        const CurveFit fit = fit_curve(box(10), true, settings);
        EXPECT_EQ(fit.corners.size(), 4U);
        EXPECT_EQ(Curve(fit.curve).corners().size(), 4U);
        EXPECT_LE(fit.max_distance, 1e-13) << "degree " << degree;
    }
}

TEST(FitCurve, KeepsABluntEndOfASingleEdgeStraight)
{
    Points2 nodes(61, 2); // half a circle, closed by one edge along the y axis
    for (Index i = 0; i <= 60; ++i) {
        const double angle = std::numbers::pi * (i / 60.0 - 0.5);
        nodes.row(i) << std::cos(angle), std::sin(angle);
    }
    const CurveFit fit = fit_curve(nodes, true, {});
    EXPECT_EQ(fit.corners, (std::vector<Index>{0, 60}));
    EXPECT_LE(fit.max_distance, 1e-3);
    const Curve curve(fit.curve);
    for (const double y : {-0.9, 0.0, 0.5})
        EXPECT_LE(closest_parameter(curve, {0, y}).distance, 1e-13);
}

TEST(FitCurve, StartsAndEndsAnOpenCurveAtItsEndNodes)
{
    const Points2 nodes = airfoil(200).topRows(101);
    const CurveFit fit = fit_curve(nodes, false, {});
    const Curve curve(fit.curve);
    EXPECT_TRUE(fit.corners.empty());
    EXPECT_EQ(curve.point(0), nodes.row(0).transpose());
    EXPECT_EQ(curve.point(1), nodes.row(100).transpose());
    EXPECT_LE(fit.max_distance, 2e-4);
    const Points2 bent = box(10).topRows(21);
    const CurveFit corner = fit_curve(bent, false, {});
    EXPECT_EQ(corner.corners, std::vector<Index>{10});
    EXPECT_LE(corner.max_distance, 1e-13);
}

TEST(FitCurve, DoesNotDependOnTheUnitOfLengthOrThePlace)
{
    const Points2 nodes = airfoil(200);
    const CurveFit metres = fit_curve(nodes, true, {});
    for (const double unit : {1e-3, 1e3, 1e6}) {
        const CurveFit other = fit_curve(unit * nodes, true, {});
        EXPECT_NEAR(other.max_distance / unit, metres.max_distance, 1e-6 * metres.max_distance);
        EXPECT_LE((other.curve.control_points / unit - metres.curve.control_points).norm(), 1e-8);
    }
}

TEST(FitCurve, InterpolatesWhenThereAreAsManyControlPointsAsNodes)
{
    FitSettings settings;
    for (const Index count : {4, 7, 30}) {
        settings.control_points = count;
        EXPECT_LE(fit_curve(circle(count), true, settings).max_distance, 1e-9) << count;
        const Points2 arc = circle(4 * count).topRows(count);
        EXPECT_LE(fit_curve(arc, false, settings).max_distance, 1e-9) << count;
    }
}

TEST(FitCurve, RefusesBadSettings)
{
    FitSettings settings;
    for (const int degree : {0, 8}) {
        settings.degree = degree;
        EXPECT_THAT(message_of(circle(50), true, settings),
                    testing::HasSubstr("is not supported; expected 1 to 7"));
    }
    settings = {};
    settings.corner_angle = 0;
    EXPECT_THAT(message_of(circle(50), true, settings), testing::HasSubstr("corner angle"));
    settings = {};
    settings.control_points = 3;
    EXPECT_THAT(message_of(circle(50), true, settings), testing::HasSubstr("needs at least 4"));
    settings.control_points = 11;
    EXPECT_THAT(message_of(box(10), true, settings),
                testing::HasSubstr("degree 3 with 4 corner(s) needs at least 12"));
    settings.control_points = 51;
    EXPECT_THAT(message_of(circle(50), true, settings), testing::HasSubstr("the marker has 50 nodes"));
}

TEST(FitCurve, RefusesBadNodes)
{
    EXPECT_THAT(message_of(Points2(0, 2), false, {}), testing::HasSubstr("needs at least 2 nodes"));
    EXPECT_THAT(message_of(Points2::Identity(2, 2), true, {}), testing::HasSubstr("needs at least 3 nodes"));
    Points2 nodes = circle(50);
    nodes.row(20) = nodes.row(19);
    EXPECT_THAT(message_of(nodes, true, {}), testing::HasSubstr("nodes 20 and 21 of the sequence coincide"));
    nodes = circle(50);
    nodes.row(49) = nodes.row(0);
    EXPECT_THAT(message_of(nodes, true, {}), testing::HasSubstr("nodes 50 and 1 of the sequence coincide"));
    nodes(7, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(message_of(nodes, true, {}), testing::HasSubstr("node 8 of the sequence is not finite"));
}

} // namespace
