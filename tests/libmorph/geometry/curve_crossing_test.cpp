#include "libmorph/geometry/curve_crossing.h"

#include "tests/support/curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace morph;
using test::wobbly_curve;

// Places are found on chords that deviate by 1e-10 of the size, which are up to 1e-4 long; along them u
// is taken for linear.
constexpr double kPlace = 1e-7;

CurveDefinition curve_through(int degree, bool closed, const std::vector<std::array<double, 2>>& points)
{
    CurveDefinition curve;
    curve.degree = degree;
    curve.closed = closed;
    curve.control_points.resize(std::ssize(points), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        curve.control_points.row(static_cast<Eigen::Index>(i)) << points[i][0], points[i][1];
    return curve;
}

/// A C whose two tips come as near to each other as @p gap; negative: they cross.
CurveDefinition nearly_closed(double gap)
{
    // The tips end horizontally, one above the other.
    return curve_through(3, false,
                         {{1, gap / 2}, {-1, gap / 2}, {-3, 2}, {-3, -2}, {-1, -gap / 2}, {1, -gap / 2}});
}

/// Does a dense polyline along the curve cross itself? Exact enough where the curve stays clear of itself.
bool polyline_crosses(const Curve& curve, int samples)
{
    std::vector<Eigen::Vector2d> p;
    for (int i = 0; i <= samples; ++i)
        p.push_back(curve.point(static_cast<double>(i) / samples));
    const auto side = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
        return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
    };
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        for (std::size_t j = i + 2; j + 1 < p.size(); ++j)
            if (side(p[i], p[i + 1], p[j]) * side(p[i], p[i + 1], p[j + 1]) < 0 &&
                side(p[j], p[j + 1], p[i]) * side(p[j], p[j + 1], p[i + 1]) < 0)
                return true;
    return false;
}

void expect_place_on(const Curve& a, const Curve& b, const CurveCrossing& crossing)
{
    EXPECT_LE((a.point(crossing.u) - crossing.point).norm(), kPlace);
    EXPECT_LE((b.point(crossing.v) - crossing.point).norm(), kPlace);
}

TEST(FindSelfCrossing, AgreesWithADensePolylineOnRandomCurves)
{
    int crossing = 0;
    int simple = 0;
    for (std::uint32_t seed = 0; seed < 40; ++seed)
        for (const bool closed : {false, true}) {
            CurveDefinition definition =
                wobbly_curve(2 + static_cast<int>(seed % 4), 9, closed, seed % 3 == 0, seed);
            if (seed % 2 == 0) // two neighbours change places, which often makes a loop
                definition.control_points.row(3).swap(definition.control_points.row(5));
            const Curve curve(definition);
            const auto found = find_self_crossing(curve);
            EXPECT_EQ(found.has_value(), polyline_crosses(curve, 400))
                << "seed " << seed << (closed ? " closed" : "");
            if (found) {
                EXPECT_LT(found->u, found->v);
                expect_place_on(curve, curve, *found);
            }
            ++(found ? crossing : simple);
        }
    EXPECT_GE(crossing, 10);
    EXPECT_GE(simple, 10);
}

TEST(FindSelfCrossing, SeesAGapOfAMillionthAndACrossingOfAMillionth)
{
    for (const double gap : {1e-2, 1e-4, 1e-6, 1e-8}) {
        EXPECT_FALSE(find_self_crossing(Curve(nearly_closed(gap)))) << gap;
        const auto found = find_self_crossing(Curve(nearly_closed(-gap)));
        ASSERT_TRUE(found) << gap;
        expect_place_on(Curve(nearly_closed(-gap)), Curve(nearly_closed(-gap)), *found);
    }
}

TEST(FindSelfCrossing, AcceptsSharpCornersAndTheSeam)
{
    // A needle of half a degree at the knot of full multiplicity, where the curve starts.
    CurveDefinition needle =
        curve_through(3, true, {{1, 0}, {0.5, -0.002}, {-0.5, -0.01}, {-0.6, 0.01}, {0.5, 0.002}});
    needle.knots = {0, 0.4, 0.6, 1, 1, 1};
    EXPECT_FALSE(find_self_crossing(Curve(needle)));
    needle.control_points.row(1).swap(needle.control_points.row(4));
    EXPECT_TRUE(find_self_crossing(Curve(needle))) << "a fish tail";
    EXPECT_FALSE(find_self_crossing(Curve(curve_through(1, true, {{0, 0}, {4, 0}, {4, 1}, {0, 1}}))));
}

TEST(FindSelfCrossing, FindsTheCrossingOfABowTieExactly)
{
    const auto found = find_self_crossing(Curve(curve_through(1, true, {{0, 0}, {2, 2}, {2, 0}, {0, 2}})));
    ASSERT_TRUE(found);
    EXPECT_LE((found->point - Eigen::Vector2d(1, 1)).norm(), 1e-14);
    EXPECT_NEAR(found->u, 0.125, 1e-14);
    EXPECT_NEAR(found->v, 0.625, 1e-14);
}

TEST(FindSelfCrossing, RefusesACurveThatRetracesItself)
{
    EXPECT_TRUE(find_self_crossing(Curve(curve_through(1, true, {{0, 0}, {1, 0}, {2, 0}, {1, 0}}))))
        << "a flat polygon";
    EXPECT_TRUE(find_self_crossing(Curve(curve_through(1, false, {{0, 0}, {2, 0}, {1, 0}})))) << "a spike";
    EXPECT_TRUE(
        find_self_crossing(Curve(curve_through(3, true, {{0, 0}, {1, 1}, {2, 1}, {3, 0}, {2, 1}, {1, 1}}))))
        << "there and back on the same arc";
}

TEST(FindSelfCrossing, AllowsAnOpenCurveWhoseEndsMeet)
{
    EXPECT_FALSE(find_self_crossing(Curve(curve_through(3, false, {{0, 0}, {2, 1}, {-2, 1}, {0, 0}}))));
    EXPECT_TRUE(find_self_crossing(Curve(curve_through(3, false, {{0, 0}, {3, 1}, {-2, 1}, {1, 0}}))));
}

TEST(FindSelfCrossing, DoesNotDependOnTheUnitOfLength)
{
    for (const double unit : {1e-6, 1e6}) {
        CurveDefinition clear = nearly_closed(1e-6);
        clear.control_points *= unit;
        EXPECT_FALSE(find_self_crossing(Curve(clear)));
        CurveDefinition crossing = nearly_closed(-1e-6);
        crossing.control_points *= unit;
        EXPECT_TRUE(find_self_crossing(Curve(crossing)));
    }
}

TEST(FindSelfCrossing, SurvivesACurveThatIsOnePoint)
{
    EXPECT_FALSE(find_self_crossing(Curve(curve_through(3, true, {{1, 1}, {1, 1}, {1, 1}, {1, 1}}))));
}

TEST(FindSelfCrossing, AcceptsTheCurvesOfTheThesis)
{
    EXPECT_FALSE(find_self_crossing(Curve(test::thesis_case_1())));
    for (const std::string name : {"case2_curve1_control_points.csv", "case2_curve2_control_points.csv"}) {
        CurveDefinition curve;
        curve.closed = true;
        curve.control_points = test::thesis_points(name);
        EXPECT_FALSE(find_self_crossing(Curve(curve))) << name;
    }
}

TEST(FindCrossing, FindsWhereTwoCurvesMeet)
{
    const CurveDefinition one = wobbly_curve(3, 8, true, true, 1);
    CurveDefinition other = one;
    other.control_points.col(0).array() += 0.5;
    const auto found = find_crossing(Curve(one), Curve(other));
    ASSERT_TRUE(found);
    expect_place_on(Curve(one), Curve(other), *found);
    other.control_points.col(0).array() += 4;
    EXPECT_FALSE(find_crossing(Curve(one), Curve(other)));
    other.control_points = 0.1 * one.control_points;
    EXPECT_FALSE(find_crossing(Curve(one), Curve(other))) << "one inside the other";
}

TEST(FindCrossing, AllowsTwoOpenCurvesThatShareTheirEnds)
{
    const CurveDefinition upper = curve_through(3, false, {{1, 0}, {0.5, 0.1}, {0, 0.2}, {0, 0}});
    for (const bool turned : {false, true}) {
        CurveDefinition lower = curve_through(3, false, {{0, 0}, {0, -0.2}, {0.5, -0.1}, {1, 0}});
        if (turned)
            lower.control_points = lower.control_points.colwise().reverse().eval();
        EXPECT_FALSE(find_crossing(Curve(upper), Curve(lower)));
        lower.control_points.col(1) *= -0.9; // now on the same side and below
        EXPECT_FALSE(find_crossing(Curve(upper), Curve(lower)));
        EXPECT_TRUE(find_crossing(Curve(upper), Curve(upper))) << "the same curve twice";
    }
}

} // namespace
