#include "libmorph/numerics/dirichlet_system.h"

#include "libmorph/core/error.h"
#include "libmorph/numerics/assembly.h"
#include "tests/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using namespace morph;

constexpr double kSolveTol = 1e-11; // the matrices here have condition numbers below 1e4

/// Random sets of one to four vertices with a random positive definite matrix each. The last vertex is in
/// none.
struct RandomPatches {
    RandomPatches(Index vertices, Index components, unsigned seed) : n(vertices), c(components)
    {
        std::mt19937 random(seed);
        for (Index p = 0; p < 3 * n; ++p) {
            std::vector<Index> some(static_cast<std::size_t>(n - 1));
            for (Index v = 0; v + 1 < n; ++v)
                some[static_cast<std::size_t>(v)] = v;
            std::shuffle(some.begin(), some.end(), random);
            some.resize(1 + static_cast<std::size_t>(p) % 4);
            patches.vertex.insert(patches.vertex.end(), some.begin(), some.end());
            patches.close_list();
            const Index rows = c * static_cast<Index>(some.size());
            const Eigen::MatrixXd half =
                Eigen::MatrixXd::NullaryExpr(rows, rows, [&] { return std::normal_distribution()(random); });
            matrices.emplace_back(half * half.transpose());
        }
        where = Points::NullaryExpr(n, 3, [&] { return std::normal_distribution()(random); });
    }

    SymmetricMatrix sum() const
    {
        return assemble(n, c, patches,
                        [this](std::size_t p, ElementMatrix& matrix) { matrix = matrices[p]; });
    }

    Eigen::MatrixXd dense() const
    {
        const Eigen::Index size = Eigen::Index{c} * n;
        Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
        for (std::size_t p = 0; p < matrices.size(); ++p)
            for (Index i = 0; i < matrices[p].rows(); ++i)
                for (Index j = 0; j < matrices[p].cols(); ++j)
                    A(row(p, i), row(p, j)) += matrices[p](i, j);
        return A;
    }

    Index n, c;
    VertexLists patches;
    std::vector<Eigen::MatrixXd> matrices;
    Points where;

private:
    Index row(std::size_t p, Index i) const { return patches.begin(p)[i / c] * c + i % c; }
};

Eigen::MatrixXd dense(const SymmetricMatrix& A)
{
    Eigen::MatrixXd D = Eigen::MatrixXd::Zero(A.rows(), A.rows());
    for (Index i = 0; i < A.rows(); ++i) {
        const auto r = static_cast<std::size_t>(i);
        D(i, i) += A.diagonal[r];
        for (std::size_t e = A.start[r]; e < A.start[r + 1]; ++e)
            D(i, A.column[e]) += A.value[e];
    }
    return D;
}

TEST(SumOfPatches, IsTheSumOfDenseMatrices)
{
    for (const Index c : {1, 2, 3}) {
        const RandomPatches random(20, c, 1);
        const Eigen::MatrixXd expected = random.dense();
        EXPECT_LE((dense(random.sum()) - expected).norm(), 1e-14 * expected.norm());
    }
}

TEST(DirichletSystem, HoldsAndBalancesEveryUnknown)
{
    for (const Index c : {1, 2}) {
        const RandomPatches random(40, c, 2);
        const std::vector<Index> held{7, 0, 21};
        const DirichletSystem system(random.where, random.sum(), c, held);
        const Eigen::Index m = 3;
        const Matrix values = Matrix::Random(3, c * m), load = Matrix::Random(40, c * m);
        const Matrix u = system.solve(values, load);
        EXPECT_EQ(u(held, Eigen::all), values);
        EXPECT_EQ(u.row(39).norm(), 0); // in no patch
        Matrix left = -load;
        for (Index v = 0; v < 40; ++v)
            for (Index k = 0; k < c; ++k)
                for (Index w = 0; w < 40; ++w)
                    for (Index l = 0; l < c; ++l)
                        left.row(v).segment(k * m, m) +=
                            random.dense()(v * c + k, w * c + l) * u.row(w).segment(l * m, m);
        for (Index v = 0; v < 39; ++v)
            if (std::find(held.begin(), held.end(), v) == held.end()) {
                EXPECT_LE(left.row(v).norm(), kSolveTol * random.dense().norm() * u.norm()) << v;
            }
        EXPECT_EQ(system.solve(values), system.solve(values, Matrix::Zero(40, c * m)));
    }
}

TEST(DirichletSystem, RefusesPartsWithTooFewHeldVertices)
{
    VertexLists patches;
    for (const Index v : {0, 1, 2, 3}) { // parts 0 1 2 and 3 4 5
        patches.vertex.insert(patches.vertex.end(), {v + v / 2, v + v / 2 + 1});
        patches.close_list();
    }
    const auto message = [&](Index c, const std::vector<Index>& held) {
        return test::message_of([&] {
            const SymmetricMatrix A = assemble(6, c, patches, [](std::size_t, ElementMatrix& matrix) {
                matrix.setConstant(-1);
                matrix.diagonal().setConstant(10);
            });
            const DirichletSystem system(Points::Random(6, 3), A, c, held);
        });
    };
    EXPECT_THAT(message(1, {1}), testing::StartsWith("1 part of the mesh has no held vertex"));
    EXPECT_EQ(message(1, {1, 3}), "nothing was thrown");
    EXPECT_THAT(message(2, {0, 3}), testing::StartsWith("2 parts of the mesh have fewer than 2 held"));
    EXPECT_THAT(message(2, {0, 3, 5}), testing::StartsWith("1 part of the mesh has fewer than 2 held"));
    EXPECT_EQ(message(2, {0, 2, 3, 5}), "nothing was thrown");
}

TEST(DirichletSystem, RefusesSizesThatDoNotFitAndReportsWhatIsNotFinite)
{
    const RandomPatches random(10, 2, 3);
    const DirichletSystem system(random.where, random.sum(), 2, {1, 2});
    EXPECT_THROW(system.solve(Matrix::Zero(3, 2)), InputError);
    EXPECT_THROW(system.solve(Matrix::Zero(2, 3)), InputError);
    EXPECT_THROW(system.solve(Matrix::Zero(2, 2), Matrix::Zero(9, 2)), InputError);
    EXPECT_THROW(system.solve(Matrix::Constant(2, 2, 1e308)), SolverError);
    EXPECT_THROW(DirichletSystem(random.where, random.sum(), 2, {1, 10}), InputError);
    EXPECT_THROW(DirichletSystem(random.where, random.sum(), 2, {1, 1}), InputError);
}

} // namespace
