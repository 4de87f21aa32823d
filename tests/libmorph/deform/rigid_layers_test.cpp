#include "libmorph/deform/rigid_layers.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/weights/harmonic.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

Mesh ring()
{
    return build_mesh(test::uneven_annulus(0.5, 3, 120));
}

TEST(RigidLayers, MoveAsOneBodyWithAMarkerThatTurns)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const test::Move turn = test::turn(75, {0.3, 0.1});
    const Matrix D = boundary_displacement(mesh, held, turn);
    const Matrix moved = with_rigid_layers(harmonic_move, {{"inner", 0.4}})(mesh, held, D);
    const Matrix wanted = test::displacement_everywhere(mesh, turn);
    int inside = 0;
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const double radius = points(mesh).row(v).norm();
        if (radius > 0.89) // the circle's polygon is a little nearer than the circle
            continue;
        ++inside;
        EXPECT_LE((moved.row(v) - wanted.row(v)).norm(), 1e-13) << radius;
    }
    EXPECT_GT(inside, 200);
    EXPECT_GT((moved - harmonic_move(mesh, held, D)).cwiseAbs().maxCoeff(), 0.1);
}

TEST(RigidLayers, KeepTheirHeightOnAWallThatBends)
{
    // The inner circle becomes an ellipse; vertices near it stay as far from it as they were.
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix D = boundary_displacement(
        mesh, held, [](double x, double y) { return Eigen::RowVector2d(0.3 * x, -0.3 * y); });
    constexpr double kHeight = 0.06;
    const Matrix moved = with_rigid_layers(harmonic_move, {{"inner", kHeight}})(mesh, held, D);
    const auto distance_to_wall = [&](const Points& x, Index v) {
        double nearest = 1e9;
        for (const auto& [a, b] : held.moving_edges) {
            const Eigen::RowVector3d along = x.row(b) - x.row(a);
            const double share = std::clamp((x.row(v) - x.row(a)).dot(along) / along.squaredNorm(), 0.0, 1.0);
            nearest = std::min(nearest, (x.row(v) - x.row(a) - share * along).norm());
        }
        return nearest;
    };
    Points after = points(mesh);
    after.leftCols<2>() += moved;
    int compared = 0;
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const double before = distance_to_wall(points(mesh), v);
        if (before == 0 || before > kHeight)
            continue;
        ++compared;
        EXPECT_NEAR(distance_to_wall(after, v), before, 0.05 * before); // the wall bends a little below it
    }
    EXPECT_GT(compared, 20);
}

TEST(RigidLayers, OfAFixedMarkerStay)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix D = boundary_displacement(mesh, held, test::turn(30, {0, 0}));
    const Matrix moved = with_rigid_layers(harmonic_move, {{"outer", 0.5}})(mesh, held, D);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (points(mesh).row(v).norm() > 2.6) {
            EXPECT_EQ(moved.row(v).norm(), 0);
        }
}

TEST(RigidLayers, SayWhatIsWrong)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix D = boundary_displacement(mesh, held, test::turn(30, {0, 0}));
    const auto with = [&](RigidLayer layer) {
        return message_of([&] { with_rigid_layers(harmonic_move, {layer})(mesh, held, D); });
    };
    EXPECT_THAT(with({"wing", 0.1}), HasSubstr("wing"));
    EXPECT_THAT(with({"inner", -0.1}), HasSubstr("below 0"));
    DirichletBoundary half = held;
    half.vertices.clear();
    Matrix of_half(0, 2);
    const std::vector<bool> moving = test::is_moving(mesh, held);
    std::vector<Index> rows;
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        if (moving[i]) {
            half.vertices.push_back(held.vertices[i]);
            rows.push_back(static_cast<Index>(i));
        }
    of_half = D(rows, Eigen::all);
    EXPECT_THAT(message_of([&] {
                    with_rigid_layers(harmonic_move, {{"outer", 0.1}})(mesh, half, of_half);
                }),
                HasSubstr("neither moved nor fixed"));
}

} // namespace
