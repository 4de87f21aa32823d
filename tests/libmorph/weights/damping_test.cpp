#include "libmorph/weights/damping.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/deform/rigid_frames.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace morph;
using test::boundary_displacement;
using test::difference;
using test::dirichlet_boundary;
using testing::HasSubstr;

constexpr double kRounding = 1e-14;

Eigen::RowVector2d wavy(double x, double y)
{
    return {0.1 * std::sin(3 * x + y), 0.2 * std::cos(x - 2 * y)};
}

TEST(DampingExtension, IsTheFormulaInARing)
{
    // The boundary is two polygons of 200 sides, which lie a little inside their circles.
    const Mesh mesh = build_mesh(test::annulus(0.5, 3, 200, 20));
    constexpr double kSagitta = 3 * 1.3e-4;
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix d = boundary_displacement(mesh, held, wavy);
    const Matrix moved = damping_extension(mesh, held)->extend(d);
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const double x = points(mesh)(v, 0), y = points(mesh)(v, 1), r = std::hypot(x, y);
        const double inner = r - 0.5, outer = 3 - r;
        const double f = outer * outer / (outer * outer + inner * inner);
        EXPECT_LE((moved.row(v) - f * wavy(0.5 * x / r, 0.5 * y / r)).norm(), kSagitta) << r;
    }
}

TEST(DampingExtension, FollowsAMovingWallLinearlyAlongItsEdges)
{
    const Mesh mesh = build_mesh(test::uneven_square(6));
    DirichletBoundary held = dirichlet_boundary(mesh, {"bottom"});
    const auto affine = [](double x, double) { return Eigen::RowVector2d(1 + x, 3 * x); };
    const Matrix moved = damping_extension(mesh, held)->extend(boundary_displacement(mesh, held, affine));
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const double x = points(mesh)(v, 0), y = points(mesh)(v, 1);
        const double still = std::min({x, 1 - x, 1 - y});
        if (mesh.kernel.is_boundary(VertexHandle(v)))
            continue;
        // A side shares its lower end with the bottom, so that its value falls from there to its next vertex.
        const double f = still * still / (still * still + y * y);
        const double along = std::max(0.0, 1 - 6 * y);
        const Eigen::RowVector2d side = still == x       ? along * affine(0, 0)
                                        : still == 1 - x ? along * affine(1, 0)
                                                         : Eigen::RowVector2d(0, 0);
        EXPECT_LE((moved.row(v) - f * affine(x, 0) - (1 - f) * side).norm(), kRounding) << x << ' ' << y;
    }
}

TEST(DampingExtension, IsExactOnTheBoundaryOfEveryRealMeshAndKeepsBounds)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const DirichletBoundary held = dirichlet_boundary(mesh, {mesh.markers.front().name});
        const auto extension = damping_extension(mesh, held);
        const Matrix d = boundary_displacement(mesh, held, wavy);
        const Matrix moved = extension->extend(d);
        EXPECT_EQ(moved(held.vertices, Eigen::all), d);
        EXPECT_LE(moved.col(1).maxCoeff<Eigen::PropagateNaN>(), d.col(1).maxCoeff() + kRounding);
        EXPECT_GE(moved.col(1).minCoeff<Eigen::PropagateNaN>(), d.col(1).minCoeff() - kRounding);
        const Matrix one = Matrix::Ones(d.rows(), 1);
        EXPECT_LE(difference(extension->extend(one), Matrix::Ones(vertex_count(mesh), 1)), kRounding);
    }
}

TEST(DampingExtension, OfOneKindOfBoundaryTakesItsNearestValue)
{
    const Mesh mesh = build_mesh(test::uneven_square(5));
    DirichletBoundary held = dirichlet_boundary(mesh, {"bottom", "right", "top", "left"});
    const Matrix d = boundary_displacement(mesh, held, wavy);
    const Matrix all_move = damping_extension(mesh, held)->extend(d);
    held.moving_edges.clear();
    EXPECT_LE(difference(damping_extension(mesh, held)->extend(d), all_move), kRounding);
    EXPECT_GT(all_move.rowwise().norm().minCoeff(), 0);
}

TEST(DampingExtension, WithRotationsTurnsAirfoilsBy120DegreesWithoutInvertedElements)
{
    for (const auto& [file, body] : test::kAirfoilMeshes) {
        const Mesh mesh = read_mesh(test::data_path(std::string("meshes/") + file));
        const DirichletBoundary held = dirichlet_boundary(mesh, {body});
        const auto extension = damping_extension(mesh, held);
        for (const double degrees : {5, 20, 45, 90, 120}) {
            SCOPED_TRACE(file + (" by " + std::to_string(degrees)));
            const Matrix d = boundary_displacement(mesh, held, test::turn(degrees, {0.5, 0}));
            EXPECT_EQ(test::inverted_after(mesh, extend_with_rotations(*extension, mesh, held, d)), 0);
        }
    }
}

TEST(DampingExtension, IsTheSameBytesForAnyNumberOfThreads)
{
    const Mesh mesh = read_mesh(test::data_path("meshes/cylinder_lam.su2"));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"cylinder"});
    const Matrix d = boundary_displacement(mesh, held, wavy);
    set_thread_count(1);
    const Matrix alone = damping_extension(mesh, held)->extend(d);
    set_thread_count(3);
    EXPECT_EQ(damping_extension(mesh, held)->extend(d), alone);
    set_thread_count(0);
}

TEST(DampingExtension, RefusesWhatMakesNoSense)
{
    const Mesh mesh = build_mesh(test::uneven_square(4));
    DirichletBoundary held = dirichlet_boundary(mesh, {"top"});
    EXPECT_THAT(test::message_of([&] { damping_extension(mesh, {}); }), HasSubstr("no vertex is held"));
    EXPECT_THROW(damping_extension(mesh, held)->extend(Matrix::Zero(3, 2)), InputError);
    std::erase(held.vertices, held.moving_edges[1][0]);
    EXPECT_THAT(test::message_of([&] { damping_extension(mesh, held); }), HasSubstr("but it is not held"));
}

} // namespace
