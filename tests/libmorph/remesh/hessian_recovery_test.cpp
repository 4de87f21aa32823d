#include "libmorph/remesh/hessian_recovery.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/target_size.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morph {
namespace {

TEST(SecondDerivative, IsExactForAQuadraticAlsoAtTheBoundaryAndOnStretchedElements)
{
    for (const double height : {1.0, 1e-4}) {
        MeshData data = test::uneven_square(8);
        data.points.col(1) *= height;
        const Mesh mesh = build_mesh(data);
        const auto place = points(mesh);
        const Eigen::ArrayXd x = place.col(0), y = place.col(1) / height;
        // Eigenvalues of [[2, 3], [3, -4]] are -1 +- sqrt(18); stretched, that across the layer grows.
        const Eigen::VectorXd field = 7 + x - 2 * y + x * x + 3 * x * y - 2 * y * y;
        const double a = 2, b = 3 / height, c = -4 / height / height;
        const double exact = std::abs((a + c) / 2) + std::hypot((a - c) / 2, b);
        const Eigen::VectorXd found = largest_second_derivative(mesh, field);
        // The fit shrinks what it finds by 1e-10 of the trace of its equations.
        EXPECT_LE((found.array() - exact).abs().maxCoeff(), 1e-7 * exact) << height;
    }
}

TEST(SecondDerivative, OfHeightOnAUnitSphereIsTheHeight)
{
    // On the unit sphere the Hessian of z is -z times the metric.
    constexpr Index kRows = 60, kColumns = 120;
    MeshData data;
    data.dimension = 3;
    data.points.resize(Eigen::Index{kRows} * kColumns, 3);
    for (Index i = 0; i < kRows; ++i)
        for (Index j = 0; j < kColumns; ++j) {
            const double polar = std::numbers::pi * (0.1 + 0.8 * i / (kRows - 1));
            const double turn = 2 * std::numbers::pi * j / kColumns;
            data.points.row(i * kColumns + j) << std::sin(polar) * std::cos(turn),
                std::sin(polar) * std::sin(turn), std::cos(polar);
            const Index right = i * kColumns + (j + 1) % kColumns;
            if (i + 1 == kRows)
                continue;
            data.elements.push_back({i * kColumns + j, (i + 1) * kColumns + j, right + kColumns, -1});
            data.elements.push_back({i * kColumns + j, right + kColumns, right, -1});
        }
    const Mesh mesh = build_mesh(data);
    const Eigen::VectorXd height = points(mesh).col(2);
    const Eigen::VectorXd found = largest_second_derivative(mesh, height);
    // At the two open borders the fit is one-sided: first order in the spacing of 0.05.
    for (Index v = 0; v < vertex_count(mesh); ++v)
        EXPECT_NEAR(found[v], std::abs(height[v]), mesh.kernel.is_boundary(VertexHandle(v)) ? 0.05 : 0.01);
}

TEST(InterpolationSizes, AreThePowerOfMinusOneThirdOfTheLargestSecondDerivative)
{
    const Mesh mesh = build_mesh(test::uneven_square(40));
    const Eigen::ArrayXd x = points(mesh).col(0).array() + 1;
    const Eigen::VectorXd sizes = interpolation_sizes(mesh, x.pow(3).matrix());
    const Eigen::ArrayXd expected = x.pow(-1.0 / 3); // of 6 x
    const double ratio = sizes[0] / expected[0];
    // The cubic's third derivative times the spacing of 1/40, a third of that in the power.
    EXPECT_LE((sizes.array() / (ratio * expected) - 1).abs().maxCoeff(), 0.03);
}

TEST(InterpolationSizes, AreEqualForALinearFieldAndCountEachComponentByItsRange)
{
    const Mesh mesh = build_mesh(test::uneven_square(20));
    const Eigen::VectorXd x = points(mesh).col(0);
    const Eigen::VectorXd flat = interpolation_sizes(mesh, 3 * x);
    EXPECT_EQ(flat.minCoeff(), flat.maxCoeff());
    const Eigen::VectorXd bent = (4 * x.array()).exp();
    Matrix both(x.size(), 2);
    both << 1e9 * x, 1e-9 * bent;
    const Eigen::VectorXd one = interpolation_sizes(mesh, bent), two = interpolation_sizes(mesh, both);
    EXPECT_LE((one - two).norm(), 1e-6 * one.norm()); // rounding of the linear one
}

} // namespace
} // namespace morph
