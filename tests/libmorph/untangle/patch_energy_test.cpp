#include "libmorph/untangle/patch_energy.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <random>
#include <vector>

namespace {

using namespace morph;

constexpr EnergyWeights kWeights{2, 1.3};

/// A mesh whose boundary is held, as one patch.
struct Case {
    explicit Case(const MeshData& data) : mesh(build_mesh(data)), stars(mesh), held(stars.vertex_of.size())
    {
        for (const VertexHandle v : mesh.kernel.vertices())
            held[static_cast<std::size_t>(v.idx())] = static_cast<char>(mesh.kernel.is_boundary(v));
        patch = find_patches(stars, held, {}, -1).at(0);
        set_targets(patch, stars, points(mesh), std::vector<char>(stars.elements.size()));
        for (const Index v : patch.vertices)
            x.emplace_back(points(mesh)(v, 0), points(mesh)(v, 1));
    }

    void shake(double size)
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> uniform(-size, size);
        for (Index i = 0; i < patch.free; ++i)
            x[static_cast<std::size_t>(i)] += std::complex<double>(uniform(random), uniform(random));
    }

    Mesh mesh;
    VertexStars stars;
    std::vector<char> held;
    Patch patch;
    PlanePositions x;
};

std::complex<double> unit(int component)
{
    return component == 0 ? std::complex<double>(1, 0) : std::complex<double>(0, 1);
}

Eigen::MatrixXd dense(const SymmetricMatrix& A)
{
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(A.rows(), A.rows());
    for (Index i = 0; i < A.rows(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        D(i, i) += A.diagonal[row];
        for (std::size_t e = A.start[row]; e < A.start[row + 1]; ++e)
            D(i, A.column[e]) += A.value[e];
    }
    return D;
}

double component(std::complex<double> z, int c)
{
    return c == 0 ? z.real() : z.imag();
}

Eigen::MatrixXd second_by_differences(const PatchEnergy& energy, const PlanePositions& x, Index free,
                                      double eps, double h)
{
    Eigen::MatrixXd H(2 * free, 2 * free);
    for (Index j = 0; j < 2 * free; ++j) {
        PlanePositions up = x, down = x;
        up[static_cast<std::size_t>(j / 2)] += h * unit(j % 2);
        down[static_cast<std::size_t>(j / 2)] -= h * unit(j % 2);
        const PlanePositions above = energy.model(up, eps).gradient, below = energy.model(down, eps).gradient;
        for (Index i = 0; i < 2 * free; ++i)
            H(i, j) =
                component(above[static_cast<std::size_t>(i / 2)] - below[static_cast<std::size_t>(i / 2)],
                          i % 2) /
                (2 * h);
    }
    return H;
}

TEST(PatchEnergy, IsTheNumberOfElementsWhereEveryElementIsItsTarget)
{
    for (const MeshData& data : {test::uneven_square(4), test::quad_square(4)}) {
        const Case c(data);
        const auto value = PatchEnergy(c.patch, kWeights).value(c.x, 0);
        double weights = 0;
        for (const TargetCorner& corner : c.patch.corners)
            weights += corner.weight;
        EXPECT_NEAR(value.energy, weights, 1e-12 * weights);
        EXPECT_NEAR(value.min_determinant, 1, 1e-12);
    }
}

TEST(PatchEnergy, HasTheGradientThatDifferencesOfItGive)
{
    for (const MeshData& data : {test::uneven_square(4), test::quad_square(4)}) {
        Case c(data);
        c.shake(0.3); // edges are 0.25: some elements are inverted
        const PatchEnergy energy(c.patch, kWeights);
        ASSERT_LT(energy.value(c.x, 1).min_determinant, 0);
        const PlanePositions exact = energy.model(c.x, 0.5).gradient;
        const double h = 1e-6;
        for (Index i = 0; i < 2 * c.patch.free; ++i) {
            PlanePositions up = c.x, down = c.x;
            up[static_cast<std::size_t>(i / 2)] += h * unit(i % 2);
            down[static_cast<std::size_t>(i / 2)] -= h * unit(i % 2);
            const double slope = (energy.value(up, 0.5).energy - energy.value(down, 0.5).energy) / (2 * h);
            const double expected = component(exact[static_cast<std::size_t>(i / 2)], i % 2);
            EXPECT_NEAR(slope, expected, 1e-5 * (1 + std::abs(expected)));
        }
    }
}

TEST(PatchEnergy, HasTheSecondDerivativesWhereTheyArePositive)
{
    // Every corner is at its least energy, where no eigenvalue is negative and nothing is taken away.
    for (const MeshData& data : {test::uneven_square(3), test::quad_square(3)}) {
        const Case c(data);
        const PatchEnergy energy(c.patch, kWeights);
        const Eigen::MatrixXd H = dense(energy.model(c.x, 1e-9).second);
        const Eigen::MatrixXd exact = second_by_differences(energy, c.x, c.patch.free, 1e-9, 1e-6);
        EXPECT_LT((H - exact).norm(), 1e-7 * exact.norm());
    }
}

TEST(PatchEnergy, HasASymmetricPositiveMatrixInATangle)
{
    for (const MeshData& data : {test::uneven_square(4), test::quad_square(4)}) {
        Case c(data);
        c.shake(0.3);
        const Eigen::MatrixXd H = dense(PatchEnergy(c.patch, kWeights).model(c.x, 0.3).second);
        EXPECT_LT((H - H.transpose()).norm(), 1e-14 * H.norm());
        EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues()[0], -1e-12 * H.norm());
    }
}

TEST(PatchEnergy, IsTheSameForAnyNumberOfThreads)
{
    Case c(test::quad_square(40));
    c.shake(0.02);
    const PatchEnergy energy(c.patch, kWeights);
    set_thread_count(1);
    const auto one = energy.value(c.x, 0.1);
    const auto model = energy.model(c.x, 0.1);
    set_thread_count(3);
    EXPECT_EQ(energy.value(c.x, 0.1).energy, one.energy);
    EXPECT_EQ(energy.model(c.x, 0.1).gradient, model.gradient);
    EXPECT_EQ(energy.model(c.x, 0.1).second.value, model.second.value);
    set_thread_count(0);
}

TEST(FindPatches, TakesTheRingsAroundAnElementAndNoMore)
{
    const Mesh mesh = build_mesh(test::quad_square(9));
    const VertexStars stars(mesh);
    const std::vector<char> held(stars.vertex_of.size());
    const auto near = [&](double x, double y) {
        for (Index f = 0; f < element_count(mesh); ++f) {
            Eigen::RowVector3d centre(0, 0, 0);
            for (const Index v : stars.elements[static_cast<std::size_t>(f)])
                centre += points(mesh).row(v) / 4;
            if (std::hypot(centre[0] - x, centre[1] - y) < 0.05)
                return f;
        }
        return Index{-1};
    };
    const auto one = find_patches(stars, held, {near(0.5, 0.5)}, 1);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].free, 16);             // 4 x 4 vertices
    EXPECT_EQ(one[0].elements.size(), 25U); // 5 x 5 elements
    EXPECT_EQ(one[0].vertices.size(), 36U); // 6 x 6 vertices
    const auto two = find_patches(stars, held, {near(1 / 18.0, 1 / 18.0), near(17 / 18.0, 17 / 18.0)}, 1);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_EQ(two[0].free, 9);
    EXPECT_EQ(find_patches(stars, held, {near(1 / 18.0, 1 / 18.0), near(17 / 18.0, 17 / 18.0)}, 3).size(),
              1U);
}

} // namespace
