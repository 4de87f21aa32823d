#include "libmorph/weights/spring.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/boundary_values.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>

namespace {

using namespace morph;
using test::values_at;
using test::whole_boundary;

constexpr double kSolveTol = 1e-12; // one sparse solve of a well-conditioned system

Eigen::RowVector3d some_values(double x, double y)
{
    return {1, std::sin(3 * x) + y, x * y};
}

class Springs : public testing::TestWithParam<SpringStiffness> {};

INSTANTIATE_TEST_SUITE_P(Stiffnesses, Springs,
                         testing::Values(SpringStiffness::inverse_length,
                                         SpringStiffness::inverse_length_squared));

double stiffness_of(double length, SpringStiffness stiffness)
{
    return stiffness == SpringStiffness::inverse_length ? 1 / length : 1 / (length * length);
}

TEST_P(Springs, HoldEveryFreeVertexInEquilibrium)
{
    for (const MeshData& data : {test::uneven_square(10), test::quad_square(10)}) {
        const Mesh mesh = build_mesh(data);
        const DirichletBoundary held = whole_boundary(mesh, "top");
        const Matrix h =
            spring_extension(mesh, held, GetParam())->extend(values_at(mesh, held.vertices, some_values));
        Matrix force = Matrix::Zero(h.rows(), h.cols());
        for (const auto edge : mesh.kernel.edges()) {
            const Index a = edge.v0().idx(), b = edge.v1().idx();
            const double k = stiffness_of((points(mesh).row(a) - points(mesh).row(b)).norm(), GetParam());
            force.row(a) += k * (h.row(b) - h.row(a));
            force.row(b) += k * (h.row(a) - h.row(b));
        }
        const double stiffest = stiffness_of(0.05, GetParam()); // cells have side 0.1
        for (const auto v : mesh.kernel.vertices())
            if (!mesh.kernel.is_boundary(v)) {
                EXPECT_LE(force.row(v.idx()).norm(), stiffest * kSolveTol);
            }
        EXPECT_EQ(h(held.vertices, Eigen::all), values_at(mesh, held.vertices, some_values));
    }
}

TEST_P(Springs, KeepTheBoundsOnEveryRealMesh)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        const DirichletBoundary held = whole_boundary(mesh, mesh.markers.front().name);
        const auto waves = [](double x, double y) {
            return Eigen::RowVector2d(1, 0.5 + 0.5 * std::sin(3 * x + y));
        };
        const Matrix h =
            spring_extension(mesh, held, GetParam())->extend(values_at(mesh, held.vertices, waves));
        EXPECT_GE(h.minCoeff<Eigen::PropagateNaN>(), 0);
        EXPECT_LE(h.maxCoeff<Eigen::PropagateNaN>(), 1 + kSolveTol);
        EXPECT_LE((h.col(0).array() - 1).abs().maxCoeff<Eigen::PropagateNaN>(), kSolveTol);
    }
}

TEST_P(Springs, AreTheSameBytesForAnyNumberOfThreads)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 180));
    const DirichletBoundary held = whole_boundary(mesh, "inner");
    const Matrix values = values_at(mesh, held.vertices, some_values);
    set_thread_count(1);
    const Matrix alone = spring_extension(mesh, held, GetParam())->extend(values);
    set_thread_count(3);
    EXPECT_EQ(spring_extension(mesh, held, GetParam())->extend(values), alone);
    set_thread_count(0);
}

TEST_P(Springs, TakeTheCopiesOfASplitVertexAsOneUnknown)
{
    const Mesh mesh = build_mesh(test::touching_squares(6));
    DirichletBoundary held; // through the shared corner it holds both squares
    held.vertices = {0};
    const Matrix h = spring_extension(mesh, held, GetParam())->extend(Matrix::Constant(1, 1, 2.0));
    EXPECT_LE((h.array() - 2).abs().maxCoeff<Eigen::PropagateNaN>(), kSolveTol);
}

TEST_P(Springs, RefuseWhatMakesNoSense)
{
    MeshData data = test::uneven_square(4);
    const Mesh mesh = build_mesh(data);
    EXPECT_THROW(spring_extension(mesh, {}, GetParam()), InputError);
    const DirichletBoundary held = whole_boundary(mesh, "top");
    const auto extension = spring_extension(mesh, held, GetParam());
    EXPECT_THROW(extension->extend(Matrix::Zero(2, 2)), InputError);
    Mesh pinched = mesh;
    points(pinched).row(mesh.kernel.to_vertex_handle(HalfedgeHandle(0)).idx()) =
        points(mesh).row(mesh.kernel.from_vertex_handle(HalfedgeHandle(0)).idx());
    EXPECT_THAT(test::message_of([&] { spring_extension(pinched, held, GetParam()); }),
                testing::HasSubstr("has no length"));
}

/// The energy of springs as they are, not to first order: how far lengths, and angles or heights, are from
/// those of the undeformed element.
class SpringEnergy {
public:
    SpringEnergy(const Mesh& mesh, SpringStiffness stiffness, SpringBracing bracing)
        : mesh_(mesh), rest_(points(mesh).leftCols<2>()), stiffness_(stiffness), bracing_(bracing)
    {
    }

    double operator()(const Points2& x) const
    {
        double sum = 0;
        for (const auto edge : mesh_.kernel.edges()) {
            const auto length = [&](const Points2& p) {
                return (p.row(edge.v0().idx()) - p.row(edge.v1().idx())).norm();
            };
            sum += 0.5 * stiffness_of(length(rest_), stiffness_) * std::pow(length(x) - length(rest_), 2);
        }
        for (const Element& e : element_table(mesh_))
            for (int n = corner_count(e), i = 0; i < n; ++i)
                sum += corner(x, vertex(e, (i + n - 1) % n), vertex(e, i), vertex(e, (i + 1) % n));
        return sum;
    }

private:
    static Index vertex(const Element& e, int i) { return e[static_cast<std::size_t>(i)]; }

    double corner(const Points2& x, Index previous, Index here, Index next) const
    {
        const auto edges = [&](const Points2& p) {
            Eigen::Matrix2d m;
            m << p.row(next) - p.row(here), p.row(previous) - p.row(here);
            return m;
        };
        const auto angle = [](const Eigen::Matrix2d& m) {
            return std::atan2(m.determinant(), m.row(0).dot(m.row(1)));
        };
        const auto height = [](const Eigen::Matrix2d& m) {
            return m.determinant() / (m.row(0) - m.row(1)).norm();
        };
        const Eigen::Matrix2d rest = edges(rest_), now = edges(x);
        if (bracing_ == SpringBracing::ball_vertex)
            return 0.5 * stiffness_of(height(rest), stiffness_) * std::pow(height(now) - height(rest), 2);
        const double lengths = rest.row(0).norm() * rest.row(1).norm();
        const double factor = stiffness_ == SpringStiffness::inverse_length ? std::sqrt(lengths) : 1;
        return 0.5 * factor * std::pow((angle(now) - angle(rest)) / std::sin(angle(rest)), 2);
    }

    const Mesh& mesh_;
    Points2 rest_;
    SpringStiffness stiffness_;
    SpringBracing bracing_;
};

/// Largest force on a free vertex per size of the move, for a small move u, by differences of the energy.
/// Moves to both sides take the terms of second order out.
double largest_force(const Mesh& mesh, const SpringEnergy& energy, const Points2& u)
{
    constexpr double kMove = 1e-3, kStep = 1e-4;
    const Points2 rest = points(mesh).leftCols<2>();
    double largest = 0;
    for (const auto v : mesh.kernel.vertices())
        for (int k = 0; k < 2 && !mesh.kernel.is_boundary(v); ++k) {
            Points2 step = Points2::Zero(u.rows(), 2);
            step(v.idx(), k) = kStep;
            const auto force = [&](double move) {
                return (energy(rest + move * u + step) - energy(rest + move * u - step)) / (2 * kStep);
            };
            largest = std::max(largest, std::abs(force(kMove) - force(-kMove)) / (2 * kMove));
        }
    return largest;
}

TEST_P(Springs, WithBracingHoldEveryFreeVertexInEquilibriumForSmallMoves)
{
    for (const MeshData& data : {test::uneven_square(5), test::quad_square(5)})
        for (const auto bracing : {SpringBracing::torsion, SpringBracing::ball_vertex}) {
            const Mesh mesh = build_mesh(data);
            const DirichletBoundary held = whole_boundary(mesh, "top");
            const SpringEnergy energy(mesh, GetParam(), bracing);
            const auto wavy = [](double x, double y) {
                return Eigen::RowVector2d(std::sin(3 * x - y), std::cos(2 * y + x));
            };
            Points2 u = braced_spring_extension(mesh, held, GetParam(), bracing)
                            ->extend(values_at(mesh, held.vertices, wavy));
            const double left = largest_force(mesh, energy, u);
            u += 0.1 * Points2::Random(u.rows(), 2);
            EXPECT_LE(left, 1e-2 * largest_force(mesh, energy, u)); // third order in moves of 1e-3 remain
        }
}

TEST(BracedSprings, TurnAnAirfoilByARightAngle)
{
    const Mesh mesh = read_mesh(test::data_path("meshes/naca0012_inv.su2"));
    const DirichletBoundary held = whole_boundary(mesh, "airfoil");
    const Points2 turned = values_at(mesh, held.vertices, test::turned_airfoil(90));
    constexpr auto kStiffness = SpringStiffness::inverse_length_squared;
    for (const auto bracing : {SpringBracing::torsion, SpringBracing::ball_vertex})
        EXPECT_EQ(
            test::inverted_by(mesh, braced_spring_extension(mesh, held, kStiffness, bracing)->extend(turned)),
            0);
    EXPECT_GT(test::inverted_by(mesh, spring_extension(mesh, held, kStiffness)->extend(turned)), 1000);
}

} // namespace
