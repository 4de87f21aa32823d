#include "libmorph/weights/idw.h"

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

// Sums of some hundred numbers of one sign.
constexpr double kSumTol = 1e-13;

Eigen::RowVector2d wavy(double x, double y)
{
    return {0.1 * std::sin(3 * x + y), 0.2 * std::cos(x - 2 * y)};
}

TEST(IdwExtension, IsTheFormulaOfTheArticle)
{
    const Mesh mesh =
        build_mesh(test::uneven_square(4)); // sides cut in four: each vertex has a length of 1/4
    const DirichletBoundary held = dirichlet_boundary(mesh, {"top"});
    const Matrix d = boundary_displacement(mesh, held, wavy);
    const auto x = points(mesh);
    for (const IdwOptions& options : {IdwOptions{3, 5, 2, 0.25}, IdwOptions{2.5, 3.5, 0.7, 0.9}}) {
        const Matrix moved = idw_extension(mesh, held, options)->extend(d);
        int checked = 0;
        for (Index v = 0; v < vertex_count(mesh); ++v) {
            if (mesh.kernel.is_boundary(VertexHandle(v)))
                continue;
            double total = 0;
            Eigen::RowVector2d sum(0, 0);
            for (std::size_t i = 0; i < held.vertices.size(); ++i) {
                const double r = (x.row(v) - x.row(held.vertices[i])).norm();
                const double weight =
                    0.25 * (std::pow(options.reach / r, options.far_exponent) +
                            std::pow(options.stiffness * options.reach / r, options.near_exponent));
                total += weight;
                sum += weight * d.row(static_cast<Index>(i));
            }
            EXPECT_LE((moved.row(v) - sum / total).norm(), kSumTol);
            ++checked;
        }
        EXPECT_EQ(checked, 9);
    }
}

TEST(IdwExtension, WeighsAVertexByTheLengthOfItsEdges)
{
    MeshData data; // a vertex in a rectangle 4 x 2, all corners equally far
    data.points.resize(6, 3);
    data.points << -2, -1, 0, 2, -1, 0, 2, 1, 0, -2, 1, 0, 0, 0, 0, -1, -1, 0;
    data.elements = {{0, 5, 4, -1}, {5, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}};
    data.markers = {{"bottom", {{0, 5}, {5, 1}}}};
    const Mesh mesh = build_mesh(data);
    const DirichletBoundary held = dirichlet_boundary(mesh, {"bottom"});
    const Matrix one = Matrix::Identity(5, 5);
    const Matrix weights = idw_extension(mesh, held, {2, 2, 1, 0})->extend(one);
    // A_i / r_i^2 by file number: corners have r^2 = 5, the vertex in the bottom 2.
    const double expected[] = {1.5 / 5, 2.5 / 5, 3. / 5, 3. / 5, 0, 2. / 2};
    for (Index v = 0; v < 6; ++v)
        if (mesh.numbering.vertex[static_cast<std::size_t>(v)] == 4)
            for (Index i = 0; i < 5; ++i) {
                const Index file =
                    mesh.numbering
                        .vertex[static_cast<std::size_t>(held.vertices[static_cast<std::size_t>(i)])];
                EXPECT_NEAR(weights(v, i), expected[file] / 3, kSumTol) << file;
            }
}

TEST(IdwExtension, IsExactOnTheBoundaryOfEveryRealMeshAndKeepsBounds)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const DirichletBoundary held = dirichlet_boundary(mesh, {mesh.markers.front().name});
        const auto extension = idw_extension(mesh, held);
        const Matrix d = boundary_displacement(mesh, held, wavy);
        const Matrix moved = extension->extend(d);
        EXPECT_EQ(moved(held.vertices, Eigen::all), d);
        EXPECT_LE(moved.col(1).maxCoeff<Eigen::PropagateNaN>(), d.col(1).maxCoeff() + kSumTol);
        EXPECT_GE(moved.col(1).minCoeff<Eigen::PropagateNaN>(), d.col(1).minCoeff() - kSumTol);
        const Matrix one = Matrix::Ones(d.rows(), 1);
        EXPECT_LE(difference(extension->extend(one), Matrix::Ones(vertex_count(mesh), 1)), kSumTol);
    }
}

TEST(IdwExtension, TendsToTheBoundaryThatAVertexIsNearTo)
{
    MeshData data = test::uneven_square(10);
    const Index inner = 11 + 5; // above (0.5, 0)
    data.points.row(inner) << 0.5, 1e-5, 0;
    const Mesh mesh = build_mesh(data);
    const DirichletBoundary held = dirichlet_boundary(mesh, {"bottom"});
    const Matrix moved = idw_extension(mesh, held)->extend(boundary_displacement(mesh, held, wavy));
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (mesh.numbering.vertex[static_cast<std::size_t>(v)] == inner) {
            EXPECT_LE((moved.row(v) - wavy(0.5, 0)).norm(), 1e-10);
        }
}

TEST(IdwExtension, WithRotationsTurnsAirfoilsBy120DegreesWithoutInvertedElements)
{
    for (const auto& [file, body] : test::kAirfoilMeshes) {
        const Mesh mesh = read_mesh(test::data_path(std::string("meshes/") + file));
        const DirichletBoundary held = dirichlet_boundary(mesh, {body});
        const auto extension = idw_extension(mesh, held);
        for (const double degrees : {5, 20, 45, 90, 120}) {
            SCOPED_TRACE(file + (" by " + std::to_string(degrees)));
            const Matrix d = boundary_displacement(mesh, held, test::turn(degrees, {0.5, 0}));
            EXPECT_EQ(test::inverted_after(mesh, extend_with_rotations(*extension, mesh, held, d)), 0);
            EXPECT_EQ(test::inverted_after(mesh, extension->extend(d)) == 0, degrees <= 45);
        }
    }
}

TEST(IdwExtension, IsTheSameBytesForAnyNumberOfThreads)
{
    const Mesh mesh = read_mesh(test::data_path("meshes/naca0012_inv.su2"));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"airfoil"});
    const Matrix d = boundary_displacement(mesh, held, wavy);
    set_thread_count(1);
    const Matrix alone = idw_extension(mesh, held)->extend(d);
    set_thread_count(3);
    EXPECT_EQ(idw_extension(mesh, held)->extend(d), alone);
    set_thread_count(0);
}

TEST(IdwExtension, TakesVerticesWithoutEdgesAndVerticesAtTheSamePlace)
{
    const Mesh square = build_mesh(test::uneven_square(4));
    const Matrix two = Matrix::Constant(1, 1, 2);
    EXPECT_EQ(idw_extension(square, {{0}, {}, {}})->extend(two), Matrix::Constant(25, 1, 2));
    MeshData data = test::uneven_square(4);
    data.points.row(6) = data.points.row(1); // an inner vertex on the boundary
    const Mesh mesh = build_mesh(data);
    const DirichletBoundary held = dirichlet_boundary(mesh, {"bottom"});
    const Matrix moved = idw_extension(mesh, held)->extend(boundary_displacement(mesh, held, wavy));
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (mesh.numbering.vertex[static_cast<std::size_t>(v)] == 6) {
            EXPECT_EQ(moved.row(v), wavy(0.25, 0));
        }
}

TEST(IdwExtension, RefusesOptionsThatMakeNoSense)
{
    const Mesh mesh = build_mesh(test::uneven_square(4));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"top"});
    const auto refusal = [&](const IdwOptions& options) {
        return test::message_of([&] { idw_extension(mesh, held, options); });
    };
    EXPECT_THAT(refusal({0, 5, 0, 0.25}), HasSubstr("far exponent"));
    EXPECT_THAT(refusal({3, 2, 0, 0.25}), HasSubstr("near exponent"));
    EXPECT_THAT(refusal({3, 11, 0, 0.25}), HasSubstr("near exponent"));
    EXPECT_THAT(refusal({3, NAN, 0, 0.25}), HasSubstr("near exponent"));
    EXPECT_THAT(refusal({3, 5, -1, 0.25}), HasSubstr("reach"));
    EXPECT_THAT(refusal({3, 5, 0, -0.25}), HasSubstr("stiffness"));
    EXPECT_THAT(test::message_of([&] { idw_extension(mesh, {}); }), HasSubstr("no vertex is held"));
    EXPECT_THROW(idw_extension(mesh, held)->extend(Matrix::Zero(3, 2)), InputError);
}

} // namespace
