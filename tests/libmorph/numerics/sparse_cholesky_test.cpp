#include "libmorph/numerics/sparse_cholesky.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <random>

namespace {

using namespace morph;

// The matrices here have condition numbers below 1e4.
constexpr double kSolveTol = 1e-12;

using Sparse = Eigen::SparseMatrix<double>;

/// Rows at random points, coupled to random others; near = only to close ones, as in a mesh.
struct RandomSystem {
    RandomSystem(Index n, Index couplings, bool near, unsigned seed)
    {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> uniform(0, 1);
        where.resize(n, 2);
        for (Index i = 0; i < n; ++i)
            where.row(i) << uniform(random), uniform(random);
        std::vector<Eigen::Triplet<double>> entries;
        Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(n, 0.1);
        for (Index c = 0; c < n * couplings; ++c) {
            const Index i = c % n;
            const auto j = static_cast<Index>(uniform(random) * n);
            if (i == j || (near && (where.row(i) - where.row(j)).norm() > 3 / std::sqrt(n)))
                continue;
            const double value = uniform(random) - 0.7;
            entries.emplace_back(i, j, value);
            entries.emplace_back(j, i, value);
            diagonal[i] += std::abs(value);
            diagonal[j] += std::abs(value);
        }
        for (Index i = 0; i < n; ++i)
            entries.emplace_back(i, i, diagonal[i]);
        reference = Sparse(n, n);
        reference.setFromTriplets(entries.begin(), entries.end());
    }

    SymmetricMatrix matrix() const
    {
        SymmetricMatrix A;
        A.start.push_back(0);
        for (Index i = 0; i < reference.cols(); ++i) {
            A.diagonal.push_back(reference.coeff(i, i));
            for (Sparse::InnerIterator entry(reference, i); entry; ++entry)
                if (entry.row() != i) {
                    A.column.push_back(static_cast<Index>(entry.row()));
                    A.value.push_back(entry.value());
                }
            A.start.push_back(A.column.size());
        }
        return A;
    }

    Matrix solve(const Matrix& B) const
    {
        const SymmetricMatrix A = matrix();
        Matrix X = B;
        SparseCholesky(A, nested_dissection(A, where)).solve(X);
        return X;
    }

    Sparse reference;
    Points2 where;
};

void expect_as_eigen(const RandomSystem& system, Index columns)
{
    const Matrix B = Matrix::Random(system.reference.rows(), columns);
    const Matrix expected = Eigen::SimplicialLDLT<Sparse>(system.reference).solve(B);
    EXPECT_LE((system.solve(B) - expected).norm(), kSolveTol * expected.norm());
}

TEST(SparseCholesky, AgreesWithEigenOnRandomMatrices)
{
    for (const Index n : {1, 2, 17, 60, 400})
        for (const Index couplings : {0, 1, 3}) {
            SCOPED_TRACE(testing::Message() << n << " rows, " << couplings << " couplings");
            expect_as_eigen(RandomSystem(n, couplings, false, static_cast<unsigned>(n)), 3);
        }
}

TEST(SparseCholesky, AgreesWithEigenOnCouplingsBetweenNeighbours)
{
    expect_as_eigen(RandomSystem(3000, 400, true, 1), 5);
}

TEST(SparseCholesky, AgreesWithEigenWhenAllPointsCoincide)
{
    RandomSystem system(300, 2, false, 3);
    system.where.setOnes();
    expect_as_eigen(system, 2);
}

TEST(SparseCholesky, AddsUpEntriesOfTheSamePlace)
{
    SymmetricMatrix A{{2, 2}, {0, 2, 4}, {1, 1, 0, 0}, {-0.25, -0.75, -0.75, -0.25}}; // [2 -1; -1 2]
    Matrix X(2, 1);
    X << 1, 1;
    SparseCholesky(A, nested_dissection(A, Points2::Random(2, 2))).solve(X);
    EXPECT_LE((X - Matrix::Ones(2, 1)).norm(), kSolveTol);
}

TEST(SparseCholesky, TakesNoRowsAndNoRightHandSides)
{
    const RandomSystem none(0, 0, false, 1);
    EXPECT_EQ(none.solve(Matrix(0, 3)).rows(), 0);
    const RandomSystem some(50, 2, false, 1);
    EXPECT_EQ(some.solve(Matrix(50, 0)).cols(), 0);
}

TEST(SparseCholesky, GivesTheSameBytesForAnyNumberOfThreads)
{
    const RandomSystem system(40000, 3, false, 5);
    RandomSystem mesh_like = system;
    std::vector<Eigen::Triplet<double>> entries; // a 200 x 200 grid: enough for branches of their own
    for (Index i = 0; i < 40000; ++i) {
        mesh_like.where.row(i) << i % 200, i / 200;
        entries.emplace_back(i, i, 4.5);
        for (const Index j : {i % 200 == 199 ? -1 : i + 1, i + 200})
            if (j >= 0 && j < 40000) {
                entries.emplace_back(i, j, -1);
                entries.emplace_back(j, i, -1);
            }
    }
    mesh_like.reference.setFromTriplets(entries.begin(), entries.end());
    const Matrix B = Matrix::Random(40000, 4);
    set_thread_count(1);
    const Matrix alone = mesh_like.solve(B);
    for (const int threads : {2, 3}) {
        set_thread_count(threads);
        EXPECT_EQ(mesh_like.solve(B), alone) << threads << " threads";
    }
    set_thread_count(0);
}

TEST(SparseCholesky, RefusesAMatrixThatIsNotPositiveDefinite)
{
    RandomSystem system(500, 2, false, 9);
    system.reference.coeffRef(321, 321) = -1;
    EXPECT_THROW(system.solve(Matrix::Ones(500, 1)), SolverError);
}

TEST(NestedDissection, OrdersEveryRowOnceAndSeparates)
{
    const RandomSystem system(5000, 500, true, 2);
    const SymmetricMatrix A = system.matrix();
    const Dissection tree = nested_dissection(A, system.where);

    std::vector<Index> sorted = tree.order;
    std::sort(sorted.begin(), sorted.end());
    std::vector<Index> node_of(sorted.size(), -1);
    Index next = 0;
    for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
        EXPECT_EQ(tree.nodes[node].begin, next);
        next = tree.nodes[node].end;
        for (Index k = tree.nodes[node].begin; k < next; ++k)
            node_of[static_cast<std::size_t>(tree.order[static_cast<std::size_t>(k)])] =
                static_cast<Index>(node);
    }
    for (Index i = 0; i < A.rows(); ++i)
        EXPECT_EQ(sorted[static_cast<std::size_t>(i)], i);

    const auto is_ancestor = [&](Index above, Index node) {
        while (node >= 0 && node != above)
            node = tree.nodes[static_cast<std::size_t>(node)].parent;
        return node == above;
    };
    for (std::size_t i = 0; i < sorted.size(); ++i)
        for (std::size_t e = A.start[i]; e < A.start[i + 1]; ++e) {
            const Index here = node_of[i], there = node_of[static_cast<std::size_t>(A.column[e])];
            EXPECT_TRUE(is_ancestor(std::max(here, there), std::min(here, there)));
        }
}

TEST(NestedDissection, CutsASquareGridAlongItsLines)
{
    SymmetricMatrix A;
    const Index side = 64;
    Points2 where(side * side, 2);
    A.diagonal.assign(side * side, 4);
    A.start.push_back(0);
    for (Index i = 0; i < side * side; ++i) {
        where.row(i) << i % side, i / side;
        for (const Index j :
             {i - side, i % side == 0 ? -1 : i - 1, i % side == side - 1 ? -1 : i + 1, i + side})
            if (j >= 0 && j < side * side)
                A.column.push_back(j);
        A.start.push_back(A.column.size());
    }
    const Dissection tree = nested_dissection(A, where);
    EXPECT_EQ(tree.nodes.back().end - tree.nodes.back().begin, side);
}

} // namespace
