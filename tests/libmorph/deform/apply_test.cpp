#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/deform/apply.h"

#include <gtest/gtest.h>

namespace {

using namespace morph;

// 11 products and sums of numbers of size 1.
constexpr double kRoundOff = 1e-14;

Weights random_weights(Index rows, Index columns)
{
    Weights weights;
    weights.values = Matrix::Random(rows, columns);
    weights.columns.resize(static_cast<std::size_t>(columns));
    return weights;
}

Points moved(const Weights& weights, const Matrix& displacements, Points positions)
{
    apply_weights(weights, displacements, {positions.data(), positions.rows(), 3});
    return positions;
}

TEST(ApplyWeights, IsTheMatrixProductInTwoAndThreeDimensions)
{
    const Weights weights = random_weights(1000, 11);
    const Points start = Points::Random(1000, 3);
    for (const int components : {2, 3}) {
        const Matrix D = Matrix::Random(11, components);
        Matrix expected = start;
        expected.leftCols(components) += weights.values * D;
        EXPECT_LE((moved(weights, D, start) - expected).norm(), kRoundOff * expected.norm()) << components;
    }
}

TEST(ApplyWeights, MovesNothingByZero)
{
    const Points start = Points::Random(100, 3);
    EXPECT_EQ(moved(random_weights(100, 4), Matrix::Zero(4, 2), start), start);
}

TEST(ApplyWeights, GivesTheSameBytesForAnyThreadCount)
{
    const Weights weights = random_weights(100'000, 7);
    const Matrix D = Matrix::Random(7, 2);
    const Points start = Points::Random(100'000, 3);
    set_thread_count(1);
    const Points one = moved(weights, D, start);
    set_thread_count(3);
    const Points three = moved(weights, D, start);
    set_thread_count(0);
    EXPECT_EQ(one, three);
}

TEST(ApplyWeights, RefusesSizesThatDoNotFit)
{
    Points positions = Points::Zero(10, 3);
    const Eigen::Map<Points> map(positions.data(), 10, 3);
    EXPECT_THROW(apply_weights(random_weights(9, 4), Matrix::Zero(4, 2), map), InputError);
    EXPECT_THROW(apply_weights(random_weights(10, 4), Matrix::Zero(3, 2), map), InputError);
    EXPECT_THROW(apply_weights(random_weights(10, 4), Matrix::Zero(4, 1), map), InputError);
}

} // namespace
