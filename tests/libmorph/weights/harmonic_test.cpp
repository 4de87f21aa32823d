#include "libmorph/weights/harmonic.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/delaunay.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/numerics/stiffness.h"
#include "tests/support/harmonic.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace {

using namespace morph;
using std::numbers::pi;
using test::BoundaryValues;
using test::harmonic_functions;
using test::prescribe_boundary;
using test::uneven_annulus;
using test::x_of;
using test::y_of;

// One sparse solve of a well-conditioned system loses a few digits; n is some hundreds or thousands here.
constexpr double kSolveTol = 1e-12;

// Each value passes through some thousand operations between numbers of one sign, whatever the mesh.
constexpr double kBoundTol = 1e-13;

constexpr Diffusivity kDiffusivities[] = {Diffusivity::uniform, Diffusivity::inverse_distance,
                                          Diffusivity::inverse_area};

constexpr double kInner = 0.5;
constexpr double kOuter = 3;

Eigen::RowVector3d affine(double x, double y)
{
    return {1.0, 0.3 * x - 2 * y + 0.7, 5 * y - x};
}

/// Three functions not below zero that sum to 1.
Eigen::RowVector3d partition(double x, double y)
{
    const double s = 0.5 + 0.5 * std::sin(3 * x), t = 0.5 + 0.5 * std::cos(2 * y);
    return {s * t, s * (1 - t), 1 - s};
}

class HarmonicWeightsOf : public testing::TestWithParam<MeshData (*)(Index)> {};

TEST_P(HarmonicWeightsOf, ASquareReproduceAffineFunctions)
{
    const Mesh mesh = build_mesh(GetParam()(20));
    const Matrix h = harmonic_functions(mesh, prescribe_boundary(mesh, "top", affine), Diffusivity::uniform);
    Matrix exact(h.rows(), 3);
    for (Index v = 0; v < h.rows(); ++v)
        exact.row(v) = affine(x_of(mesh, v), y_of(mesh, v));
    EXPECT_LE((h - exact).norm(), kSolveTol * exact.norm());
}

INSTANTIATE_TEST_SUITE_P(Meshes, HarmonicWeightsOf,
                         testing::Values(&test::uneven_square, &test::quad_square));

class HarmonicWeightsFor : public testing::TestWithParam<Diffusivity> {
protected:
    Matrix solve(const Mesh& mesh, const BoundaryValues& problem) const
    {
        return harmonic_functions(mesh, problem, GetParam());
    }
};

INSTANTIATE_TEST_SUITE_P(Diffusivities, HarmonicWeightsFor, testing::ValuesIn(kDiffusivities));

TEST_P(HarmonicWeightsFor, EveryRealMeshKeepTheirBoundsAndSum)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const Matrix h = solve(mesh, prescribe_boundary(mesh, mesh.markers.front().name, partition));
        // Eliminating an M-matrix adds numbers of one sign only, so that rounding cannot go below zero.
        EXPECT_GE(h.minCoeff<Eigen::PropagateNaN>(), 0);
        const auto sum = h.rowwise().sum().array();
        EXPECT_LE((sum - 1).abs().maxCoeff<Eigen::PropagateNaN>(), kBoundTol);
        EXPECT_LE(h.maxCoeff<Eigen::PropagateNaN>(), 1 + kBoundTol);
    }
}

TEST_P(HarmonicWeightsFor, StretchedCellsKeepTheirBounds)
{
    MeshData data = test::uneven_square(30);
    data.points.col(1) *= 1e-5;
    const Mesh mesh = build_mesh(data);
    const Matrix h = solve(mesh, prescribe_boundary(mesh, "bottom", partition));
    EXPECT_GE(h.minCoeff<Eigen::PropagateNaN>(), 0);
    EXPECT_LE((h.rowwise().sum().array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), kBoundTol);
}

TEST_P(HarmonicWeightsFor, DataThatAreCombinedAreCombined)
{
    const Mesh mesh = build_mesh(uneven_annulus(kInner, kOuter, 40));
    BoundaryValues problem = prescribe_boundary(mesh, "inner", affine);
    const Matrix h = solve(mesh, problem);
    Eigen::Matrix<double, 3, 2> mix;
    mix << 1, 2, -3, 4, 0.5, 0;
    problem.values = (problem.values * mix).eval();
    EXPECT_LE((solve(mesh, problem) - h * mix).norm(), kSolveTol * h.norm() * mix.norm());
    problem.values.setZero();
    EXPECT_EQ(solve(mesh, problem).norm(), 0);
}

TEST_P(HarmonicWeightsFor, AMeshInOtherUnitsOrElsewhereAreTheSame)
{
    const MeshData data = uneven_annulus(kInner, kOuter, 40);
    const Mesh mesh = build_mesh(data);
    BoundaryValues problem = prescribe_boundary(mesh, "inner", partition);
    const Matrix h = solve(mesh, problem);
    for (const double scale : {1e-8, 1e8}) {
        Mesh scaled = mesh;
        points(scaled) *= scale;
        EXPECT_LE((solve(scaled, problem) - h).norm(), kSolveTol * h.norm()) << scale;
    }
    Mesh shifted = mesh;
    points(shifted).leftCols<2>().array() += 7.0; // costs three bits of each coordinate
    EXPECT_LE((solve(shifted, problem) - h).norm(), 10 * kSolveTol * h.norm());
}

TEST_P(HarmonicWeightsFor, TheFilesNumberingDoesNotMatter)
{
    const MeshData data = uneven_annulus(kInner, kOuter, 40);
    std::vector<Index> number(static_cast<std::size_t>(data.points.rows()));
    std::iota(number.begin(), number.end(), 0);
    std::shuffle(number.begin(), number.end(), std::mt19937(3));
    MeshData renumbered = data;
    const auto renamed = [&](Index v) { return v < 0 ? v : number[static_cast<std::size_t>(v)]; };
    for (Index v = 0; v < data.points.rows(); ++v)
        renumbered.points.row(renamed(v)) = data.points.row(v);
    for (Element& e : renumbered.elements)
        std::transform(e.begin(), e.end(), e.begin(), renamed);
    for (Marker& m : renumbered.markers)
        for (auto& edge : m.edges)
            std::transform(edge.begin(), edge.end(), edge.begin(), renamed);
    std::reverse(renumbered.elements.begin(), renumbered.elements.end());

    const auto by_file = [&](const MeshData& file) {
        const Mesh mesh = build_mesh(file);
        const Matrix h = solve(mesh, prescribe_boundary(mesh, "inner", partition));
        Matrix sorted(h.rows(), h.cols());
        for (Index v = 0; v < h.rows(); ++v)
            sorted.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]) = h.row(v);
        return sorted;
    };
    const Matrix first = by_file(data), second = by_file(renumbered);
    for (Index v = 0; v < first.rows(); ++v)
        EXPECT_LE((first.row(v) - second.row(renamed(v))).norm(), kSolveTol);
}

TEST_P(HarmonicWeightsFor, AnyNumberOfThreadsAreTheSameBytes)
{
    const Mesh mesh = build_mesh(uneven_annulus(kInner, kOuter, 360)); // 32760 vertices: several tasks
    const BoundaryValues problem = prescribe_boundary(mesh, "inner", partition);
    set_thread_count(1);
    const Matrix alone = solve(mesh, problem);
    for (const int threads : {2, 3}) {
        set_thread_count(threads);
        EXPECT_EQ(solve(mesh, problem), alone) << threads << " threads";
    }
    set_thread_count(0);
}

TEST_P(HarmonicWeightsFor, OneFactorisationServesFurtherRightHandSides)
{
    const Mesh mesh = build_mesh(uneven_annulus(kInner, kOuter, 40));
    const BoundaryValues problem = prescribe_boundary(mesh, "inner", partition);
    const auto extension = harmonic_extension(mesh, problem.boundary, GetParam());
    for (const double factor : {1.0, 3.0}) {
        BoundaryValues scaled = problem;
        scaled.values = factor * problem.values.rightCols(2);
        EXPECT_EQ(extension->extend(scaled.values), solve(mesh, scaled)) << factor;
    }
}

TEST_P(HarmonicWeightsFor, ATangledMeshAreFiniteAndKeepTheirBounds)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.1, 0.1); // three cells
    MeshData data = test::uneven_square(30);
    for (Index v = 0; v < data.points.rows(); ++v)
        data.points.row(v) += Eigen::RowVector3d(shift(random), shift(random), 0);
    const Mesh mesh = build_mesh(data);
    const Matrix h = solve(mesh, prescribe_boundary(mesh, "left", partition));
    EXPECT_GE(h.minCoeff<Eigen::PropagateNaN>(), 0);
    EXPECT_LE((h.rowwise().sum().array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), kBoundTol);
}

TEST_P(HarmonicWeightsFor, SliversOfNoAreaKeepTheirBounds)
{
    MeshData data = test::uneven_square(12);
    for (Index i = 1; i < 12; ++i) { // a row of vertices all but on the one below, and one on it
        data.points.row(5 * 13 + i) = data.points.row(4 * 13 + i);
        data.points(5 * 13 + i, 1) += i == 6 ? 0 : 1e-12;
    }
    const Mesh mesh = build_mesh(data);
    const Matrix h = solve(mesh, prescribe_boundary(mesh, "left", partition));
    EXPECT_GE(h.minCoeff<Eigen::PropagateNaN>(), 0);
    EXPECT_LE((h.rowwise().sum().array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), kBoundTol);
}

TEST_P(HarmonicWeightsFor, OneTriangleAreItsHeldValues)
{
    MeshData data;
    data.points.resize(4, 3);
    data.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, 0; // the last in no element
    data.elements = {{0, 1, 2, -1}};
    data.markers = {{"all", {{0, 1}, {1, 2}, {2, 0}}}};
    const Mesh mesh = build_mesh(data);
    BoundaryValues problem;
    problem.boundary.moving_edges = mesh.markers[0].edges;
    problem.boundary.vertices = marker_vertices(mesh.markers[0]);
    problem.values = Matrix::Identity(3, 3);
    const Matrix h = solve(mesh, problem);
    for (Index i = 0; i < 3; ++i)
        EXPECT_EQ(h.row(problem.boundary.vertices[static_cast<std::size_t>(i)]), problem.values.row(i));
    EXPECT_EQ(h.sum(), 3); // the vertex of no element has 0
}

TEST(HarmonicWeights, AgreeWithEigensFactorisation)
{
    const Mesh mesh = read_mesh(test::data_path("meshes/rae2822_turb.su2")); // layers stretched 1e4 times
    const BoundaryValues problem = prescribe_boundary(mesh, mesh.markers.front().name, partition);
    const Matrix h = harmonic_functions(mesh, problem, Diffusivity::uniform);

    Triangulation triangulation = triangulate(mesh);
    make_delaunay(points(mesh), triangulation);
    Eigen::SparseMatrix<double> K =
        stiffness_matrix(vertex_count(mesh), stiffness_edges(points(mesh), triangulation));
    Matrix B = Matrix::Zero(K.rows(), 3);
    std::vector<bool> held(static_cast<std::size_t>(K.rows()));
    for (Index i = 0; i < problem.values.rows(); ++i) {
        const Index v = problem.boundary.vertices[static_cast<std::size_t>(i)];
        held[static_cast<std::size_t>(v)] = true;
        B.row(v) = problem.values.row(i);
    }
    const Matrix lifted = B - K * B; // at free vertices B is 0
    for (Index v = 0; v < B.rows(); ++v)
        if (!held[static_cast<std::size_t>(v)])
            B.row(v) = lifted.row(v);
    K.prune([&](Index i, Index j, double) {
        return !held[static_cast<std::size_t>(i)] && !held[static_cast<std::size_t>(j)];
    });
    for (Index v = 0; v < B.rows(); ++v)
        if (held[static_cast<std::size_t>(v)])
            K.coeffRef(v, v) = 1;
    const Matrix expected = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(K).solve(B);
    EXPECT_LE((h - expected).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-10);
}

/// Elements of naca0012_inv turned over when its airfoil turns about its centre by this angle.
Index inverted_by_turning(double degrees, Diffusivity diffusivity)
{
    Mesh mesh = read_mesh(test::data_path("meshes/naca0012_inv.su2"));
    const Eigen::Rotation2Dd turn(degrees * pi / 180);
    const Eigen::Vector2d centre(0.5, 0);
    BoundaryValues problem = prescribe_boundary(mesh, "airfoil", [&](double x, double y) {
        const Eigen::Vector2d from_centre = Eigen::Vector2d(x, y) - centre;
        const Eigen::Vector2d moved = turn * from_centre - from_centre;
        return Eigen::RowVector2d((from_centre.norm() < 2 ? 1 : 0) * moved.transpose());
    });
    points(mesh).leftCols<2>() += harmonic_functions(mesh, problem, diffusivity);
    Index inverted = 0;
    for (const auto& [a, b, c, none] : element_table(mesh))
        inverted += (x_of(mesh, b) - x_of(mesh, a)) * (y_of(mesh, c) - y_of(mesh, a)) <=
                    (y_of(mesh, b) - y_of(mesh, a)) * (x_of(mesh, c) - x_of(mesh, a));
    return inverted;
}

TEST(HarmonicWeights, TurnAnAirfoilWithoutInvertedElementsWhenStiffNearIt)
{
    EXPECT_EQ(inverted_by_turning(45, Diffusivity::uniform), 633);
    EXPECT_EQ(inverted_by_turning(45, Diffusivity::inverse_distance), 0);
    EXPECT_EQ(inverted_by_turning(5, Diffusivity::uniform), 11);
    EXPECT_EQ(inverted_by_turning(5, Diffusivity::inverse_distance), 0);
}

TEST(HarmonicWeights, OfCopiesOfASplitVertexAreOneUnknown)
{
    const Mesh mesh = build_mesh(test::touching_squares(6));
    ASSERT_GT(vertex_count(mesh), mesh.numbering.file_vertices);
    BoundaryValues problem; // one held vertex: through the shared corner it holds both squares
    problem.boundary.vertices = {0};
    problem.values = Matrix::Constant(1, 1, 2.0);
    const Matrix h = harmonic_functions(mesh, problem, Diffusivity::uniform);
    EXPECT_LE((h.array() - 2).abs().maxCoeff<Eigen::PropagateNaN>(), kBoundTol);
}

TEST(HarmonicWeights, RefuseTwoValuesForTheCopiesOfAVertex)
{
    const Mesh mesh = build_mesh(test::touching_squares(6));
    BoundaryValues problem;
    for (Index v = 0; v < vertex_count(mesh); ++v)
        problem.boundary.vertices.push_back(v);
    problem.values = Matrix::Ones(vertex_count(mesh), 1);
    EXPECT_EQ(harmonic_functions(mesh, problem, Diffusivity::uniform), problem.values);
    problem.values.col(0).setLinSpaced(0, 1);
    EXPECT_THROW(harmonic_functions(mesh, problem, Diffusivity::uniform), InputError);
}

TEST(HarmonicWeights, RefuseAProblemThatMakesNoSense)
{
    Mesh mesh = build_mesh(test::uneven_square(4));
    const BoundaryValues good = prescribe_boundary(mesh, "top", affine);
    const auto refuses = [&](const BoundaryValues& problem, Diffusivity diffusivity) {
        EXPECT_THROW(harmonic_functions(mesh, problem, diffusivity), InputError);
    };
    refuses({}, Diffusivity::uniform);
    BoundaryValues bad = good;
    bad.boundary.vertices.back() = 25;
    refuses(bad, Diffusivity::uniform);
    bad = good;
    bad.boundary.vertices.pop_back();
    refuses(bad, Diffusivity::uniform);
    bad = good;
    bad.values(3, 1) = NAN;
    refuses(bad, Diffusivity::uniform);
    bad = good;
    bad.boundary.moving_edges.push_back({0, -1});
    refuses(bad, Diffusivity::inverse_distance);
    bad.boundary.moving_edges.clear();
    refuses(bad, Diffusivity::inverse_distance);
    bad = good;
    bad.boundary.vertices[1] = bad.boundary.vertices[0];
    refuses(bad, Diffusivity::uniform);
    mesh.dimension = 3;
    refuses(good, Diffusivity::uniform);
}

} // namespace
