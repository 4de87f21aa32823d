#include "libmorph/deform/slide.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/mesh/chain.h"
#include "libmorph/weights/harmonic.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"
#include "tests/support/weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace morph;
using test::boundary_displacement;
using test::dirichlet_boundary;
using test::message_of;
using ::testing::HasSubstr;

Matrix harmonic_move(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)
{
    return harmonic_extension(mesh, held, Diffusivity::uniform)->extend(displacement);
}

/// The unit square; its top goes right by a half, its bottom stays.
struct ShearedSquare {
    Mesh mesh = build_mesh(test::uneven_square(12));
    DirichletBoundary held = dirichlet_boundary(mesh, {"top"});
    Matrix D = boundary_displacement(
        mesh, held, [](double, double y) { return Eigen::RowVector2d(0, y > 0.99 ? 0.5 : 0); });
};

TEST(Sliding, NodesOfStraightSidesFollowTheStretch)
{
    // The top rises by a half, the sides are vertical: with sliding sides all of the square is stretched
    // evenly. The ends of the sides are held by top and bottom.
    const ShearedSquare square;
    const Matrix moved =
        with_sliding(harmonic_move, {{"left", {}}, {"right", {}}})(square.mesh, square.held, square.D);
    for (Index v = 0; v < vertex_count(square.mesh); ++v) {
        EXPECT_NEAR(moved(v, 1), points(square.mesh)(v, 1) / 2, 1e-12);
        EXPECT_NEAR(moved(v, 0), 0, 1e-12);
    }
    const Matrix fixed = harmonic_move(square.mesh, square.held, square.D);
    EXPECT_GT((fixed - moved).cwiseAbs().maxCoeff(), 0.2);
}

TEST(Sliding, NodesStayOnTheirLine)
{
    const Mesh mesh = build_mesh(test::uneven_square(12));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"top"});
    const Matrix D = boundary_displacement(mesh, held, [](double x, double y) {
        return y > 0.99 ? Eigen::RowVector2d(0.3 * x * (1 - x), 0.4 * x * (1 - x)) : Eigen::RowVector2d(0, 0);
    });
    const Matrix moved = with_sliding(harmonic_move, {{"right", {}}, {"bottom", {}}})(mesh, held, D);
    double slid = 0;
    for (const Index v : marker_vertices(marker(mesh, "right"))) {
        EXPECT_NEAR(moved(v, 0), 0, 1e-15);
        slid = std::max(slid, std::abs(moved(v, 1)));
    }
    for (const Index v : marker_vertices(marker(mesh, "bottom")))
        EXPECT_NEAR(moved(v, 1), 0, 1e-15);
    EXPECT_GT(slid, 1e-3);
}

TEST(Sliding, ACircleOfNodesTurnsOnItsCurve)
{
    // The inner circle turns; the outer one, carried by a circle-like curve, follows.
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 60));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix D = boundary_displacement(mesh, held, test::turn(20, {0, 0}));
    Points2 control_points(24, 2);
    for (Index k = 0; k < 24; ++k) {
        const double angle = 2 * std::numbers::pi * k / 24;
        control_points.row(k) << 3.03 * std::cos(angle), 3.03 * std::sin(angle);
    }
    const Curve circle({.degree = 3, .closed = true, .control_points = control_points});
    const Matrix moved = with_sliding(harmonic_move, {{"outer", circle}})(mesh, held, D);
    double largest = 0;
    for (const Index v : marker_vertices(marker(mesh, "outer"))) {
        const Eigen::RowVector2d before = points(mesh).row(v).head<2>();
        EXPECT_NEAR((before + moved.row(v)).norm(), before.norm(), 0.002);
        largest = std::max(largest, moved.row(v).norm());
    }
    EXPECT_GT(largest,
              0.03); // harmonic functions of a free circle: 2 R r / (r^2 + R^2) of the inner one's 0.17
}

TEST(Sliding, NodesThatWouldPassEachOtherSlideLess)
{
    const Mesh mesh = build_mesh(test::uneven_square(12));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"top"});
    const Matrix D = Matrix::Zero(static_cast<Index>(held.vertices.size()), 2);
    const BoundaryMove scrambled = [&](const Mesh& of, const DirichletBoundary& boundary,
                                       const Matrix& displacement) {
        Matrix all = harmonic_move(of, boundary, displacement);
        for (Index v = 0; v < vertex_count(of); ++v)
            all(v, 0) += 0.2 * std::sin(40 * points(of)(v, 0));
        return all;
    };
    const std::vector<Index> bottom = marker_vertices(marker(mesh, "bottom"));
    std::vector<std::pair<double, double>> along; // x before and after, as the last call gets them
    const BoundaryMove watched = [&](const Mesh& of, const DirichletBoundary& boundary,
                                     const Matrix& displacement) {
        along.clear();
        for (std::size_t i = 0; i < boundary.vertices.size(); ++i)
            if (std::find(bottom.begin(), bottom.end(), boundary.vertices[i]) != bottom.end()) {
                const double x = points(of)(boundary.vertices[i], 0);
                along.emplace_back(x, x + displacement(static_cast<Index>(i), 0));
            }
        return scrambled(of, boundary, displacement);
    };
    with_sliding(watched, {{"bottom", {}}})(mesh, held, D);
    ASSERT_EQ(along.size(), bottom.size());
    std::sort(along.begin(), along.end());
    double nearest = 1;
    for (std::size_t i = 1; i < along.size(); ++i)
        nearest = std::min(nearest,
                           (along[i].second - along[i - 1].second) / (along[i].first - along[i - 1].first));
    EXPECT_NEAR(nearest, 0.1, 1e-9);
}

TEST(Sliding, SaysWhatIsWrong)
{
    const ShearedSquare square;
    EXPECT_THAT(message_of([&] {
                    with_sliding(harmonic_move, {{"wall", {}}})(square.mesh, square.held, square.D);
                }),
                HasSubstr("wall"));
    Matrix moved = square.D;
    moved.col(1).setConstant(0.1);
    EXPECT_THAT(message_of([&] {
                    with_sliding(harmonic_move, {{"left", {}}})(square.mesh, square.held, moved);
                }),
                HasSubstr("marker 'left' slides, but is moved as well"));
}

} // namespace
