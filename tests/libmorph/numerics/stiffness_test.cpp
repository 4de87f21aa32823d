#include "libmorph/numerics/stiffness.h"

#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace morph;

// Sums of about seven entries of size 1.
constexpr double kRoundOff = 1e-14;

std::vector<WeightedEdge> delaunay_edges(const Mesh& mesh)
{
    Triangulation triangulation = triangulate(mesh);
    make_delaunay(points(mesh), triangulation);
    return stiffness_edges(points(mesh), triangulation);
}

class StiffnessOf : public testing::TestWithParam<MeshData (*)(Index)> {
protected:
    Mesh mesh = build_mesh(GetParam()(12));
    Eigen::SparseMatrix<double> K = stiffness_matrix(vertex_count(mesh), delaunay_edges(mesh));
};

TEST_P(StiffnessOf, TheSquareIsSymmetricWithRowsThatSumToZero)
{
    EXPECT_EQ((Eigen::MatrixXd(K) - Eigen::MatrixXd(K).transpose()).norm(), 0);
    EXPECT_LE((K * Eigen::VectorXd::Ones(K.cols())).norm(), kRoundOff * K.norm());
}

TEST_P(StiffnessOf, TheSquareMapsAffineFunctionsToZeroInside)
{
    const Eigen::VectorXd affine = points(mesh) * Eigen::Vector3d(0.7, -1.3, 0);
    const Eigen::VectorXd residual = K * affine;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (!mesh.kernel.is_boundary(v)) {
            EXPECT_NEAR(residual[v.idx()], 0, kRoundOff);
        }
}

TEST_P(StiffnessOf, TheSquareHasTheDirichletEnergyOfAnAffineFunction)
{
    const Eigen::VectorXd affine = points(mesh) * Eigen::Vector3d(3, 4, 0);
    EXPECT_NEAR(affine.dot(K * affine), 25, 25 * kRoundOff); // |gradient|^2 times the area
}

INSTANTIATE_TEST_SUITE_P(Meshes, StiffnessOf, testing::Values(&test::uneven_square, &test::quad_square));

TEST(StiffnessEdges, AreTheCotangentsOfOneTriangle)
{
    Points points(3, 3);
    points << 0, 0, 0, 4, 0, 0, 1, 2, 0;
    const Triangulation one{{{0, 1, 2}}, {{-1, -1, -1}}};
    const Eigen::MatrixXd K = stiffness_matrix(3, stiffness_edges(points, one));
    const auto half_cot = [](double angle) { return 0.5 / std::tan(angle); };
    EXPECT_NEAR(K(1, 2), -half_cot(std::atan2(2, 1)), kRoundOff);
    EXPECT_NEAR(K(0, 2), -half_cot(std::atan2(2, 3)), kRoundOff);
    EXPECT_NEAR(K(0, 1), -half_cot(std::numbers::pi - std::atan2(2, 1) - std::atan2(2, 3)), kRoundOff);
}

TEST(StiffnessEdges, AreNeverNegativeOnRealMeshes)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        for (const WeightedEdge& e : delaunay_edges(mesh)) {
            ASSERT_TRUE(std::isfinite(e.weight));
            ASSERT_GE(e.weight, 0);
        }
    }
}

// Clamping must do no more than take away rounding: where it did more, affine functions would no longer be
// in the kernel. The size of the weights is the scale: 1e5 and more in boundary layers.
TEST(StiffnessEdges, KeepAffineFunctionsInTheKernelOnRealMeshes)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const auto edges = delaunay_edges(mesh);
        const auto x = points(mesh);
        Points residual = Points::Zero(x.rows(), 3), size = Points::Zero(x.rows(), 3);
        for (const WeightedEdge& e : edges) {
            const Eigen::RowVector3d flux = e.weight * (x.row(e.a) - x.row(e.b));
            residual.row(e.a) += flux;
            residual.row(e.b) -= flux;
            size.row(e.a) += Eigen::RowVector3d::Constant(flux.norm());
            size.row(e.b) += Eigen::RowVector3d::Constant(flux.norm());
        }
        double worst = 0;
        for (const VertexHandle v : mesh.kernel.vertices())
            if (!mesh.kernel.is_boundary(v))
                worst = std::max(worst, residual.row(v.idx()).norm() / size.row(v.idx()).norm());
        EXPECT_LE(worst, 1e-9);
    }
}

TEST(StiffnessEdges, CountAFlatTriangleAsEquilateral)
{
    Points points(3, 3);
    points << 0, 0, 0, 1, 0, 0, 2, 0, 0;
    const Triangulation one{{{0, 1, 2}}, {{-1, -1, -1}}};
    for (const WeightedEdge& e : stiffness_edges(points, one))
        EXPECT_NEAR(e.weight, 0.5 / std::sqrt(3), kRoundOff);
}

} // namespace
