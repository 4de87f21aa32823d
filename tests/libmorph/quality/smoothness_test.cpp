#include "libmorph/quality/smoothness.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace {

using namespace morph;

Points moved_by(const Mesh& mesh, const std::function<Eigen::Vector2d(double, double)>& move)
{
    Points after = points(mesh);
    for (Index v = 0; v < after.rows(); ++v)
        after.row(v).head<2>() += move(points(mesh)(v, 0), points(mesh)(v, 1)).transpose();
    return after;
}

TEST(DirichletEnergy, OfALinearDisplacementIsHalfItsSquaredGradientTimesTheArea)
{
    const auto linear = [](double x, double y) { return Eigen::Vector2d(1 + 2 * x - y, 3 * y); };
    const double exact = (2.0 * 2 + 1 * 1 + 3 * 3) / 2; // on the unit square
    for (const MeshData& data : {test::uneven_square(7), test::quad_square(7)}) {
        const Mesh mesh = build_mesh(data);
        EXPECT_NEAR(dirichlet_energy(mesh, points(mesh), moved_by(mesh, linear)), exact, 1e-12);
    }
}

TEST(DirichletEnergy, OfATranslationIsNothing)
{
    const Mesh mesh = build_mesh(test::quad_square(4));
    const Points after = moved_by(mesh, [](double, double) { return Eigen::Vector2d(5, -3); });
    EXPECT_NEAR(dirichlet_energy(mesh, points(mesh), after), 0, 1e-24);
}

TEST(DirichletEnergy, ConvergesToTheIntegralOfASmoothDisplacement)
{
    // d = sin(x) y: |grad d|^2 = cos^2(x) y^2 + sin^2(x), over the unit square.
    const double exact = ((1 + std::sin(2.0) / 2) / 2 / 3 + (1 - std::sin(2.0) / 2) / 2) / 2;
    std::vector<double> errors;
    for (const Index cells : {16, 32}) {
        const Mesh mesh = build_mesh(test::uneven_square(cells));
        const Points after =
            moved_by(mesh, [](double x, double y) { return Eigen::Vector2d(std::sin(x) * y, 0); });
        const double error = std::abs(dirichlet_energy(mesh, points(mesh), after) - exact);
        EXPECT_LT(error, 1e-3);
        errors.push_back(error);
    }
    EXPECT_LT(errors[1], errors[0] / 3); // second order
}

TEST(DirichletEnergy, RefusesPositionsOfAnotherMesh)
{
    const Mesh mesh = build_mesh(test::quad_square(1));
    const Points few = Points::Zero(3, 3);
    EXPECT_EQ(test::message_of([&] { dirichlet_energy(mesh, points(mesh), few); }),
              "there are 3 positions, but the mesh has 4 vertices");
}

} // namespace
