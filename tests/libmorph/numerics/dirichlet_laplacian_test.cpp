#include "libmorph/numerics/dirichlet_laplacian.h"

#include "libmorph/core/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace {

using namespace morph;

constexpr double kSolveTol = 1e-14; // three unknowns

/// Vertices in a row, joined by edges of these weights.
struct Chain {
    explicit Chain(const std::vector<double>& weights)
        : points(Points::Zero(static_cast<Index>(weights.size()) + 1, 3))
    {
        for (std::size_t i = 0; i < weights.size(); ++i)
            edges.push_back({static_cast<Index>(i), static_cast<Index>(i) + 1, weights[i]});
        for (Index i = 0; i < points.rows(); ++i)
            points(i, 0) = i;
    }

    Points points;
    std::vector<WeightedEdge> edges;
};

Matrix column(std::initializer_list<double> values)
{
    Matrix m(static_cast<Index>(values.size()), 1);
    std::copy(values.begin(), values.end(), m.data());
    return m;
}

TEST(DirichletLaplacian, SplitsTheDropInProportionToTheResistances)
{
    const Chain chain({1, 0.5, 0.25, 1}); // resistances 1, 2, 4, 1
    const DirichletLaplacian problem(chain.points, chain.edges, {0, 4});
    EXPECT_LE((problem.solve(column({8, 0})) - column({8, 7, 5, 1, 0})).norm(), 8 * kSolveTol);
    EXPECT_EQ(problem.solve(column({0, 0})), column({0, 0, 0, 0, 0}));
}

TEST(DirichletLaplacian, SolvesNothingWhenEveryVertexIsHeld)
{
    const Chain chain({1});
    EXPECT_EQ(DirichletLaplacian(chain.points, chain.edges, {1, 0}).solve(column({2, 3})), column({3, 2}));
}

TEST(DirichletLaplacian, LeavesAVertexWithoutEdgesAtZero)
{
    Chain chain({1, 1});
    chain.points.conservativeResize(4, 3);
    chain.points.row(3).setConstant(7);
    EXPECT_EQ(DirichletLaplacian(chain.points, chain.edges, {0, 2}).solve(column({1, 1}))(3, 0), 0);
}

std::string message_of(const Chain& chain, const std::vector<Index>& held)
{
    try {
        const DirichletLaplacian problem(chain.points, chain.edges, held);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(DirichletLaplacian, CountsThePartsThatNothingHolds)
{
    Chain chain({1, 1, 1, 1, 1, 1});
    chain.edges.erase(chain.edges.begin() + 4);
    chain.edges.erase(chain.edges.begin() + 2); // parts 0 1 2, 3 4, 5 6
    EXPECT_THAT(message_of(chain, {3}), testing::StartsWith("2 parts of the mesh have no held vertex"));
    EXPECT_THAT(message_of(chain, {3, 0}), testing::StartsWith("1 part of the mesh has no held vertex"));
    EXPECT_EQ(message_of(chain, {3, 0, 6}), "no error");
}

TEST(DirichletLaplacian, RefusesHeldVerticesThatMakeNoSense)
{
    const Chain chain({1, 1});
    EXPECT_THAT(message_of(chain, {0, 3}), testing::HasSubstr("held vertex 3 is out of range"));
    EXPECT_THAT(message_of(chain, {-1}), testing::HasSubstr("held vertex -1 is out of range"));
    EXPECT_THAT(message_of(chain, {2, 2}), testing::HasSubstr("vertex 2 is held twice"));
}

TEST(DirichletLaplacian, RefusesTheWrongNumberOfValues)
{
    const Chain chain({1, 1});
    EXPECT_THROW(DirichletLaplacian(chain.points, chain.edges, {0, 2}).solve(column({1, 2, 3})), InputError);
}

TEST(DirichletLaplacian, ReportsAPartThatHangsOnByWeightsOfZero)
{
    const Chain chain({1, 0, 0});
    EXPECT_THROW(DirichletLaplacian(chain.points, chain.edges, {0}), SolverError);
}

} // namespace
