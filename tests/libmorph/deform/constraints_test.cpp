#include "libmorph/deform/constraints.h"
#include "tests/support/weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace morph;

constexpr Index kControlPoints = 20;
// What areas and lengths are promised to: of the area itself, and of a boundary of length 2.
constexpr double kMeasured = 1e-12;
// What linear constraints are promised to, of sizes around 1.
constexpr double kLinear = 1e-11;

/// Area by the formula of the trapezes, which the library does not use.
double area_of(const Points& polygon)
{
    double area = 0;
    for (Index i = 0; i < polygon.rows(); ++i) {
        const Index next = (i + 1) % static_cast<Index>(polygon.rows());
        area += (polygon(i, 0) - polygon(next, 0)) * (polygon(i, 1) + polygon(next, 1)) / 2;
    }
    return area;
}

/// Height of a polygon at x: from its lowest to its highest crossing.
double thickness_of(const Points& polygon, double x)
{
    double low = 1e300;
    double high = -1e300;
    for (Index i = 0; i < polygon.rows(); ++i) {
        const auto a = polygon.row(i);
        const auto b = polygon.row((i + 1) % polygon.rows());
        if (std::min(a[0], b[0]) > x || std::max(a[0], b[0]) < x)
            continue;
        const double y = a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]);
        low = std::min(low, y);
        high = std::max(high, y);
    }
    return high - low;
}

/// An ellipse of 12 % thickness, its area kept.
ConstraintSet area_kept(Index nodes = 400)
{
    ConstraintSet set;
    set.boundaries.push_back({"body", test::nodes_on(test::ellipse_curve(kControlPoints, 0.12), nodes)});
    set.areas.push_back({"area of body", 0});
    return set;
}

Thickness thickness_at(double x, Bound::Kind kind, double part)
{
    return {"thickness at " + std::to_string(x), 0, {x, 0}, {0, 1}, {kind, part, true}};
}

Points moved_body(const ConstraintSet& set, const ConstrainedMove& move)
{
    return moved(set.boundaries[0].nodes, move.displacements);
}

TEST(Constraints, KeepTheAreaUnderAnyMove)
{
    for (const double scale : {1e-3, 1.0, 1e3}) {
        ConstraintSet set = area_kept();
        set.boundaries[0].nodes.positions *= scale;
        const double area = area_of(set.boundaries[0].nodes.positions);
        for (int trial = 0; trial < 20; ++trial) {
            const Matrix wanted = 0.01 * (trial + 1) * scale * Matrix::Random(kControlPoints, 2);
            const ConstrainedMove move = satisfy_constraints(set, wanted);
            EXPECT_NEAR(area_of(moved_body(set, move)) / area, 1, kMeasured) << trial;
            EXPECT_NEAR(move.measured[0].reached / area, 1, kMeasured) << trial;
            EXPECT_NEAR(move.change, (move.displacements - wanted).norm(), kMeasured * scale) << trial;
            EXPECT_LE(move.iterations, 6) << trial; // the error is squared in each
        }
    }
}

TEST(Constraints, DoNotMindWhichWayABoundaryRuns)
{
    const ConstraintSet set = area_kept();
    ConstraintSet turned = set;
    ControlledPoints& nodes = turned.boundaries[0].nodes;
    nodes.positions = nodes.positions.colwise().reverse().eval();
    nodes.weights = Matrix(Matrix(nodes.weights).colwise().reverse()).sparseView();
    const Matrix wanted = 0.05 * Matrix::Random(kControlPoints, 2);
    const ConstrainedMove one = satisfy_constraints(set, wanted);
    const ConstrainedMove other = satisfy_constraints(turned, wanted);
    EXPECT_LE((one.displacements - other.displacements).norm(), kMeasured);
    EXPECT_GT(other.measured[0].reached, 0);
}

// By symmetry the nearest change is radial as well, and of those only none keeps the area.
TEST(Constraints, TakeBackWhatBlowsUpACircle)
{
    ConstraintSet set;
    const Curve circle = test::ellipse_curve(12, 1);
    set.boundaries.push_back({"circle", test::nodes_on(circle, 240)});
    set.areas.push_back({"area", 0});
    const ConstrainedMove move = satisfy_constraints(set, 0.3 * circle.definition().control_points);
    EXPECT_LE(move.displacements.norm(), kMeasured);
    EXPECT_TRUE(move.measured[0].active);
}

/// Of moves that keep the area to rounding, made by scaling the moved control points about their middle, none
/// is nearer.
TEST(Constraints, FindTheNearestMoveThatKeepsTheArea)
{
    const ConstraintSet set = area_kept();
    const Matrix P = test::ellipse_curve(kControlPoints, 0.12).definition().control_points;
    const Matrix wanted = 0.1 * Matrix::Random(kControlPoints, 2);
    const ConstrainedMove move = satisfy_constraints(set, wanted);
    const double area = area_of(set.boundaries[0].nodes.positions);
    for (int trial = 0; trial < 100; ++trial) {
        const Matrix other = P + move.displacements + 1e-3 * Matrix::Random(kControlPoints, 2);
        const double now = area_of(moved(set.boundaries[0].nodes, other - P));
        const Matrix scaled = std::sqrt(area / now) * other - P;
        EXPECT_GT((scaled - wanted).norm(), move.change) << trial;
    }
}

TEST(Constraints, ChangeNothingThatSatisfiesThemAlready)
{
    ConstraintSet set = area_kept();
    set.areas.clear();
    set.thicknesses.push_back(thickness_at(0.3, Bound::Kind::at_least, 0.5));
    const Matrix wanted = 0.02 * Matrix::Random(kControlPoints, 2);
    const ConstrainedMove move = satisfy_constraints(set, wanted);
    EXPECT_EQ(move.displacements, wanted);
    EXPECT_FALSE(move.measured[0].active);
    EXPECT_GT(move.measured[0].reached, move.measured[0].bound);
}

TEST(Constraints, HoldTenThicknessesAndTheArea)
{
    for (const Bound::Kind kind : {Bound::Kind::equal, Bound::Kind::at_least})
        for (int trial = 0; trial < 10; ++trial) {
            ConstraintSet set = area_kept();
            for (int i = 0; i < 10; ++i)
                set.thicknesses.push_back(thickness_at(-0.8 + 0.17 * i, kind, 0.95));
            const Matrix wanted = 0.03 * Matrix::Random(kControlPoints, 2);
            const ConstrainedMove move = satisfy_constraints(set, wanted);
            const Points body = moved_body(set, move);
            const Points& rest = set.boundaries[0].nodes.positions;
            EXPECT_NEAR(area_of(body) / area_of(rest), 1, kMeasured);
            for (const Thickness& t : set.thicknesses) {
                const double over = thickness_of(body, t.at.x()) - 0.95 * thickness_of(rest, t.at.x());
                EXPECT_GE(over, -2 * kMeasured) << t.name;
                EXPECT_LE(kind == Bound::Kind::equal ? over : 0, 2 * kMeasured) << t.name;
            }
        }
}

TEST(Constraints, TellWhichThicknessesHoldBack)
{
    ConstraintSet set = area_kept();
    set.areas.clear();
    set.thicknesses = {thickness_at(-0.5, Bound::Kind::at_least, 0.9),
                       thickness_at(0.5, Bound::Kind::at_least, 0.9)};
    Matrix wanted = Matrix::Zero(kControlPoints, 2);
    for (Index k = 0; k < kControlPoints; ++k) // squeeze the right half
        if (const double x = std::cos(2 * std::numbers::pi * k / kControlPoints); x > 0.2)
            wanted(k, 1) = -0.05 * std::sin(2 * std::numbers::pi * k / kControlPoints);
    const ConstrainedMove move = satisfy_constraints(set, wanted);
    EXPECT_FALSE(move.measured[0].active);
    EXPECT_TRUE(move.measured[1].active);
    EXPECT_LT(move.measured[1].wanted, move.measured[1].bound);
    EXPECT_NEAR(move.measured[1].reached, 0.9 * move.measured[1].undisplaced, 2 * kMeasured);
    EXPECT_NEAR(move.measured[1].bound, 0.9 * move.measured[1].undisplaced, 1e-15);
}

TEST(Constraints, AreReportedInTheOrderOfTheSet)
{
    ConstraintSet set = area_kept();
    set.thicknesses = {thickness_at(-0.5, Bound::Kind::at_least, 0.5),
                       thickness_at(0.5, Bound::Kind::equal, 0.9)};
    const ConstrainedMove move = satisfy_constraints(set, 0.01 * Matrix::Random(kControlPoints, 2));
    ASSERT_EQ(move.measured.size(), 3U);
    EXPECT_EQ(move.measured[0].name, "area of body");
    EXPECT_EQ(move.measured[1].name, set.thicknesses[0].name);
    EXPECT_FALSE(move.measured[1].active);
    EXPECT_EQ(move.measured[2].name, set.thicknesses[1].name);
    EXPECT_TRUE(move.measured[2].active);
}

TEST(Constraints, MoveFixedPointsExactlyAsTold)
{
    ConstraintSet set = area_kept();
    const ControlledPoints& body = set.boundaries[0].nodes;
    ControlledPoints two{body.positions({10, 200}, Eigen::all), {2, kControlPoints}};
    two.weights = Matrix(Matrix(body.weights)({10, 200}, Eigen::all)).sparseView();
    Matrix told(2, 2);
    told << 0.05, -0.02, 0, 0.01;
    set.fixed.push_back({"pulled", two, told});
    const ConstrainedMove move = satisfy_constraints(set, 0.05 * Matrix::Random(kControlPoints, 2));
    EXPECT_LE((two.weights * move.displacements - told).norm(), kLinear);
    EXPECT_NEAR(area_of(moved_body(set, move)) / area_of(body.positions), 1, kMeasured);

    set.fixed[0].displacements = {};
    const ConstrainedMove still = satisfy_constraints(set, 0.05 * Matrix::Random(kControlPoints, 2));
    EXPECT_LE((two.weights * still.displacements).norm(), kLinear);
}

// Without anything else the nearest tied displacement is the mean, the nearest symmetric one the mean of a
// displacement and the other's image.
TEST(Constraints, TieAndMirrorControlPointsByTheirMean)
{
    ConstraintSet set;
    set.ties.push_back({"tie", {0, 3, 5}});
    set.symmetries.push_back({"symmetry", {{1, 2}, {4, 4}}, {0, 2, 0}});
    const Matrix wanted = Matrix::Random(7, 2);
    const Matrix D = satisfy_constraints(set, wanted).displacements;
    const Eigen::RowVector2d mean = (wanted.row(0) + wanted.row(3) + wanted.row(5)) / 3;
    for (const Index k : {0, 3, 5})
        EXPECT_LE((D.row(k) - mean).norm(), 1e-15) << k;
    const Eigen::RowVector2d mirrored((wanted(1, 0) + wanted(2, 0)) / 2, (wanted(1, 1) - wanted(2, 1)) / 2);
    EXPECT_LE((D.row(1) - mirrored).norm(), 1e-15);
    EXPECT_LE((D.row(2) - Eigen::RowVector2d(mirrored.x(), -mirrored.y())).norm(), 1e-15);
    EXPECT_LE((D.row(4) - Eigen::RowVector2d(wanted(4, 0), 0)).norm(), 1e-15);
    EXPECT_EQ(D.row(6), wanted.row(6));
}

TEST(Constraints, KeepAShapeSymmetricWhileItsAreaIsKept)
{
    ConstraintSet set = area_kept();
    Symmetry symmetry{"symmetry", {}, Eigen::Vector3d(0, 1, 0)};
    for (Index k = 0; k <= kControlPoints / 2; ++k)
        symmetry.pairs.push_back({k, (kControlPoints - k) % kControlPoints});
    set.symmetries.push_back(symmetry);
    const ConstrainedMove move = satisfy_constraints(set, 0.05 * Matrix::Random(kControlPoints, 2));
    for (const auto& [i, j] : symmetry.pairs) {
        EXPECT_NEAR(move.displacements(i, 0), move.displacements(j, 0), kLinear);
        EXPECT_NEAR(move.displacements(i, 1), -move.displacements(j, 1), kLinear);
    }
    EXPECT_NEAR(area_of(moved_body(set, move)) / area_of(set.boundaries[0].nodes.positions), 1, kMeasured);
}

TEST(Constraints, LeaveHeldControlPointsAndThoseOfOtherBoundaries)
{
    ConstraintSet set = area_kept();
    ControlledPoints& body = set.boundaries[0].nodes;
    body.weights.conservativeResize(body.weights.rows(), kControlPoints + 2); // two of another boundary
    set.held = {0, 7};
    const Matrix wanted = 0.05 * Matrix::Random(kControlPoints + 2, 2);
    const ConstrainedMove move = satisfy_constraints(set, wanted);
    for (const Index k : {0, 7, kControlPoints, kControlPoints + 1})
        EXPECT_EQ(move.displacements.row(k), wanted.row(k)) << k;
    EXPECT_NEAR(area_of(moved_body(set, move)) / area_of(body.positions), 1, kMeasured);
}

TEST(Constraints, ReckonWithWhatHeldControlPointsMove)
{
    ConstraintSet set = area_kept();
    const ControlledPoints& body = set.boundaries[0].nodes;
    const ControlledPoints point{body.positions.row(30), body.weights.middleRows(30, 1)};
    set.fixed.push_back({"point", point, {}});
    set.held = {static_cast<Index>(point.weights.innerIndexPtr()[1]), 10};
    set.ties.push_back({"tie", {10, 12}});
    const Matrix wanted = 0.05 * Matrix::Random(kControlPoints, 2);
    const ConstrainedMove move = satisfy_constraints(set, wanted);
    for (const Index k : set.held)
        EXPECT_EQ(move.displacements.row(k), wanted.row(k)) << k;
    EXPECT_LE((point.weights * move.displacements).norm(), kLinear);
    EXPECT_LE((move.displacements.row(12) - wanted.row(10)).norm(), kLinear);
}

TEST(Constraints, BoundDistancesInSpace)
{
    ConstraintSet set;
    ControlledPoints ends{Points::Zero(2, 3), {2, 4}};
    ends.positions << 0, 0, 0, 1, 2, 2;
    ends.weights = test::sparse(test::random_weights(2, 4)).values;
    set.distances.push_back({"spar", ends, {Bound::Kind::equal, 3.5, false}});
    const ConstrainedMove move = satisfy_constraints(set, 0.1 * Matrix::Random(4, 3));
    const Points reached = moved(ends, move.displacements);
    EXPECT_NEAR((reached.row(1) - reached.row(0)).norm(), 3.5, 3 * kMeasured);
    EXPECT_NEAR(move.measured[0].undisplaced, 3, kMeasured);
}

TEST(Constraints, AreTheSameFromDenseAndSparseWeights)
{
    const ControlledPoints body = test::nodes_on(test::ellipse_curve(kControlPoints, 0.12), 100);
    const SparseWeights sparse{{}, body.weights};
    const Weights dense{{}, body.weights};
    std::vector<Index> vertices(100);
    for (Index i = 0; i < 100; ++i)
        vertices[static_cast<std::size_t>(i)] = i;
    const auto solve = [&](WeightsView weights) {
        ConstraintSet set;
        set.boundaries.push_back({"body", controlled_vertices(weights, body.positions, vertices)});
        set.areas.push_back({"area", 0});
        return satisfy_constraints(set, Matrix::Constant(kControlPoints, 2, 0.1)).displacements;
    };
    EXPECT_EQ(solve(sparse), solve(dense));
}

} // namespace
