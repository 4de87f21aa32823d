#include "libmorph/weights/lattice_weights.h"

#include "libmorph/core/parallel.h"
#include "libmorph/deform/apply.h"
#include "libmorph/deform/move_lattice.h"
#include "tests/support/errors.h"
#include "tests/support/lattices.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace morph;

/// Points in a lattice and some outside, in turn.
Points with_outsiders(const Lattice& lattice, const Points& inside)
{
    Points all(2 * inside.rows(), 3);
    for (Index i = 0; i < inside.rows(); ++i) {
        all.row(2 * i) = inside.row(i);
        all.row(2 * i + 1) = inside.row(i);
        all(2 * i + 1, 0) += 3 * lattice.size();
    }
    return all;
}

Points moved_by_weights(const SparseWeights& weights, const Matrix& displacements, const Points& points)
{
    Points moved = points;
    apply_weights(weights, displacements, Eigen::Map<Points>(moved.data(), moved.rows(), 3));
    return moved;
}

TEST(LatticeWeights, SumToOneInsideAndAreEmptyOutside)
{
    for (const Lattice& lattice : test::all_kinds_of_lattices()) {
        const Points points = with_outsiders(lattice, test::random_embedded(lattice, 200).positions);
        const SparseWeights weights = lattice_weights(lattice, embed(lattice, points));
        ASSERT_EQ(weights.values.rows(), points.rows());
        ASSERT_EQ(weights.columns.size(), static_cast<std::size_t>(lattice.control_point_count()));
        for (Index v = 0; v < points.rows(); ++v) {
            double sum = 0;
            int entries = 0;
            for (Eigen::SparseMatrix<double, Eigen::RowMajor, Index>::InnerIterator w(weights.values, v); w;
                 ++w) {
                sum += w.value();
                EXPECT_GE(w.value(), 0);
                ++entries;
            }
            const auto& degree = lattice.definition().degree;
            EXPECT_LE(entries, (degree[0] + 1) * (degree[1] + 1) * (degree[2] + 1));
            EXPECT_NEAR(sum, v % 2 == 0 ? 1 : 0, 1e-14) << test::kind(lattice);
        }
    }
}

TEST(LatticeWeights, CarryAffineMotionsOfTheControlPointsToThePoints)
{
    Eigen::Matrix3d linear;
    linear << 0.1, -0.2, 0, 0.3, 0.05, 0, 0, 0, 0;
    const Eigen::RowVector3d shift(0.5, -0.25, 0);
    for (const Lattice& lattice : test::all_kinds_of_lattices()) {
        const Points points = test::random_embedded(lattice, 300).positions;
        const Matrix displacements =
            ((lattice.definition().control_points * linear.transpose()).rowwise() + shift)
                .leftCols(lattice.dimension());
        const Points moved =
            moved_by_weights(lattice_weights(lattice, embed(lattice, points)), displacements, points);
        const Points expected = points + ((points * linear.transpose()).rowwise() + shift);
        EXPECT_LT((moved - expected).cwiseAbs().maxCoeff(), 1e-13 * lattice.size()) << test::kind(lattice);
    }
}

TEST(LatticeWeights, MoveAsTheMapItselfDoes)
{
    for (const Lattice& lattice : test::all_kinds_of_lattices()) {
        const test::Embedded embedded = test::random_embedded(lattice, 200);
        const Matrix displacements =
            0.1 * Matrix::Random(lattice.control_point_count(), 3).leftCols(lattice.dimension());
        Points control_points = lattice.definition().control_points;
        control_points.leftCols(lattice.dimension()) += displacements;
        const Lattice after = lattice.with_control_points(control_points);
        const Points moved = moved_by_weights(lattice_weights(lattice, embed(lattice, embedded.positions)),
                                              displacements, embedded.positions);
        for (Index v = 0; v < moved.rows(); ++v) {
            const Eigen::Vector3d u = embedded.parameters.row(v).transpose();
            const Eigen::RowVector3d move = (after.point(u) - lattice.point(u)).transpose();
            EXPECT_LT((moved.row(v) - embedded.positions.row(v) - move).norm(), 1e-12 * lattice.size())
                << test::kind(lattice);
        }
    }
}

TEST(LatticeWeights, AreTheSameBytesForAnyThreadCount)
{
    const Lattice lattice = test::all_kinds_of_lattices().front();
    const Points points = test::random_embedded(lattice, 20000).positions;
    const Embedding embedding = embed(lattice, points);
    set_thread_count(1);
    const SparseWeights one = lattice_weights(lattice, embedding);
    set_thread_count(4);
    const SparseWeights four = lattice_weights(lattice, embedding);
    set_thread_count(0);
    EXPECT_EQ(Matrix(one.values), Matrix(four.values));
}

TEST(MoveByLattice, IsTheProductWithTheWeightsAndLeavesPointsOutsideAlone)
{
    for (const Lattice& lattice : test::all_kinds_of_lattices()) {
        const Points points = with_outsiders(lattice, test::random_embedded(lattice, 500).positions);
        const Embedding embedding = embed(lattice, points);
        const Matrix displacements =
            0.2 * Matrix::Random(lattice.control_point_count(), 3).leftCols(lattice.dimension());
        Points moved = points;
        move_by_lattice(lattice, embedding, displacements, Eigen::Map<Points>(moved.data(), moved.rows(), 3));
        const Points expected = moved_by_weights(lattice_weights(lattice, embedding), displacements, points);
        EXPECT_LT((moved - expected).cwiseAbs().maxCoeff(), 1e-13 * lattice.size()) << test::kind(lattice);
        for (Index v = 1; v < points.rows(); v += 2)
            EXPECT_EQ(moved.row(v), points.row(v));
    }
}

TEST(MoveByLattice, MovesNothingWithoutDisplacements)
{
    for (const Lattice& lattice : test::all_kinds_of_lattices()) {
        const Points points = test::random_embedded(lattice, 300).positions;
        Points moved = points;
        const Eigen::Map<Points> view(moved.data(), moved.rows(), 3);
        move_by_lattice(lattice, embed(lattice, points),
                        Matrix::Zero(lattice.control_point_count(), lattice.dimension()), view);
        EXPECT_EQ(moved, points);
        move_by_lattice(lattice, lattice, embed(lattice, points), view);
        EXPECT_EQ(moved, points);
    }
}

TEST(MoveByLattice, FollowsWeightsAsDesignVariables)
{
    for (const Lattice& lattice : test::all_kinds_of_lattices()) {
        const test::Embedded embedded = test::random_embedded(lattice, 200);
        std::vector<double> weights;
        for (Index k = 0; k < lattice.control_point_count(); ++k)
            weights.push_back(1 + 0.5 * std::sin(k));
        const Lattice after = lattice.with_weights(weights);
        Points moved = embedded.positions;
        move_by_lattice(lattice, after, embed(lattice, embedded.positions),
                        Eigen::Map<Points>(moved.data(), moved.rows(), 3));
        for (Index v = 0; v < moved.rows(); ++v)
            EXPECT_LT((moved.row(v) - after.point(embedded.parameters.row(v).transpose()).transpose()).norm(),
                      1e-12 * lattice.size());
    }
}

TEST(MoveByLattice, RefusesWhatDoesNotFit)
{
    const Lattice lattice = test::all_kinds_of_lattices().front();
    const Points points = test::random_embedded(lattice, 5).positions;
    const Embedding embedding = embed(lattice, points);
    Points moved = points;
    const Eigen::Map<Points> view(moved.data(), moved.rows(), 3);
    EXPECT_THROW(move_by_lattice(lattice, embedding, Matrix::Zero(2, lattice.dimension()), view), InputError);
    const SparseWeights weights = lattice_weights(lattice, embedding);
    EXPECT_THROW(apply_weights(weights, Matrix::Zero(1, 2), view), InputError);
}

} // namespace
