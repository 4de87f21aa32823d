#include "libmorph/weights/elasticity.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/boundary_values.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace {

using namespace morph;
using test::values_at;
using test::whole_boundary;

constexpr double kSolveTol = 1e-11; // one sparse solve of some hundred unknowns

class ElasticExtensionOf : public testing::TestWithParam<MeshData (*)(Index)> {};

INSTANTIATE_TEST_SUITE_P(Squares, ElasticExtensionOf,
                         testing::Values(&test::uneven_square, &test::quad_square));

TEST_P(ElasticExtensionOf, ASquareFollowsEveryAffineMoveOfItsBoundary)
{
    const Mesh mesh = build_mesh(GetParam()(12));
    const DirichletBoundary held = whole_boundary(mesh, "top");
    const auto affine = [](double x, double y) {
        return Eigen::RowVector2d(0.1 + 0.5 * x - 2 * y, -3 + 0.4 * x + 0.9 * y);
    };
    for (const double ratio : {-0.9, 0.0, 0.3, 0.49}) {
        const auto extension = elastic_extension(mesh, held, {YoungsModulus::uniform, ratio});
        const Matrix exact = values_at(mesh, affine);
        EXPECT_LE((extension->extend(values_at(mesh, held.vertices, affine)) - exact).norm(),
                  kSolveTol * exact.norm())
            << ratio;
    }
}

constexpr double kRatio = 0.2;

/// A displacement without body force in plane strain: kappa phi - z conj(phi') with phi = z^2 and
/// kappa = 3 - 4 nu [Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, section
/// 32].
Eigen::RowVector2d without_force(double x, double y)
{
    const std::complex<double> z(x, y);
    const std::complex<double> w = (3 - 4 * kRatio) * z * z - 2 * std::norm(z);
    return {w.real(), w.imag()};
}

/// Root mean square error against without_force().
double error_of(const MeshData& data)
{
    const Mesh mesh = build_mesh(data);
    const DirichletBoundary held = whole_boundary(mesh, "top");
    const auto extension = elastic_extension(mesh, held, {YoungsModulus::uniform, kRatio});
    const Points2 u = extension->extend(values_at(mesh, held.vertices, without_force));
    return (u - values_at(mesh, without_force)).norm() / std::sqrt(static_cast<double>(u.rows()));
}

TEST_P(ElasticExtensionOf, ASquareConvergesToTheExactSolutionWithOrderTwo)
{
    const double coarse = error_of(GetParam()(10)), middle = error_of(GetParam()(20)),
                 fine = error_of(GetParam()(40));
    EXPECT_LE(fine, 2e-3); // the displacement is of size 1
    EXPECT_NEAR(std::log2(coarse / middle), 2, 0.3);
    EXPECT_NEAR(std::log2(middle / fine), 2, 0.3);
}

// Integrated exactly, the stiffness of a square element is (lambda + 3 mu) / 3 at a corner, and -1/2 of that
// and
// -(lambda + mu) / 4 between opposite corners along the same and across the axes; four elements meet here.
TEST(ElasticExtension, HasTheStiffnessOfBilinearQuads)
{
    MeshData data = test::quad_square(2);
    data.points.row(4) << 0.5, 0.5, 0;
    const Mesh mesh = build_mesh(data);
    const DirichletBoundary held = whole_boundary(mesh, "top");
    const auto corner_pulled = [](double x, double y) {
        return Eigen::RowVector2d(x == 1 && y == 1 ? 1 : 0, 0);
    };
    const double ratio = 0.25; // lambda = mu
    const Points2 u = elastic_extension(mesh, held, {YoungsModulus::uniform, ratio})
                          ->extend(values_at(mesh, held.vertices, corner_pulled));
    for (Index v = 0; v < 9; ++v)
        if (!mesh.kernel.is_boundary(VertexHandle(v))) {
            EXPECT_LE((u.row(v) - Eigen::RowVector2d(1.0 / 8, 3.0 / 32)).norm(), 1e-15);
        }
}

/// Elements of a mesh with an airfoil turned over when that turns by this angle.
Index inverted_by_turning(const std::string& file, double degrees, YoungsModulus modulus)
{
    const Mesh mesh = read_mesh(test::data_path("meshes/" + file + ".su2"));
    const DirichletBoundary held = whole_boundary(mesh, "airfoil");
    const Points2 turned = values_at(mesh, held.vertices, test::turned_airfoil(degrees));
    return test::inverted_by(mesh, elastic_extension(mesh, held, {modulus, 0.3})->extend(turned));
}

TEST(ElasticExtension, TurnsAnAirfoilWithoutInvertedElementsWhenStiffNearIt)
{
    for (const char* file : {"naca0012_inv", "naca0012_lam_hybrid"}) {
        EXPECT_EQ(inverted_by_turning(file, 90, YoungsModulus::inverse_area), 0) << file;
        EXPECT_EQ(inverted_by_turning(file, 45, YoungsModulus::inverse_distance), 0) << file;
        EXPECT_GT(inverted_by_turning(file, 45, YoungsModulus::uniform), 200) << file;
    }
}

TEST(ElasticExtension, RefusesWhatIsNoSolidAtRest)
{
    MeshData data = test::uneven_square(6);
    const Mesh mesh = build_mesh(data);
    const DirichletBoundary held = whole_boundary(mesh, "top");
    for (const double ratio : {-1.0, 0.5, std::nan("")})
        EXPECT_THROW(elastic_extension(mesh, held, {YoungsModulus::uniform, ratio}), InputError);
    DirichletBoundary still = held;
    still.moving_edges.clear();
    EXPECT_THROW(elastic_extension(mesh, still, {YoungsModulus::inverse_distance, 0.3}), InputError);
    DirichletBoundary hinged;
    hinged.vertices = {held.vertices.front()};
    EXPECT_THAT(test::message_of([&] { elastic_extension(mesh, hinged, {}); }),
                testing::StartsWith("1 part of the mesh has fewer than 2 held vertices"));
    Mesh tangled = mesh;
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (!mesh.kernel.is_boundary(VertexHandle(v))) {
            points(tangled)(v, 0) += 0.4;
            break;
        }
    EXPECT_THROW(elastic_extension(tangled, held, {}), InputError);
}

} // namespace
