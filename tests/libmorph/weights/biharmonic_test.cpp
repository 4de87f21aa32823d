#include "libmorph/weights/biharmonic.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/boundary_values.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <functional>
#include <string>

namespace {

using namespace morph;
using test::values_at;
using test::whole_boundary;

constexpr double kSolveTol = 1e-10; // the condition is the square of that of a harmonic system

constexpr double kInner = 0.5;
constexpr double kOuter = 3;

/// A function of the radius and its derivative.
struct Radial {
    std::function<double(double)> value, slope;
};

/// The combination of four with these values and slopes at kInner and kOuter.
std::function<double(double)> fitted(const std::array<Radial, 4>& basis, const Eigen::Vector4d& wanted)
{
    Eigen::Matrix4d A;
    for (Index k = 0; k < 4; ++k) {
        const Radial& f = basis[static_cast<std::size_t>(k)];
        A.col(k) << f.value(kInner), f.slope(kInner), f.value(kOuter), f.slope(kOuter);
    }
    return [basis, c = Eigen::Vector4d(A.lu().solve(wanted))](double r) {
        return c[0] * basis[0].value(r) + c[1] * basis[1].value(r) + c[2] * basis[2].value(r) +
               c[3] * basis[3].value(r);
    };
}

/// 1 on the inner circle, 0 on the outer, flat at both: 1, r^2, ln r and r^2 ln r are biharmonic.
Eigen::RowVectorXd flat_at_both(double x, double y)
{
    static const auto f =
        fitted({Radial{[](double) { return 1; }, [](double) { return 0; }},
                Radial{[](double r) { return r * r; }, [](double r) { return 2 * r; }},
                Radial{[](double r) { return std::log(r); }, [](double r) { return 1 / r; }},
                Radial{[](double r) { return r * r * std::log(r); },
                       [](double r) { return r * (2 * std::log(r) + 1); }}},
               {1, 0, 0, 0});
    const double r = std::max(std::hypot(x, y), kInner);
    return Eigen::RowVectorXd::Constant(1, f(r));
}

/// The inner circle turns, the outer rests: g(r) along the circles, and g' = g / r at both is the conformal
/// condition. r, 1 / r, r^3 and r ln r times the unit vector are biharmonic.
Eigen::RowVector2d turned(double x, double y)
{
    static const auto g =
        fitted({Radial{[](double r) { return r; }, [](double) { return 1; }},
                Radial{[](double r) { return 1 / r; }, [](double r) { return -1 / (r * r); }},
                Radial{[](double r) { return r * r * r; }, [](double r) { return 3 * r * r; }},
                Radial{[](double r) { return r * std::log(r); }, [](double r) { return std::log(r) + 1; }}},
               {kInner, 1, 0, 0});
    const double r = std::max(std::hypot(x, y), kInner);
    return g(r) / r * Eigen::RowVector2d(-y, x);
}

/// Root mean square error on an annulus with so many cells around.
template <typename Make, typename Exact>
double error_of(Index around, const Make& make, const Exact& exact)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(kInner, kOuter, around));
    const DirichletBoundary held = whole_boundary(mesh, "inner");
    const Matrix u = make(mesh, held)->extend(values_at(mesh, held.vertices, exact));
    return (u - values_at(mesh, exact)).norm() / std::sqrt(static_cast<double>(u.rows()));
}

/// Each error is at most what order 1.8 makes of the one before, and the last below a hundredth.
template <typename Make, typename Exact>
void expect_convergence(const Make& make, const Exact& exact)
{
    const double coarse = error_of(32, make, exact), middle = error_of(64, make, exact),
                 fine = error_of(128, make, exact);
    EXPECT_LE(fine, 1e-2);
    EXPECT_GE(std::log2(coarse / middle), 1.8);
    EXPECT_GE(std::log2(middle / fine), 1.8);
}

TEST(BiharmonicExtension, ConvergesToTheFunctionThatIsFlatAtBothCircles)
{
    expect_convergence(biharmonic_extension, flat_at_both);
}

TEST(ConformalBiharmonicExtension, ConvergesToTheMoveOfACircleThatTurns)
{
    expect_convergence(conformal_biharmonic_extension, turned);
}

Eigen::RowVector2d one_and_waves(double x, double y)
{
    return {1, std::sin(3 * x) + y * y};
}

TEST(BiharmonicExtension, IsExactOnTheBoundaryOfEveryRealMeshAndKeepsConstants)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const DirichletBoundary held = whole_boundary(mesh, mesh.markers.front().name);
        const Matrix values = values_at(mesh, held.vertices, one_and_waves);
        const Matrix u = biharmonic_extension(mesh, held)->extend(values);
        EXPECT_EQ(u(held.vertices, Eigen::all), values);
        EXPECT_TRUE(u.allFinite());
        EXPECT_LE((u.col(0).array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), kSolveTol);
    }
}

TEST(ConformalBiharmonicExtension, TurnsAndScalesEveryRealMeshWithItsBoundary)
{
    const auto similar = [](double x, double y) {
        return Eigen::RowVector2d(1 - 0.4 * x - 1.7 * y, 2 + 1.7 * x - 0.4 * y);
    };
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const DirichletBoundary held = whole_boundary(mesh, mesh.markers.front().name);
        const Matrix exact = values_at(mesh, similar);
        const Points2 u =
            conformal_biharmonic_extension(mesh, held)->extend(exact(held.vertices, Eigen::all));
        EXPECT_LE((u - exact).norm(), kSolveTol * exact.norm());
    }
}

TEST(ConformalBiharmonicExtension, TurnsAnAirfoilWithoutInvertedElements)
{
    const std::vector<std::array<std::string, 2>> meshes{
        {"naca0012_inv", "airfoil"}, {"naca0012_lam_hybrid", "airfoil"}, {"rae2822_turb", "AIRFOIL"}};
    for (const auto& [file, airfoil] : meshes) {
        SCOPED_TRACE(file);
        const Mesh mesh = read_mesh(test::data_path("meshes/" + file + ".su2"));
        const DirichletBoundary held = whole_boundary(mesh, airfoil);
        const auto turn = [&](double degrees) {
            return Points2(values_at(mesh, held.vertices, test::turned_airfoil(degrees)));
        };
        const auto conformal = conformal_biharmonic_extension(mesh, held);
        for (const double degrees : {5.0, 20.0, 45.0, 90.0, 120.0})
            EXPECT_EQ(test::inverted_by(mesh, conformal->extend(turn(degrees))), 0) << degrees;
        const auto flat = biharmonic_extension(mesh, held);
        EXPECT_EQ(test::inverted_by(mesh, flat->extend(turn(45))), 0);
        EXPECT_GT(test::inverted_by(mesh, flat->extend(turn(90))), 100);
    }
}

/// A square with a wall from bottom to top through its middle, held like the boundary.
struct WalledSquare {
    WalledSquare() : mesh(build_mesh(test::uneven_square(kCells))), held(whole_boundary(mesh, "left"))
    {
        std::vector<Index> row(mesh.numbering.vertex.size());
        for (std::size_t v = 0; v < row.size(); ++v)
            row[static_cast<std::size_t>(mesh.numbering.vertex[v])] = static_cast<Index>(v);
        const auto middle = [&](Index j) {
            return row[static_cast<std::size_t>(j) * (kCells + 1) + kCells / 2];
        };
        for (Index j = 0; j < kCells; ++j) {
            held.fixed_edges.push_back({middle(j), middle(j + 1)});
            if (j > 0)
                held.vertices.push_back(middle(j));
        }
    }

    static constexpr Index kCells = 12;
    Mesh mesh;
    DirichletBoundary held;
};

TEST(BiharmonicExtension, HasNoSlopeOnEitherSideOfAnInnerWall)
{
    const WalledSquare square;
    const auto left_only = [](double x, double) {
        return Eigen::RowVectorXd::Constant(1, x < 0.3 ? 1.0 : 0.0);
    };
    const auto values = values_at(square.mesh, square.held.vertices, left_only);
    const auto beyond = [&](const DirichletBoundary& held) {
        const Matrix u = biharmonic_extension(square.mesh, held)->extend(values);
        double sum = 0;
        for (Index v = 0; v < u.rows(); ++v)
            sum += points(square.mesh)(v, 0) > 0.6 ? std::abs(u(v, 0)) : 0;
        return sum;
    };
    EXPECT_EQ(beyond(square.held), 0);
    DirichletBoundary one_sided = square.held;
    one_sided.fixed_edges.clear(); // values only: the slope at the line carries over
    EXPECT_GT(beyond(one_sided), 0.01);
}

TEST(BiharmonicExtension, DoesNotDependOnTheUnitOfLengthOrTheAxes)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(kInner, kOuter, 40));
    const DirichletBoundary held = whole_boundary(mesh, "inner");
    const Matrix values = values_at(mesh, held.vertices, one_and_waves);
    const Matrix u = biharmonic_extension(mesh, held)->extend(values);
    const Eigen::Matrix2d turn = Eigen::Rotation2Dd(0.7).toRotationMatrix();
    for (const double scale : {1e-6, 1e6}) {
        Mesh other = mesh;
        points(other).leftCols<2>() = scale * (points(mesh).leftCols<2>() * turn);
        EXPECT_LE((biharmonic_extension(other, held)->extend(values) - u).norm(), kSolveTol * u.norm())
            << scale;
    }
}

TEST(BiharmonicExtension, IsTheSameBytesForAnyNumberOfThreads)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(kInner, kOuter, 180));
    const DirichletBoundary held = whole_boundary(mesh, "inner");
    const Matrix values = values_at(mesh, held.vertices, one_and_waves);
    set_thread_count(1);
    const Matrix alone = biharmonic_extension(mesh, held)->extend(values);
    set_thread_count(3);
    EXPECT_EQ(biharmonic_extension(mesh, held)->extend(values), alone);
    set_thread_count(0);
}

TEST(BiharmonicExtension, TakesTheCopiesOfASplitVertexAsOneUnknown)
{
    const Mesh mesh = build_mesh(test::touching_squares(6));
    DirichletBoundary held; // through the shared corner it holds both squares
    held.vertices = {0};
    const Matrix u = biharmonic_extension(mesh, held)->extend(Matrix::Constant(1, 1, 2.0));
    EXPECT_LE((u.array() - 2).abs().maxCoeff<Eigen::PropagateNaN>(), kSolveTol);
}

TEST(BiharmonicExtension, RefusesWhatMakesNoSense)
{
    const Mesh mesh = build_mesh(test::uneven_square(6));
    const DirichletBoundary held = whole_boundary(mesh, "top");
    EXPECT_THROW(biharmonic_extension(mesh, {}), InputError);
    EXPECT_THROW(biharmonic_extension(mesh, held)->extend(Matrix::Zero(2, 2)), InputError);
    Mesh tangled = mesh;
    points(tangled).col(0) *= -1;
    EXPECT_THROW(biharmonic_extension(tangled, held), InputError);
}

} // namespace
