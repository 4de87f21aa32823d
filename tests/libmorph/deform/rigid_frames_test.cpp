#include "libmorph/deform/rigid_frames.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/geometry/mesh_domain.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/weights/harmonic.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/domains.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace {

using namespace morph;
using std::numbers::pi;
using test::boundary_displacement;
using test::difference;
using test::dirichlet_boundary;

// One sparse solve of a well-conditioned system loses a few digits, and rotations none; n is some thousands.
constexpr double kSolveTol = 1e-11;

constexpr double kDegree = pi / 180;

Mesh ring()
{
    return build_mesh(test::uneven_annulus(0.5, 3, 60));
}

TEST(BoundaryFrames, OfARigidTurnHaveItsAngleEverywhere)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const std::vector<bool> moving = test::is_moving(mesh, held);
    for (const double degrees : {-170.0, -90.0, 0.0, 5.0, 120.0, 179.0}) {
        const Matrix d = boundary_displacement(mesh, held, test::turn(degrees, {4, -2}));
        const BoundaryFrames frames = boundary_frames(mesh, held, d);
        ASSERT_EQ(frames.pivot.rows(), 1);
        const Eigen::RowVector2d shift = test::turn(degrees, {4, -2})(frames.pivot(0, 0), frames.pivot(0, 1));
        for (std::size_t i = 0; i < moving.size(); ++i) {
            EXPECT_EQ(frames.body[i], moving[i] ? 0 : -1);
            EXPECT_NEAR(frames.angle[i], moving[i] ? degrees * kDegree : 0, kSolveTol) << degrees;
            const Eigen::RowVector2d expected = moving[i] ? shift : Eigen::RowVector2d(0, 0);
            EXPECT_LE((frames.translation.row(static_cast<Index>(i)) - expected).norm(), kSolveTol);
        }
    }
}

/// Displacement of the bottom of a square (vertices in file order) that rolls it up: the edge at parameter s
/// is turned by turns * 2 pi (s - 1/2).
std::vector<Eigen::RowVector2d> rolled_up(Index cells, double turns)
{
    std::vector<Eigen::RowVector2d> moves{{0, 0}};
    const double h = 1.0 / cells;
    for (Index e = 0; e < cells; ++e) {
        const double angle = turns * 2 * pi * ((e + 0.5) * h - 0.5);
        moves.push_back(moves.back() + h * Eigen::RowVector2d(std::cos(angle) - 1, std::sin(angle)));
    }
    return moves;
}

TEST(BoundaryFrames, FollowABoundaryThatRollsUpThroughMoreThanATurn)
{
    constexpr Index kCells = 60;
    constexpr double kTurns = 3;
    constexpr Index kEnd = 4; // at an end the angle is that of edges on one side only
    const Mesh mesh = build_mesh(test::uneven_square(kCells));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"bottom"});
    const auto moves = rolled_up(kCells, kTurns);
    const auto place = [&](std::size_t i) {
        return static_cast<std::size_t>(std::lround(kCells * points(mesh)(held.vertices[i], 0)));
    };
    const std::vector<bool> moving = test::is_moving(mesh, held);
    Matrix d = Matrix::Zero(static_cast<Index>(moving.size()), 2);
    for (std::size_t i = 0; i < moving.size(); ++i)
        if (moving[i])
            d.row(static_cast<Index>(i)) = moves[place(i)];
    const BoundaryFrames frames = boundary_frames(mesh, held, d);
    int checked = 0;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const std::size_t at = place(i);
        if (!moving[i] || at < kEnd || at > kCells - kEnd)
            continue;
        EXPECT_NEAR(frames.angle[i], kTurns * 2 * pi * (static_cast<double>(at) / kCells - 0.5), kSolveTol);
        ++checked;
    }
    EXPECT_EQ(checked, kCells - 2 * kEnd + 1);
}

TEST(BoundaryFrames, WeighEdgesByTheirLengthAndByHowNearTheyAre)
{
    MeshData data = test::uneven_square(12);
    for (Index i = 1; i < 12; ++i)
        data.points(i, 0) = std::pow(i / 12.0, 1.3); // edges of different length along the bottom
    const Mesh mesh = build_mesh(data);
    const DirichletBoundary held = dirichlet_boundary(mesh, {"bottom"});
    const auto dent = [](double x, double) { return Eigen::RowVector2d(0, 0.2 * std::exp(-50 * x * x)); };
    constexpr double kReach = 0.3;
    const BoundaryFrames frames =
        boundary_frames(mesh, held, boundary_displacement(mesh, held, dent), kReach);
    const auto x = [&](Index i) { return data.points(i, 0); };
    const auto turn = [&](Index i) { // of the edge from i to i + 1, times its length
        const double rise = dent(x(i + 1), 0)[1] - dent(x(i), 0)[1];
        return std::complex<double>(x(i + 1) - x(i), rise);
    };
    const std::vector<bool> moving = test::is_moving(mesh, held);
    for (std::size_t h = 0; h < moving.size(); ++h) {
        const Index at = mesh.numbering.vertex[static_cast<std::size_t>(held.vertices[h])];
        if (!moving[h])
            continue;
        std::complex<double> sum = 0;
        for (Index i = 0; i <= 12; ++i) {
            const double nearness = std::max(0.0, 1 - std::abs(x(i) - x(at)) / kReach);
            sum += nearness * ((i > 0 ? turn(i - 1) : 0) + (i < 12 ? turn(i) : 0));
        }
        EXPECT_NEAR(frames.angle[h], std::arg(sum), kSolveTol) << at;
    }
}

TEST(BoundaryFrames, AtASharpTrailingEdgeLieBetweenThoseOfTheSides)
{
    const Mesh mesh = read_mesh(test::data_path("meshes/naca0012_inv.su2"));
    const DirichletBoundary held = dirichlet_boundary(mesh, {"airfoil"});
    const Matrix thicker = boundary_displacement(
        mesh, held, [](double, double y) { return Eigen::RowVector2d(0, 2 * y); }); // three times as thick
    const BoundaryFrames frames = boundary_frames(mesh, held, thicker);
    double largest = 0;
    for (std::size_t i = 0; i < held.vertices.size(); ++i) {
        const auto at = points(mesh).row(held.vertices[i]);
        largest = std::max(largest, std::abs(frames.angle[i]));
        if (frames.body[i] == 0 && at[0] > 0.99999) { // the file has some seven digits
            EXPECT_NEAR(frames.angle[i], 0, 1e-6) << at;
        }
    }
    // An edge at the slope atan(q) gets the slope atan(3q), at most 30 degrees more, whatever q.
    EXPECT_GT(largest, 15 * kDegree);
    EXPECT_LT(largest, 30 * kDegree + kSolveTol);
}

TEST(BoundaryFrames, OfABodyThatShrinksToAPointAreFinite)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const BoundaryFrames frames = boundary_frames(
        mesh, held,
        boundary_displacement(mesh, held, [](double x, double y) { return Eigen::RowVector2d(-x, -y); }));
    for (const double angle : frames.angle)
        EXPECT_EQ(angle, 0);
}

TEST(BoundaryFrames, RefuseWhatMakesNoSense)
{
    Mesh mesh = ring();
    DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const auto rows = static_cast<Index>(held.vertices.size());
    EXPECT_THROW(boundary_frames(mesh, held, Matrix::Zero(rows, 3)), InputError);
    EXPECT_THROW(boundary_frames(mesh, held, Matrix::Zero(rows - 1, 2)), InputError);
    EXPECT_THROW(boundary_frames(mesh, held, Matrix::Constant(rows, 2, NAN)), InputError);
    EXPECT_THROW(boundary_frames(mesh, held, Matrix::Zero(rows, 2), -0.1), InputError);
    EXPECT_THROW(boundary_frames(mesh, held, Matrix::Zero(rows, 2), NAN), InputError);
    const Index end = held.moving_edges[0][0];
    std::erase(held.vertices, end);
    EXPECT_THAT(test::message_of([&] { boundary_frames(mesh, held, Matrix::Zero(rows - 1, 2)); }),
                testing::HasSubstr("vertex " +
                                   std::to_string(mesh.numbering.vertex[static_cast<std::size_t>(end)]) +
                                   " is the end of a moving edge, but it is not held"));
    mesh.dimension = 3;
    EXPECT_THROW(boundary_frames(mesh, held, Matrix::Zero(rows - 1, 2)), InputError);
}

/// What arrives with harmonic angles, stiff near the body.
Matrix carried(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)
{
    const auto extension = harmonic_extension(mesh, held, Diffusivity::inverse_distance);
    return extend_with_rotations(*extension, mesh, held, displacement);
}

TEST(ExtensionWithRotations, IsExactOnTheBoundaryOfEveryRealMesh)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const DirichletBoundary held = dirichlet_boundary(mesh, {mesh.markers.front().name});
        const Matrix d = boundary_displacement(mesh, held, [](double x, double y) {
            return Eigen::RowVector2d(0.1 * std::sin(3 * x + y), 0.2 * std::cos(x - 2 * y));
        });
        EXPECT_EQ(carried(mesh, held, d)(held.vertices, Eigen::all), d);
    }
}

TEST(ExtensionWithRotations, TurnsACircleInACircleByTheLogarithmOfTheRadius)
{
    // theta(r) = theta0 ln(3 / r) / ln(3 / 0.5) solves Laplace's equation; nothing is shifted.
    constexpr double kAngle = 150 * kDegree;
    double error[2]{};
    for (const int fine : {0, 1}) {
        const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, fine ? 120 : 60));
        const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
        const auto extension = harmonic_extension(mesh, held, Diffusivity::uniform);
        const Matrix moved = extend_with_rotations(
            *extension, mesh, held, boundary_displacement(mesh, held, test::turn(150, {0, 0})));
        const Matrix expected = test::displacement_everywhere(mesh, [](double x, double y) {
            const double angle = kAngle * std::log(3 / std::hypot(x, y)) / std::log(6.0);
            return test::turn(angle / kDegree, {0, 0})(x, y);
        });
        error[fine] = difference(moved, expected);
    }
    EXPECT_LT(error[1], 0.02);
    EXPECT_LT(error[1], 0.35 * error[0]); // second order: a quarter, and some slack
}

TEST(ExtensionWithRotations, ARigidMoveOfSeveralBodiesTogetherMovesWhatLiesBetween)
{
    const Mesh mesh = build_mesh(mesh_domain(test::thesis_case(2)));
    ASSERT_EQ(mesh.markers.size(), 3);
    const DirichletBoundary held =
        dirichlet_boundary(mesh, {mesh.markers[0].name, mesh.markers[1].name, mesh.markers[2].name});
    const test::Move move = test::turn(100, {7, -3});
    EXPECT_EQ(boundary_frames(mesh, held, boundary_displacement(mesh, held, move)).pivot.rows(), 3);
    const Matrix moved = carried(mesh, held, boundary_displacement(mesh, held, move));
    EXPECT_LE(difference(moved, test::displacement_everywhere(mesh, move)), 40 * kSolveTol); // lengths to 40
}

TEST(ExtensionWithRotations, AShiftArrivesAsWithoutRotations)
{
    const Mesh mesh = ring();
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix d =
        boundary_displacement(mesh, held, [](double, double) { return Eigen::RowVector2d(0.3, -0.2); });
    const auto extension = harmonic_extension(mesh, held, Diffusivity::inverse_distance);
    EXPECT_LE(difference(extend_with_rotations(*extension, mesh, held, d), extension->extend(d)), kSolveTol);
    const DirichletBoundary nothing_moves{held.vertices, {}, {}};
    const auto uniform = harmonic_extension(mesh, nothing_moves, Diffusivity::uniform);
    EXPECT_LE(difference(extend_with_rotations(*uniform, mesh, nothing_moves, d), uniform->extend(d)),
              kSolveTol);
}

TEST(ExtensionWithRotations, AirfoilsTurnByUpTo120DegreesWithoutInvertedElements)
{
    for (const auto& [file, body] : test::kAirfoilMeshes) {
        const Mesh mesh = read_mesh(test::data_path(std::string("meshes/") + file));
        const DirichletBoundary held = dirichlet_boundary(mesh, {body});
        const auto extension = harmonic_extension(mesh, held, Diffusivity::inverse_distance);
        for (const double degrees : {5, 10, 20, 45, 90, 120, -120}) {
            SCOPED_TRACE(file + (" by " + std::to_string(degrees)));
            const Matrix d = boundary_displacement(mesh, held, test::turn(degrees, {0.5, 0}));
            EXPECT_EQ(test::inverted_after(mesh, extend_with_rotations(*extension, mesh, held, d)), 0);
            const Index plain = test::inverted_after(mesh, extension->extend(d));
            EXPECT_EQ(plain > 1000, std::abs(degrees) >= 90) << plain;
            EXPECT_EQ(plain == 0, std::abs(degrees) <= 45) << plain;
        }
    }
}

TEST(ExtensionWithRotations, AirfoilsBecomeThriceAsThickWithoutInvertedElements)
{
    for (const auto& [file, body] : test::kAirfoilMeshes) {
        SCOPED_TRACE(file);
        const Mesh mesh = read_mesh(test::data_path(std::string("meshes/") + file));
        const DirichletBoundary held = dirichlet_boundary(mesh, {body});
        const Matrix d =
            boundary_displacement(mesh, held, [](double, double y) { return Eigen::RowVector2d(0, 2 * y); });
        EXPECT_EQ(test::inverted_after(mesh, carried(mesh, held, d)), 0);
    }
}

TEST(ExtensionWithRotations, IsTheSameBytesForAnyNumberOfThreads)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 240)); // several blocks of vertices
    const DirichletBoundary held = dirichlet_boundary(mesh, {"inner"});
    const Matrix d = boundary_displacement(mesh, held, test::turn(70, {0.1, 0}));
    set_thread_count(1);
    const Matrix alone = carried(mesh, held, d);
    set_thread_count(3);
    EXPECT_EQ(carried(mesh, held, d), alone);
    set_thread_count(0);
}

} // namespace
