#include "libmorph/pipeline/deformer.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/domains.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

// The pipeline as a C++ program uses it.

namespace {

using namespace morph;
using ::testing::HasSubstr;

/// A ring 1 < r < 3 whose inner circle follows a curve of 8 control points.
class RingDeformer : public ::testing::Test {
protected:
    RingDeformer()
    {
        const Curve circle = test::round_curve(0, 0, 1);
        settings.curves = {{.marker = "inner", .curve = circle.definition()}};
        settings.curves[0].displacements = shifted(0.1, -0.05);
        settings.deform.guard = Guard::none;
    }

    /// Displacements that move every control point alike, but for the first, which stays.
    Points2 shifted(double dx, double dy) const
    {
        Points2 D(settings.curves[0].curve.control_points.rows(), 2);
        D.rowwise() = Eigen::RowVector2d(dx, dy);
        D.row(0).setZero();
        return D;
    }

    Points2 turned(double degrees) const
    {
        const Points2& P = settings.curves[0].curve.control_points;
        const Eigen::Matrix2d R = Eigen::Rotation2Dd(degrees * std::numbers::pi / 180).toRotationMatrix();
        return P * R.transpose() - P;
    }

    /// A lattice around the inner circle instead of the curve.
    void take_lattice()
    {
        LatticeSettings lattice;
        lattice.shape.dimension = 2;
        lattice.shape.points = {6, 5, 1};
        lattice.shape.degree = {3, 2, 0};
        lattice.box = {{-1.5, -1.4, 0}, {1.6, 1.5, 0}};
        settings.lattice = lattice;
        settings.curves.clear();
    }

    Index nearest_vertex(double x, double y) const
    {
        Index nearest = 0;
        (rest.rowwise() - Eigen::RowVector3d(x, y, 0)).rowwise().norm().minCoeff(&nearest);
        return nearest;
    }

    const Mesh mesh = build_mesh(test::annulus(1, 3, 60, 10));
    const Points rest = points(mesh);
    MotionSettings settings;
};

TEST_F(RingDeformer, MovesTheBoundaryWithItsCurveAndLeavesTheMeshAlone)
{
    settings.deform.guard = Guard::check;
    const Deformer deformer(mesh, settings);
    const MoveResult moved = deformer.move();
    EXPECT_EQ(points(mesh), rest);
    EXPECT_EQ(&deformer.mesh(), &mesh);
    ASSERT_EQ(moved.fits.size(), 1U);
    EXPECT_LT(moved.fits[0].landing_error, 1e-13);
    for (const Index v : marker_vertices(marker(mesh, "outer")))
        EXPECT_EQ(moved.positions.row(v), rest.row(v));
    EXPECT_EQ(moved.displacements, settings.curves[0].displacements);
    EXPECT_EQ(moved.safe_step->step, 1);
    EXPECT_EQ(moved.before->inverted, 0);
    EXPECT_EQ(moved.after->inverted, 0);
    EXPECT_TRUE(is_valid(moved));
    EXPECT_EQ(deformer.control_points(), control_points(settings));
    EXPECT_TRUE(deformer.warnings().empty());
}

TEST_F(RingDeformer, TakesOtherDisplacementsWithoutSolvingAgain)
{
    const Deformer deformer(mesh, settings);
    MotionSettings other = settings;
    other.curves[0].displacements = shifted(-0.2, 0.03);
    EXPECT_EQ(deformer.move(other.curves[0].displacements).positions, Deformer(mesh, other).move().positions);
    Points positions = rest;
    EXPECT_EQ(deformer.move_points(other.curves[0].displacements, {positions.data(), positions.rows(), 3}),
              1);
    EXPECT_EQ(positions, deformer.move(other.curves[0].displacements).positions);
    other.curves[0].displacements.resize(0, 2);
    EXPECT_EQ(Deformer(mesh, other).move().positions, rest);
}

TEST_F(RingDeformer, IsNotInfluencedByEarlierMoves)
{
    const std::vector<std::pair<const char*, std::function<void(MotionSettings&)>>> variants{
        {"harmonic", [](MotionSettings&) {}},
        {"rbf", [](MotionSettings& s) { s.deform.method = Method::rbf; }},
        {"idw", [](MotionSettings& s) { s.deform.method = Method::idw; }},
        {"elasticity", [](MotionSettings& s) { s.deform.method = Method::elasticity; }},
        {"rotations", [](MotionSettings& s) { s.deform.rotations = true; }},
        {"steps", [](MotionSettings& s) { s.deform.steps = 3; }},
        {"rigid layer",
         [](MotionSettings& s) {
             s.deform.rigid = {{"inner", 0.1}};
         }},
        {"untangling", [](MotionSettings& s) { s.deform.guard = Guard::untangle; }},
        {"remeshing", [](MotionSettings& s) { s.deform.guard = Guard::remesh; }},
    };
    for (const auto& [name, vary] : variants) {
        MotionSettings varied = settings;
        vary(varied);
        const Deformer deformer(mesh, varied);
        const Matrix first = turned(100), second = shifted(0.2, 0.1);
        const Points expected = Deformer(mesh, varied).move(second).positions;
        const Points before = deformer.move(first).positions;
        EXPECT_EQ(deformer.move(second).positions, expected) << name;
        EXPECT_EQ(deformer.move(first).positions, before) << name;
        EXPECT_EQ(points(mesh), rest) << name;
    }
}

TEST_F(RingDeformer, KnowsWeightsAndGradientWhereTheMoveIsLinear)
{
    const Deformer deformer(mesh, settings);
    ASSERT_TRUE(deformer.is_linear());
    EXPECT_EQ(deformer.weights()->rows(), vertex_count(mesh));
    EXPECT_EQ(deformer.weights()->cols(), 8);
    EXPECT_LT(deformer.weights_check().partition_error, 1e-14);
    EXPECT_EQ(deformer.weights_bytes(), sizeof(double) * 8 * static_cast<std::size_t>(vertex_count(mesh)));

    settings.deform.rotations = true;
    const Deformer turning(mesh, settings);
    EXPECT_FALSE(turning.is_linear());
    EXPECT_FALSE(turning.weights());
    EXPECT_THAT(test::message_of([&] { turning.gradient(Matrix::Zero(vertex_count(mesh), 2)); }),
                HasSubstr("not linear"));
}

/// J = sum |x|^2, a polynomial of degree 2 in the displacements: central differences are exact.
void expect_gradient_of_differences(const Deformer& deformer)
{
    constexpr double kStep = 0.01;
    const auto J = [&](const Matrix& D) { return deformer.move(D).positions.squaredNorm(); };
    const Matrix& D = deformer.displacements();
    const Matrix gradient = deformer.gradient(2 * deformer.move(D).positions.leftCols(2));
    ASSERT_EQ(gradient.rows(), D.rows());
    for (Index k = 0; k < D.rows(); ++k)
        for (Index c = 0; c < 2; ++c) {
            Matrix forth = D, back = D;
            forth(k, c) += kStep;
            back(k, c) -= kStep;
            EXPECT_NEAR(gradient(k, c), (J(forth) - J(back)) / (2 * kStep), 1e-8) << k << ' ' << c;
        }
}

TEST_F(RingDeformer, HasTheGradientThatDifferencesGive)
{
    expect_gradient_of_differences(Deformer(mesh, settings));
    settings.deform.method = Method::biharmonic;
    settings.deform.biharmonic = BiharmonicCondition::clamped;
    expect_gradient_of_differences(Deformer(mesh, settings));
    take_lattice();
    settings.deform.method = Method::ffd;
    expect_gradient_of_differences(Deformer(mesh, settings));
    settings.deform.method = Method::harmonic;
    expect_gradient_of_differences(Deformer(mesh, settings));
}

TEST_F(RingDeformer, ReachesPullsAndConstraintsByChangingTheDisplacements)
{
    const Index pulled = nearest_vertex(0, 1);
    PullSettings pull;
    pull.points = rest.row(pulled);
    pull.displacements = Eigen::RowVector3d(0.02, 0.2, 0);
    settings.pulls = {pull};
    settings.constraints = ConstraintSettings{.area = {"inner"}};
    const Deformer deformer(mesh, settings);
    const MoveResult moved = deformer.move();
    EXPECT_LT((moved.positions.row(pulled) - rest.row(pulled) - pull.displacements).norm(), 1e-10);
    ASSERT_TRUE(moved.control.constrained);
    const MeasuredConstraint& area = moved.control.constrained->measured[0];
    EXPECT_NEAR(area.reached, area.undisplaced, 1e-12 * area.undisplaced);
    EXPECT_EQ(moved.control.pull->vertices[0], mesh.numbering.vertex[static_cast<std::size_t>(pulled)]);

    Matrix D = deformer.displacements();
    deformer.satisfy(D);
    EXPECT_EQ(D, moved.displacements);
    EXPECT_EQ(deformer.move(D).positions, moved.positions);
    EXPECT_EQ(deformer.displacements(), Matrix(settings.curves[0].displacements));
}

TEST_F(RingDeformer, FitsALatticeToMovedCurves)
{
    const std::vector<CurveMove> curves = settings.curves;
    take_lattice();
    settings.curves = curves;
    settings.deform.method = Method::ffd;
    const Deformer deformer(mesh, settings);
    const MoveResult moved = deformer.move();
    ASSERT_TRUE(moved.control.curve_misfit);
    EXPECT_LT(*moved.control.curve_misfit, 0.01);
    EXPECT_NEAR(moved.fits[0].landing_error, *moved.control.curve_misfit, 0.01);
    EXPECT_EQ(deformer.control_points().size(), 30U);
    EXPECT_EQ(deformer.lattice()->held, deformer.held());
}

TEST_F(RingDeformer, UsesGivenWeightsAndSetsTheRowsOfTheBoundary)
{
    const Deformer solved(mesh, settings);
    Weights weights{solved.control_points(), Matrix::Constant(vertex_count(mesh), 8, 0.125)};
    const Deformer given(mesh, settings, weights);
    const MoveResult moved = given.move();
    EXPECT_LT(moved.fits[0].landing_error, 1e-13);
    const Index inside = nearest_vertex(2, 0);
    const Eigen::RowVector2d mean = settings.curves[0].displacements.colwise().mean();
    EXPECT_LT((moved.positions.row(inside).head<2>() - rest.row(inside).head<2>() - mean).norm(), 1e-15);

    weights.values.conservativeResize(10, Eigen::NoChange);
    EXPECT_THAT(test::message_of([&] { Deformer(mesh, settings, weights); }), HasSubstr("10 x 8"));
    settings.deform.rotations = true;
    EXPECT_THAT(test::message_of([&] { Deformer(mesh, settings, weights); }),
                HasSubstr("cannot use those of the caller"));
}

TEST_F(RingDeformer, ChecksAndRepairsAsTheGuardSays)
{
    // A harmonic turn by 120 degrees turns the layer next to the circle over.
    settings.curves[0].displacements = turned(120);
    settings.deform.guard = Guard::check;
    const MoveResult checked = Deformer(mesh, settings).move();
    EXPECT_GT(checked.after->inverted, 0);
    EXPECT_FALSE(is_valid(checked));
    EXPECT_LT(checked.safe_step->step, 1);
    EXPECT_FALSE(checked.untangled);

    settings.deform.guard = Guard::untangle;
    const MoveResult untangled = Deformer(mesh, settings).move();
    EXPECT_EQ(untangled.tangled, checked.after->inverted);
    ASSERT_TRUE(untangled.untangled);
    EXPECT_EQ(untangled.after->inverted, 0);
    EXPECT_TRUE(is_valid(untangled));
    for (const Index v : marker_vertices(marker(mesh, "inner")))
        EXPECT_EQ(untangled.positions.row(v), checked.positions.row(v));

    settings.deform.guard = Guard::none;
    const MoveResult unchecked = Deformer(mesh, settings).move();
    EXPECT_FALSE(unchecked.after);
    EXPECT_EQ(unchecked.positions, checked.positions);
}

/// The top of the unit square bulges out over its left side: the triangle in the upper left corner, whose
/// vertices are all on the boundary, turns over, and no position of the others can repair it.
TEST(Deformer, HandsOutAMeshOfItsOwnWhereItRemeshes)
{
    const Mesh square = build_mesh(test::uneven_square(10));
    const Points before = points(square);
    CurveMove top{.marker = "top"};
    top.curve = {.degree = 2, .control_points = Points2(3, 2)};
    top.curve.control_points << 1, 1, 0.5, 1, 0, 1;
    top.displacements = Points2::Zero(3, 2);
    top.displacements.row(1) << -0.8, 0.6;
    MotionSettings motion;
    motion.curves = {top};
    motion.deform.guard = Guard::remesh;
    const MoveResult moved = Deformer(square, motion).move();
    ASSERT_TRUE(moved.remeshed);
    ASSERT_TRUE(moved.mesh);
    EXPECT_EQ(moved.after->inverted, 0);
    EXPECT_EQ(points(*moved.mesh), moved.positions);
    EXPECT_EQ(to_mesh_data(square, moved).points.rows(), moved.remeshed->vertices_after);
    EXPECT_EQ(points(square), before);
}

TEST_F(RingDeformer, FindsMovedBoundariesThatCross)
{
    settings.deform.guard = Guard::remesh;
    settings.curves[0].displacements.setZero();
    settings.curves[0].displacements.row(0) << -3, 0.5;
    const MoveResult moved = Deformer(mesh, settings).move();
    ASSERT_EQ(moved.crossings.size(), 1U);
    EXPECT_THAT(moved.crossings[0], HasSubstr("'inner' crosses"));
    EXPECT_FALSE(is_valid(moved));
    EXPECT_FALSE(moved.remeshed);
}

TEST_F(RingDeformer, RefusesDisplacementsThatDoNotFit)
{
    const Deformer deformer(mesh, settings);
    EXPECT_THAT(test::message_of([&] { deformer.move(Matrix::Zero(7, 2)); }),
                HasSubstr("displacements is 7 x 2, expected 8 x 2"));
    EXPECT_THAT(test::message_of([&] { deformer.move(Matrix::Constant(8, 2, std::nan(""))); }),
                HasSubstr("finite"));
    EXPECT_THROW(deformer.gradient(Matrix::Zero(3, 2)), InputError);
}

} // namespace
