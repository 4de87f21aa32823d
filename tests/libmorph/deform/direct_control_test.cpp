#include "libmorph/core/parallel.h"
#include "libmorph/deform/apply.h"
#include "libmorph/deform/constraints.h"
#include "libmorph/deform/gradient.h"
#include "libmorph/deform/pull.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/mesh/chain.h"
#include "libmorph/weights/harmonic_curves.h"
#include "libmorph/weights/lattice_weights.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <variant>

// What direct control promises for every linear method, on a mesh that harmonic weights and a lattice move.

namespace {

using namespace morph;

constexpr double kReached = 1e-10;  // pulled points, of a circle of radius 1
constexpr double kAreaKept = 1e-12; // of the area itself

using AnyWeights = std::variant<Weights, SparseWeights>;

struct Method {
    std::string name;
    AnyWeights weights;
};

WeightsView rows_of(const Method& method)
{
    return std::visit([](const auto& weights) { return WeightsView(weights); }, method.weights);
}

Points moved_by(const Method& method, const Matrix& D, Points positions)
{
    const Eigen::Map<Points> map(positions.data(), positions.rows(), 3);
    std::visit([&](const auto& weights) { apply_weights(weights, D, map); }, method.weights);
    return positions;
}

/// A ring 1 < r < 3 whose inner circle is carried by 8 control points, or with all of it by a lattice of 6
/// x 5.
class DirectControl : public testing::Test {
protected:
    DirectControl()
    {
        methods.push_back(
            {"harmonic", harmonic_curve_weights(mesh, {{"inner", test::round_curve(0, 0, 1)}})});
        LatticeDefinition shape;
        shape.dimension = 2;
        shape.degree = {3, 2, 0};
        shape.points = {6, 5, 1};
        const Lattice lattice = lattice_in_box({-1.5, -1.4, 0}, {1.6, 1.5, 0}, shape);
        methods.push_back({"lattice", lattice_weights(lattice, embed(lattice, rest))});
    }

    Mesh mesh = build_mesh(test::annulus(1, 3, 60, 10));
    Points rest = points(std::as_const(mesh));
    std::vector<Index> inner = marker_chain(marker(mesh, "inner"), mesh.numbering).vertices;
    std::vector<Method> methods;
};

double area_inside(const Points& positions, const std::vector<Index>& chain)
{
    double area = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const auto a = positions.row(chain[i]);
        const auto b = positions.row(chain[(i + 1) % chain.size()]);
        area += (a[0] - b[0]) * (a[1] + b[1]) / 2;
    }
    return area;
}

TEST_F(DirectControl, PullsVerticesOfTheMeshWhereTheyAreWanted)
{
    for (const Method& method : methods) {
        const std::vector<Index> vertices = {inner[0], inner[17], inner[40]};
        const WeightsView rows = rows_of(method);
        const Matrix wanted = 0.2 * Matrix::Random(3, 2);
        const Matrix given = 0.1 * Matrix::Random(rows.cols(), 2);
        const Pulled pulled = pull_points(controlled_vertices(rows, rest, vertices), wanted, given);
        const Points moved = moved_by(method, pulled.displacements, rest);
        const Matrix reached = (moved - rest)(vertices, Eigen::all).leftCols(2);
        EXPECT_LE((reached - wanted).norm(), kReached) << method.name;
    }
}

TEST_F(DirectControl, KeepsTheAreaInsideABoundaryOfTheMesh)
{
    const double area = area_inside(rest, inner);
    for (const Method& method : methods) {
        const WeightsView rows = rows_of(method);
        ConstraintSet set;
        set.boundaries.push_back({"inner", controlled_vertices(rows, rest, inner)});
        set.areas.push_back({"area", 0});
        set.fixed.push_back({"vertex", controlled_vertices(rows, rest, {inner[5]}), {}});
        const Matrix wanted = 0.2 * Matrix::Random(rows.cols(), 2);
        const ConstrainedMove move = satisfy_constraints(set, wanted);
        const Points moved = moved_by(method, move.displacements, rest);
        EXPECT_NEAR(area_inside(moved, inner) / area, 1, kAreaKept) << method.name;
        EXPECT_LE((moved - rest).row(inner[5]).norm(), kReached) << method.name;
        EXPECT_GT(move.change, 0.01) << method.name;
    }
}

// The area of a polygon is an objective whose derivative by its nodes is simple: half of the chord between
// the neighbours, turned by a right angle. It is quadratic, so that central differences have no error but
// rounding.
TEST_F(DirectControl, CarriesTheGradientOfAnObjectiveToTheControlPoints)
{
    constexpr double kStep = 1e-2;
    Matrix gradient = Matrix::Zero(rest.rows(), 2);
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const Eigen::RowVector3d chord =
            rest.row(inner[(i + 1) % inner.size()]) - rest.row(inner[(i + inner.size() - 1) % inner.size()]);
        gradient.row(inner[i]) << chord.y() / 2, -chord.x() / 2;
    }
    for (const Method& method : methods) {
        const WeightsView rows = rows_of(method);
        const Matrix carried = control_point_gradient(rows, gradient);
        Matrix difference = Matrix::Zero(rows.cols(), 2);
        for (Eigen::Index k = 0; k < difference.size(); ++k) {
            Matrix D = Matrix::Zero(rows.cols(), 2);
            D.data()[k] = kStep;
            difference.data()[k] = (area_inside(moved_by(method, D, rest), inner) -
                                    area_inside(moved_by(method, -D, rest), inner)) /
                                   (2 * kStep);
        }
        EXPECT_LE((difference - carried).norm(), 1e-11 * carried.norm()) << method.name;
    }
}

TEST_F(DirectControl, GivesTheSameBytesForAnyThreadCount)
{
    for (const Method& method : methods) {
        const WeightsView rows = rows_of(method);
        const Matrix wanted = 0.1 * Matrix::Random(rows.cols(), 2);
        const auto solve = [&](int threads) {
            set_thread_count(threads);
            ConstraintSet set;
            set.boundaries.push_back({"inner", controlled_vertices(rows, rest, inner)});
            set.areas.push_back({"area", 0});
            set.thicknesses.push_back({"middle", 0, {0.1, 0}, {0, 1}, {Bound::Kind::equal, 0.9, true}});
            Matrix D = satisfy_constraints(set, wanted).displacements;
            set_thread_count(0);
            return D;
        };
        EXPECT_EQ(solve(1), solve(3)) << method.name;
    }
}

} // namespace
