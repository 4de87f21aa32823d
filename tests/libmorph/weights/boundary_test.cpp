#include "libmorph/core/error.h"
#include "libmorph/deform/apply.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/weights/boundary.h"
#include "libmorph/weights/elasticity.h"
#include "libmorph/weights/harmonic_curves.h"
#include "libmorph/weights/rbf.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace morph;
using ::testing::HasSubstr;

// A few additions of numbers of size 1.
constexpr double kRoundOff = 1e-14;

/// Straight clamped line of 4 control points.
Curve line(double x0, double y0, double x1, double y1)
{
    CurveDefinition definition{.degree = 2, .closed = false, .control_points = Points2(4, 2)};
    for (int i = 0; i < 4; ++i)
        definition.control_points.row(i) << x0 + (x1 - x0) * i / 3, y0 + (y1 - y0) * i / 3;
    return Curve(definition);
}

const Curve kBottom = line(0, 0, 1, 0);
const Curve kRight = line(1, 0, 1, 1);

struct Corner {
    Mesh mesh = build_mesh(test::uneven_square(6));
    std::vector<CurveBoundary> boundaries{parametrize_marker(mesh, "bottom", kBottom),
                                          parametrize_marker(mesh, "right", kRight)};
    BoundaryConditions conditions = boundary_conditions(mesh, boundaries, {"top", "left"});

    std::string complaint(const Points2& displacements) const
    {
        try {
            require_ends_together(mesh, boundaries, conditions, displacements);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
};

Index vertex_at(const Mesh& mesh, double x, double y)
{
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if ((points(mesh).row(v) - Eigen::RowVector3d(x, y, 0)).norm() < 1e-12)
            return v;
    return -1;
}

Eigen::RowVectorXd dirichlet_row(const BoundaryConditions& conditions, Index vertex)
{
    for (std::size_t i = 0; i < conditions.boundary.vertices.size(); ++i)
        if (conditions.boundary.vertices[i] == vertex)
            return conditions.values.row(static_cast<Eigen::Index>(i));
    return {};
}

TEST(BoundaryConditions, HoldEveryBoundaryVertexOnce)
{
    const Corner corner;
    EXPECT_EQ(corner.conditions.boundary.vertices.size(), 24U);
    EXPECT_EQ(corner.conditions.columns.size(), 8U);
    EXPECT_EQ(corner.conditions.columns[4], (ControlPoint{"right", 0}));
    EXPECT_EQ(corner.conditions.unmarked, 0);
}

TEST(BoundaryConditions, SplitAVertexThatTwoCurvesEndIn)
{
    const Corner corner;
    const auto row = dirichlet_row(corner.conditions, vertex_at(corner.mesh, 1, 0));
    ASSERT_EQ(row.size(), 8);
    EXPECT_NEAR(row(3), 0.5, kRoundOff);
    EXPECT_NEAR(row(4), 0.5, kRoundOff);
    EXPECT_NEAR(row.sum(), 1, kRoundOff);
}

TEST(BoundaryConditions, KeepAVertexFixedThatAFixedMarkerSharesWithACurve)
{
    const Corner corner;
    EXPECT_EQ(dirichlet_row(corner.conditions, vertex_at(corner.mesh, 0, 0)).norm(), 0);
    EXPECT_EQ(dirichlet_row(corner.conditions, vertex_at(corner.mesh, 1, 1)).norm(), 0);
}

TEST(BoundaryConditions, RefuseAMarkerThatIsFixedAndCarried)
{
    const Corner corner;
    EXPECT_THROW(boundary_conditions(corner.mesh, corner.boundaries, {"right"}), InputError);
    EXPECT_THROW(boundary_conditions(corner.mesh, corner.boundaries, {"rigth"}), InputError);
}

TEST(BoundaryConditions, HoldVerticesThatNoMarkerNames)
{
    MeshData data = test::uneven_square(6);
    data.markers.resize(1); // only "bottom" is left
    const Mesh mesh = build_mesh(data);
    const auto conditions = boundary_conditions(mesh, {parametrize_marker(mesh, "bottom", kBottom)}, {});
    EXPECT_EQ(conditions.unmarked, 17);
    EXPECT_EQ(conditions.boundary.vertices.size(), 24U);
}

TEST(RequireEndsTogether, AcceptsEndsThatMoveAlike)
{
    const Corner corner;
    Points2 moves = Points2::Zero(8, 2);
    moves.row(1) << 0, 0.1;
    moves.row(3) << 0.05, -0.02;
    moves.row(4) << 0.05, -0.02;
    EXPECT_EQ(corner.complaint(moves), "");
}

TEST(RequireEndsTogether, NamesBoundaryAndControlPointOfEndsThatPart)
{
    const Corner corner;
    Points2 moves = Points2::Zero(8, 2);
    moves.row(4) << 0.05, 0;
    const std::string message = corner.complaint(moves);
    EXPECT_THAT(message, HasSubstr("boundary 'right', control point 1"));
    EXPECT_THAT(message, HasSubstr("boundary 'bottom', control point 4"));
    EXPECT_THAT(message, HasSubstr("vertex 6,"));
}

TEST(RequireEndsTogether, NamesTheMarkerThatHoldsAnEnd)
{
    const Corner corner;
    Points2 moves = Points2::Zero(8, 2);
    moves.row(0) << 0.05, 0;
    const std::string message = corner.complaint(moves);
    EXPECT_THAT(message, HasSubstr("boundary 'bottom', control point 1"));
    EXPECT_THAT(message, HasSubstr("marker 'left' holds it fixed"));
}

TEST(RequireEndsTogether, TreatsAnOpenCurveAroundAClosedMarkerAlike)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 32, 4));
    CurveDefinition square{.degree = 1, .closed = false, .control_points = Points2(5, 2)};
    square.control_points << 1, 0, 0, 1, -1, 0, 0, -1, 1, 0;
    const std::vector<CurveBoundary> boundaries{parametrize_marker(mesh, "inner", Curve(square))};
    const BoundaryConditions conditions = boundary_conditions(mesh, boundaries, {"outer"});
    Points2 moves = Points2::Constant(5, 2, 0.1);
    EXPECT_NO_THROW(require_ends_together(mesh, boundaries, conditions, moves));
    moves(4, 0) = 0.2;
    EXPECT_THROW(require_ends_together(mesh, boundaries, conditions, moves), InputError);
    const auto row = dirichlet_row(conditions, vertex_at(mesh, 1, 0));
    EXPECT_NEAR(row(0), 0.5, kRoundOff);
    EXPECT_NEAR(row(4), 0.5, kRoundOff);
}

/// The marker "through" runs along y = 1 over both of two squares that touch in (1, 1), "rest" is the rest of
/// the boundary.
MeshData squares_with_a_line_through()
{
    MeshData data = test::touching_squares(4);
    std::vector<Marker> markers{{"through", {}}, {"rest", {}}};
    for (const Marker& m : data.markers) {
        const bool through = m.name == "top" || m.name == "bottom 2";
        auto& edges = markers[through ? 0 : 1].edges;
        edges.insert(edges.end(), m.edges.begin(), m.edges.end());
    }
    data.markers = std::move(markers);
    return data;
}

TEST(HarmonicCurveWeights, MoveTheCopiesOfASplitVertexTogether)
{
    MeshData data = squares_with_a_line_through();
    // On the curve alone the corner would be fixed by "rest", which holds it in the second square.
    std::erase_if(data.markers[1].edges, [](const auto& edge) { return edge[0] == 24 || edge[1] == 24; });
    Mesh mesh = build_mesh(data);
    ASSERT_EQ(vertex_count(mesh), mesh.numbering.file_vertices + 1);
    const Curve curve = line(0, 1, 2, 1);
    EXPECT_EQ(parametrize_marker(mesh, "through", curve).vertices.size(), 9U);
    const Weights weights = harmonic_curve_weights(mesh, {{"through", curve}});
    Matrix moves = Matrix::Zero(4, 2);
    moves.row(1) << 0, 0.1;
    moves.row(2) << 0.05, 0.1;
    apply_weights(weights, moves, points(mesh));
    const Curve moved = curve.with_control_points(curve.definition().control_points + moves);
    Index copies = 0;
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        if (mesh.numbering.vertex[static_cast<std::size_t>(v)] != 24)
            continue;
        ++copies;
        EXPECT_LT((points(mesh).row(v).head<2>().transpose() - moved.point(0.5)).norm(), 1e-12);
    }
    EXPECT_EQ(copies, 2);
}

TEST(HarmonicCurveWeights, MoveBoundaryNodesOntoTheMovedCurves)
{
    Mesh mesh = build_mesh(test::uneven_square(6));
    const Weights weights = harmonic_curve_weights(mesh, {{"bottom", kBottom}, {"right", kRight}});
    Matrix moves = Matrix::Zero(8, 2);
    moves.row(1) << 0.02, 0.1;
    moves.row(3) << 0.05, -0.02;
    moves.row(4) = moves.row(3);
    moves.row(6) << -0.1, 0.03;
    apply_weights(weights, moves, points(mesh));
    const Curve moved = kBottom.with_control_points(kBottom.definition().control_points + moves.topRows(4));
    for (const Index v : marker_vertices(marker(mesh, "bottom")))
        EXPECT_LT(closest_parameter(moved, points(mesh).row(v).head<2>().transpose()).distance, 1e-12);
}

TEST(BoundaryConditions, FixEveryMarkerWithoutACurve)
{
    const Mesh mesh = build_mesh(test::uneven_square(6));
    const auto all = boundary_conditions(mesh, {{"bottom", kBottom}, {"right", kRight}});
    const Corner corner;
    EXPECT_EQ(all.boundary.vertices, corner.conditions.boundary.vertices);
    EXPECT_EQ(all.values, corner.conditions.values);
    EXPECT_EQ(all.boundary.moving_edges.size(), 12U);
    EXPECT_EQ(all.boundary.fixed_edges.size(), 12U);
}

TEST(BoundaryConditions, SpeakOfWhatAnyMethodExtends)
{
    const Mesh mesh = build_mesh(test::uneven_square(6));
    const auto conditions = boundary_conditions(mesh, {{"bottom", kBottom}});
    Matrix moves = Matrix::Zero(4, 2);
    moves.row(1) << 0.02, 0.1;
    const auto rbf = rbf_extension(mesh, conditions.boundary);
    const Weights weights = extended_weights(conditions, *rbf);
    EXPECT_EQ(weights.columns, conditions.columns);
    const Matrix at_once = rbf->extend(conditions.values * moves);
    EXPECT_LE((weights.values * moves - at_once).norm(), 1e-10 * at_once.norm());
    const auto elastic = elastic_extension(mesh, conditions.boundary, {});
    const Matrix moved = elastic->extend(conditions.values * moves);
    for (const Index v : marker_vertices(marker(mesh, "bottom")))
        EXPECT_EQ(moved.row(v), at_once.row(v));
    EXPECT_THROW(extended_weights(conditions, *elastic), InputError);
}

} // namespace
