#include "libmorph/remap/conserve_nodes.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remap/integral.h"
#include "tests/support/dense_projection.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"
#include "tests/support/random_meshes.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace {

using namespace morph;
using Function = std::function<double(double, double)>;

/// Of the integral of the field's magnitude: what conservation means here.
constexpr double kConserved = 1e-12;

Matrix nodal(const Mesh& mesh, const Function& f)
{
    Matrix values(vertex_count(mesh), 1);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        values(v, 0) = f(points(mesh)(v, 0), points(mesh)(v, 1));
    return values;
}

Matrix random_values(const Mesh& mesh, Eigen::Index columns, unsigned seed)
{
    std::mt19937 random(seed);
    Matrix values(vertex_count(mesh), columns);
    for (Eigen::Index i = 0; i < values.size(); ++i)
        values.data()[i] = static_cast<double>(random()) / 2147483648.0 - 1;
    return values;
}

Transfer carried(const Mesh& source, const Mesh& target, const Matrix& values)
{
    return conserve_nodes(Locator(source), target, values);
}

/// Whether just one of two random meshes is made of slivers, 1e-12 thin. What they have in common with
/// ordinary elements rounding of the coordinates moves by 1e-4 of itself.
bool slivers_meet_others(std::uint32_t a, std::uint32_t b)
{
    return (test::some_settings(a).thinness != 1) != (test::some_settings(b).thinness != 1);
}

TEST(ConserveNodes, IsTheDenseProjectionWhereTheSourceCoversTheTarget)
{
    constexpr double kSolve = 1e-12; // condition number of M scaled by its diagonal is at most 4
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const Mesh source = build_mesh(seed % 2 == 0 ? test::uneven_square(6) : test::quad_square(5));
        const Mesh target = build_mesh(test::random_mesh(test::some_settings(seed)));
        const Matrix values = random_values(source, 1, seed);
        const test::DenseProjection dense = test::dense_projection(source, target);
        Eigen::VectorXd scale = dense.M.diagonal();
        scale = (scale.array() > 0).select(scale.array().rsqrt(), 0);
        Eigen::MatrixXd scaled = scale.asDiagonal() * dense.M * scale.asDiagonal();
        scaled.diagonal() = (scale.array() > 0).select(scaled.diagonal(), 1.0); // vertices of no element
        const Eigen::VectorXd exact =
            scale.asDiagonal() * scaled.llt().solve(scale.asDiagonal() * (dense.B * values));
        EXPECT_LE((carried(source, target, values).values - exact).norm(), kSolve * exact.norm())
            << "seed " << seed;
    }
}

TEST(ConserveNodes, PreservesTheIntegralOverTheCommonRegionOnRandomMeshes)
{
    for (std::uint32_t seed = 1; seed <= 400; ++seed) {
        const std::uint32_t other = 3 + 5 * seed;
        if (slivers_meet_others(seed, other))
            continue;
        const Mesh source = build_mesh(test::random_mesh(test::some_settings(seed)));
        const Mesh target = build_mesh(test::random_mesh(test::some_settings(other)));
        const Matrix values = random_values(source, 2, seed);
        const test::DenseProjection dense = test::dense_projection(source, target);
        const Transfer transfer = carried(source, target, values);
        const Eigen::RowVectorXd of_source = dense.B.colwise().sum() * values;
        const Eigen::RowVectorXd of_target = dense.M.colwise().sum() * transfer.values;
        const double magnitude = (dense.B.colwise().sum() * values.cwiseAbs()).norm();
        EXPECT_LE((of_source - of_target).norm(), kConserved * magnitude) << "seed " << seed;
        EXPECT_LE((of_source - transfer.source_integral).norm(), kConserved * magnitude) << "seed " << seed;
    }
}

TEST(ConserveNodes, PreservesTheIntegralBetweenMeshesThousandfoldDifferentInSize)
{
    MeshData data = test::quad_square(1);
    data.points.leftCols(2) = 4 * data.points.leftCols(2).array() - 1;
    const Mesh fine = build_mesh(test::uneven_square(250)), coarse = build_mesh(data);
    const auto integral = [](const Transfer& transfer) {
        const Eigen::Map<const Eigen::VectorXd> weights(transfer.covered.data(), transfer.values.rows());
        return weights.dot(transfer.values.col(0));
    };
    const Field on_fine{"f", FieldLocation::vertex, random_values(fine, 1, 2)};
    const Transfer up = carried(fine, coarse, on_fine.values);
    EXPECT_NEAR(up.covered_area, 1, kConserved);
    EXPECT_NEAR(integral(up), field_totals(fine, on_fine).integral[0], kConserved);

    // The diagonal of the coarse quad halves the square; its function is linear in each half.
    const Matrix on_coarse = nodal(coarse, [](double x, double y) { return std::sin(x + 3 * y); });
    const auto at = [](double x, double y) { return std::sin(x + 3 * y); };
    const double exact = at(-1, -1) * 7 / 12 + at(3, 3) / 3 + (at(3, -1) + at(-1, 3)) / 24;
    const Transfer down = carried(coarse, fine, on_coarse);
    EXPECT_NEAR(down.covered_area, 1, kConserved);
    EXPECT_NEAR(integral(down), exact, kConserved);
}

TEST(ConserveNodes, ReproducesConstantAndLinearFunctionsOnRandomMeshes)
{
    constexpr double kConstant = 1e-14;
    constexpr double kLinear = 1e-11; // the source continued from as little as 1e-5 of a triangle's width
    const auto linear = [](double x, double y) { return 1 + 2 * x - 3 * y; };
    for (std::uint32_t seed = 1; seed <= 500; ++seed) {
        const std::uint32_t other = 3 + 5 * seed;
        const Mesh source = build_mesh(test::random_mesh(test::some_settings(seed)));
        const Mesh target = build_mesh(test::random_mesh(test::some_settings(other)));
        Matrix values(vertex_count(source), 2);
        values << Matrix::Constant(vertex_count(source), 1, 1e5), nodal(source, linear);
        const Transfer transfer = carried(source, target, values);
        const Matrix exact = nodal(target, linear);
        for (Index v = 0; v < vertex_count(target); ++v) {
            const bool covered = transfer.covered[static_cast<std::size_t>(v)] > 0;
            EXPECT_NEAR(transfer.values(v, 0), covered ? 1e5 : 0, 1e5 * kConstant) << "seed " << seed;
            if (covered && !slivers_meet_others(seed, other)) {
                EXPECT_NEAR(transfer.values(v, 1), exact(v, 0), kLinear) << "seed " << seed;
            }
        }
    }
}

/// Largest error of a smooth function at all covered vertices, and the root of its mean square.
Eigen::Array2d smooth_error(const Mesh& source, const Mesh& target)
{
    const auto smooth = [](double x, double y) { return std::sin(2 * x) * std::exp(y / 2) + x * y; };
    const Transfer transfer = carried(source, target, nodal(source, smooth));
    const Matrix error = transfer.values - nodal(target, smooth);
    Eigen::Array2d found(0, 0);
    double count = 0;
    for (Index v = 0; v < vertex_count(target); ++v)
        if (transfer.covered[static_cast<std::size_t>(v)] > 0) {
            found[0] = std::max(found[0], std::abs(error(v, 0)));
            found[1] += error(v, 0) * error(v, 0);
            ++count;
        }
    found[1] = std::sqrt(found[1] / count);
    return found;
}

/// Orders of convergence in the maximum and the mean square, over three refinements.
Eigen::Array2d order(const std::function<Eigen::Array2d(Index)>& error_with_cells, Index coarsest)
{
    return (error_with_cells(coarsest) / error_with_cells(8 * coarsest)).log() / std::log(8.0);
}

TEST(ConserveNodes, ConvergesAtSecondOrderForSmoothFunctions)
{
    const Eigen::Array2d to_triangles = order(
        [](Index n) {
            return smooth_error(build_mesh(test::quad_square(6 * n / 5)), build_mesh(test::uneven_square(n)));
        },
        10);
    const Eigen::Array2d to_quads = order(
        [](Index n) {
            return smooth_error(build_mesh(test::uneven_square(7 * n / 5)), build_mesh(test::quad_square(n)));
        },
        10);
    for (const Eigen::Array2d& found : {to_triangles, to_quads}) {
        EXPECT_GT(found[0], 1.7); // largest errors jump about a little between meshes
        EXPECT_GT(found[1], 1.95);
        EXPECT_LT(found.maxCoeff(), 2.2);
    }
}

TEST(ConserveNodes, IsOfSecondOrderAlsoAtVerticesThatTheSourceHardlyCovers)
{
    // Continued linearly by up to a diagonal of a cell of the target, sqrt(2) h, a function is off by up to
    // |D^2 u| h^2; no second derivative of this one is above 11 there. How close the worst vertex comes to
    // that differs from mesh to mesh.
    constexpr double kSecondDerivative = 11;
    for (const Index cells : {20, 40, 80, 160}) {
        const double h = 4.2 / cells;
        MeshData data = test::uneven_square(cells);
        data.points.leftCols(2) = 4.2 * data.points.leftCols(2).array() - 2.1; // around the annulus
        const Eigen::Array2d error =
            smooth_error(build_mesh(test::uneven_annulus(0.5, 2, 4 * cells)), build_mesh(data));
        EXPECT_LE(error[0], kSecondDerivative * h * h) << cells << " cells";
        EXPECT_LE(error[1], h * h) << cells << " cells";
    }
}

TEST(ConserveNodes, OntoTheMeshItselfIsTheIdentity)
{
    constexpr double kSolve = 1e-14; // of values up to 1
    for (const MeshData& data : {test::uneven_square(20), test::quad_square(20), test::touching_squares(5)}) {
        const Mesh mesh = build_mesh(data);
        const Matrix values = random_values(mesh, 3, 1);
        EXPECT_LE((carried(mesh, mesh, values).values - values).cwiseAbs().maxCoeff(), kSolve);
    }
}

TEST(ConserveNodes, CarriesEachComponentAsIfAlone)
{
    const Mesh source = build_mesh(test::uneven_annulus(1, 3, 60)),
               target = build_mesh(test::annulus(0.8, 2.5, 50, 12));
    const Matrix values = random_values(source, 9, 6);
    const Matrix together = carried(source, target, values).values;
    for (Eigen::Index k = 0; k < 9; ++k)
        EXPECT_EQ(carried(source, target, values.col(k)).values, together.col(k));
}

TEST(ConserveNodes, TellsWhichVerticesNothingCovers)
{
    constexpr double kSum = 1e-14; // of a few hundred areas
    const Mesh source = build_mesh(test::uneven_square(10));
    MeshData data = test::quad_square(10);
    data.points.col(0).array() += 0.55;
    data.points.conservativeResize(122, 3);
    data.points.row(121) << 0.6, 0.6, 0; // of no element
    const Mesh target = build_mesh(data);
    const Transfer transfer = carried(source, target, Matrix::Ones(vertex_count(source), 1));
    EXPECT_NEAR(transfer.covered_area, 0.45, kSum);
    EXPECT_NEAR(transfer.target_area, 1, kSum);
    EXPECT_NEAR(transfer.source_area, 1, kSum);
    double sum = 0;
    for (Index v = 0; v < vertex_count(target); ++v) {
        sum += transfer.covered[static_cast<std::size_t>(v)];
        if (target.kernel.is_isolated(VertexHandle(v))) {
            EXPECT_EQ(transfer.covered[static_cast<std::size_t>(v)], 0);
            continue;
        }
        bool touched = false;
        for (const FaceHandle face : target.kernel.vf_range(VertexHandle(v)))
            for (const VertexHandle corner : target.kernel.fv_range(face))
                touched |= points(target)(corner.idx(), 0) < 1;
        EXPECT_EQ(transfer.values(v, 0) != 0, touched);
        EXPECT_EQ(transfer.covered[static_cast<std::size_t>(v)] > 0, touched);
    }
    EXPECT_NEAR(sum, 0.45, kSum);
}

TEST(ConserveNodes, GivesTheSameBytesForAnyThreadCount)
{
    const Mesh source = build_mesh(test::uneven_annulus(1, 3, 200));
    const Mesh target = build_mesh(test::annulus(0.8, 2.5, 190, 50));
    const Matrix values = random_values(source, 2, 1);
    set_thread_count(1);
    const Transfer one = carried(source, target, values);
    set_thread_count(5);
    const Transfer five = carried(source, target, values);
    set_thread_count(0);
    EXPECT_EQ(one.values, five.values);
    EXPECT_EQ(one.covered, five.covered);
    EXPECT_EQ(one.covered_area, five.covered_area);
}

TEST(ConserveNodes, RefusesValuesOfAnotherMesh)
{
    const Mesh mesh = build_mesh(test::quad_square(2));
    EXPECT_EQ(test::message_of([&] { carried(mesh, mesh, Matrix::Zero(4, 1)); }),
              "there are 4 rows of nodal values, but the source has 9 vertices");
}

} // namespace
