#include "libmorph/untangle/corner_energy.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace morph;

using Four = Eigen::Vector4d; // real and imaginary parts of a and b

constexpr EnergyWeights kWeights{2, 1.3};

CornerMap map_of(const Four& z)
{
    return {{z[0], z[1]}, {z[2], z[3]}};
}

double energy(const Four& z, double eps)
{
    return corner_energy(map_of(z), eps, kWeights);
}

/// The gradient and the quadratic form of a model as a vector and a matrix.
Four gradient(const CornerModel& m)
{
    return {m.a_gradient.real(), m.a_gradient.imag(), m.b_gradient.real(), m.b_gradient.imag()};
}

Eigen::Matrix4d second(const CornerModel& m)
{
    const Four u(m.a_along.real(), m.a_along.imag(), 0, 0), v(-m.a_along.imag(), m.a_along.real(), 0, 0);
    const Four s(0, 0, m.b_along.real(), m.b_along.imag()), t(0, 0, -m.b_along.imag(), m.b_along.real());
    return m.aa * u * u.transpose() + m.ab * (u * s.transpose() + s * u.transpose()) +
           m.bb * s * s.transpose() + m.across_a * v * v.transpose() + m.across_b * t * t.transpose();
}

Four gradient_by_differences(const Four& z, double eps, double h)
{
    Four g;
    for (int i = 0; i < 4; ++i)
        g[i] = (energy(z + h * Four::Unit(i), eps) - energy(z - h * Four::Unit(i), eps)) / (2 * h);
    return g;
}

Eigen::Matrix4d second_by_differences(const Four& z, double eps, double h)
{
    Eigen::Matrix4d H;
    for (int i = 0; i < 4; ++i)
        H.col(i) = (gradient(corner_model(map_of(z + h * Four::Unit(i)), eps, kWeights)) -
                    gradient(corner_model(map_of(z - h * Four::Unit(i)), eps, kWeights))) /
                   (2 * h);
    return H;
}

/// What is left of a symmetric matrix without its negative eigenvalues.
Eigen::Matrix4d positive_part(const Eigen::Matrix4d& H)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(0.5 * (H + H.transpose()));
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
           eigen.eigenvectors().transpose();
}

/// Maps with positive and negative determinants, and those without a conformal or an anticonformal part.
std::vector<Four> some_maps()
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    std::vector<Four> maps{{1, 0, 0, 0}, {0.5, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0.3, -0.4}};
    for (int i = 0; i < 50; ++i)
        maps.emplace_back(normal(random), normal(random), normal(random), normal(random));
    return maps;
}

TEST(CornerEnergy, IsOneForARotationAndMoreForAnythingElse)
{
    EXPECT_DOUBLE_EQ(corner_energy({std::polar(1.0, 0.7), 0}, 0, kWeights), 1);
    for (const Four& z : some_maps())
        if (map_of(z).determinant() > 0 && std::abs(z.norm() - 1) > 1e-12) {
            EXPECT_GT(energy(z, 0), 1) << z.transpose();
        }
}

TEST(CornerEnergy, IsTheFormulaOfThePaperInTheEntriesOfTheMatrix)
{
    // J = [1 2; -0.5 3] as a z + b conj(z)
    const CornerMap map{{(1 + 3) / 2.0, (-0.5 - 2) / 2}, {(1 - 3) / 2.0, (-0.5 + 2) / 2}};
    const double det = 1 * 3 + 2 * 0.5, square = 1 + 4 + 0.25 + 9, eps = 0.3;
    EXPECT_DOUBLE_EQ(map.determinant(), det);
    const double chi = (det + std::sqrt(eps * eps + det * det)) / 2;
    EXPECT_NEAR(corner_energy(map, eps, {2, 1}), (square + 2 * (det * det + 1)) / chi / 6, 1e-14);
    EXPECT_NEAR(corner_energy(map, eps, {2, 1.3}), std::pow((square + 2 * (det * det + 1)) / chi / 6, 1.3),
                1e-13);
}

TEST(CornerEnergy, GrowsWithoutBoundTowardsAFlatCornerWhereEpsIsNothing)
{
    EXPECT_GT(energy({1, 0, 1 - 1e-6, 0}, 0), 1e6);
}

TEST(CornerModel, HasTheGradientThatDifferencesOfTheEnergyGive)
{
    for (const Four& z : some_maps())
        for (const double eps : {0.1, 1.0}) {
            const Four exact = gradient(corner_model(map_of(z), eps, kWeights));
            const double h =
                1e-5; // error h^2 times third derivatives over eps^2, and 1e-16 / h from rounding
            EXPECT_LT((gradient_by_differences(z, eps, h) - exact).norm(), 1e-6 * (1 + exact.norm()))
                << z.transpose() << " eps " << eps;
        }
}

TEST(CornerModel, HasThePositivePartOfTheSecondDerivatives)
{
    for (const Four& z : some_maps())
        for (const double eps : {0.1, 1.0}) {
            const Eigen::Matrix4d exact = positive_part(second_by_differences(z, eps, 1e-5));
            const Eigen::Matrix4d H = second(corner_model(map_of(z), eps, kWeights));
            EXPECT_LT((H - exact).norm(), 1e-5 * (1 + exact.norm())) << z.transpose() << " eps " << eps;
        }
}

TEST(Regularized, IsTheFormulaWithoutItsCancellation)
{
    EXPECT_DOUBLE_EQ(regularized(3, 4), 4);
    EXPECT_DOUBLE_EQ(regularized(-3, 4), 1);
    EXPECT_DOUBLE_EQ(regularized(0, 1e-9), 0.5e-9);
    EXPECT_NEAR(regularized(-1e6, 1e-3) / 2.5e-13, 1, 1e-9); // eps^2 / (4 |D|)
    EXPECT_DOUBLE_EQ(regularized(2, 0), 2);
}

} // namespace
