#include "libmorph/numerics/conjugate_gradients.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/numerics/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace morph;

struct System {
    SymmetricMatrix A;
    Points2 where;
    Matrix b;
};

/// Springs between the neighbours of a grid, some a thousand times as stiff as others, and a weak hold.
System grid_of_springs(Index side)
{
    System system;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> exponent(0, 3), value(-1, 1);
    const auto n = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    std::vector<std::vector<std::pair<Index, double>>> rows(n);
    system.A.diagonal.assign(n, 1e-3);
    const auto join = [&](Index a, Index b) {
        const double stiffness = std::pow(10, exponent(random));
        for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
            rows[static_cast<std::size_t>(from)].emplace_back(to, -stiffness);
            system.A.diagonal[static_cast<std::size_t>(from)] += stiffness;
        }
    };
    system.where.resize(side * side, 2);
    for (Index i = 0; i < side * side; ++i) {
        system.where.row(i) << i % side, i / side;
        if (i % side + 1 < side)
            join(i, i + 1);
        if (i + side < side * side)
            join(i, i + side);
    }
    system.A.start = {0};
    for (const auto& row : rows) {
        for (const auto& [column, entry] : row) {
            system.A.column.push_back(column);
            system.A.value.push_back(entry);
        }
        system.A.start.push_back(system.A.column.size());
    }
    system.b.resize(side * side, 1);
    for (Index i = 0; i < side * side; ++i)
        system.b(i, 0) = value(random);
    return system;
}

Matrix times(const SymmetricMatrix& A, const Matrix& x)
{
    Matrix result(x.rows(), 1);
    for (std::size_t row = 0; row < A.diagonal.size(); ++row) {
        double sum = A.diagonal[row] * x(static_cast<Index>(row), 0);
        for (std::size_t e = A.start[row]; e < A.start[row + 1]; ++e)
            sum += A.value[e] * x(A.column[e], 0);
        result(static_cast<Index>(row), 0) = sum;
    }
    return result;
}

TEST(ConjugateGradients, ReachTheToleranceAndWithAFineOneTheSolution)
{
    const System system = grid_of_springs(40);
    Matrix exact = system.b;
    SparseCholesky(system.A, nested_dissection(system.A, system.where)).solve(exact);
    int last = 0;
    for (const double tolerance : {1e-1, 1e-4, 1e-11}) {
        Matrix x = system.b;
        const int iterations = conjugate_gradients(system.A, system.where, {256, tolerance, 2000}, x);
        EXPECT_LE((times(system.A, x) - system.b).norm(), 1.01 * tolerance * system.b.norm());
        EXPECT_GT(iterations, last);
        last = iterations;
        EXPECT_LT((x - exact).norm(), 1e6 * tolerance * exact.norm()); // condition below 1e6
    }
}

TEST(ConjugateGradients, AreDirectWithOneBlock)
{
    const System system = grid_of_springs(12);
    Matrix x = system.b;
    EXPECT_EQ(conjugate_gradients(system.A, system.where, {144, 1e-8, 50}, x), 1);
    EXPECT_LE((times(system.A, x) - system.b).norm(), 1e-8 * system.b.norm());
}

TEST(ConjugateGradients, DescendHoweverEarlyTheyStop)
{
    const System system = grid_of_springs(30);
    for (const int iterations : {1, 3, 10}) {
        Matrix x = system.b;
        EXPECT_EQ(conjugate_gradients(system.A, system.where, {100, 1e-12, iterations}, x), iterations);
        const double energy = 0.5 * times(system.A, x).col(0).dot(x.col(0)) - system.b.col(0).dot(x.col(0));
        EXPECT_LT(energy, 0);
        EXPECT_GT(system.b.col(0).dot(x.col(0)), 0);
    }
}

TEST(ConjugateGradients, AreTheSameForAnyNumberOfThreads)
{
    const System system = grid_of_springs(90); // more rows than a thread takes at a time
    Matrix one = system.b, three = system.b;
    set_thread_count(1);
    conjugate_gradients(system.A, system.where, {}, one);
    set_thread_count(3);
    conjugate_gradients(system.A, system.where, {}, three);
    set_thread_count(0);
    EXPECT_EQ(one, three);
}

TEST(ConjugateGradients, OfNothingAreNothing)
{
    System system = grid_of_springs(5);
    Matrix x = Matrix::Zero(25, 1);
    EXPECT_EQ(conjugate_gradients(system.A, system.where, {}, x), 0);
    EXPECT_EQ(x, Matrix::Zero(25, 1));
}

TEST(ConjugateGradients, RefuseAnIndefiniteMatrix)
{
    System system = grid_of_springs(8);
    system.A.diagonal[20] = -1;
    EXPECT_THROW(conjugate_gradients(system.A, system.where, {}, system.b), SolverError);
}

} // namespace
