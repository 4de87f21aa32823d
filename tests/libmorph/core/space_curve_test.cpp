#include "libmorph/core/space_curve.h"

#include "libmorph/core/parallel.h"
#include "libmorph/core/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

namespace morph {

namespace {

/// The vertices of a grid of @p side vertices a side, one coordinate after the other.
Points grid(Index side, int dimension)
{
    Points points(dimension == 2 ? side * side : side * side * side, 3);
    for (Index i = 0; i < points.rows(); ++i)
        points.row(i) << i % side, i / side % side, i / side / side;
    return points;
}

Points random_points(Index n, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-3, 5);
    Points points(n, 3);
    for (Index i = 0; i < points.size(); ++i)
        points.data()[i] = coordinate(random);
    return points;
}

std::vector<Index> counted(std::size_t n)
{
    std::vector<Index> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

double mean_step(const Points& points, const std::vector<Index>& order)
{
    double sum = 0;
    for (std::size_t i = 1; i < order.size(); ++i)
        sum += (points.row(order[i]) - points.row(order[i - 1])).norm();
    return sum / static_cast<double>(order.size() - 1);
}

TEST(HilbertOrder, GoesFromNeighbourToNeighbourOnAGrid)
{
    // A grid of 2^k points a side has one point in each cell of the curve's level k.
    for (const auto& [dimension, side] : {std::pair{2, 2}, {2, 64}, {3, 2}, {3, 16}}) {
        const Points points = grid(side, dimension);
        const std::vector<Index> order = hilbert_order(points, dimension);
        for (std::size_t i = 1; i < order.size(); ++i)
            ASSERT_EQ((points.row(order[i]) - points.row(order[i - 1])).lpNorm<1>(), 1)
                << dimension << "D, " << i;
    }
}

TEST(HilbertOrder, NamesEachPointOnce)
{
    for (const int dimension : {2, 3})
        for (const Index n : {1, 2, 1000, 100'000}) {
            std::vector<Index> order = hilbert_order(random_points(n, 1), dimension);
            std::sort(order.begin(), order.end());
            EXPECT_EQ(order, counted(static_cast<std::size_t>(n)));
        }
}

TEST(HilbertOrder, OfNothingIsEmpty)
{
    EXPECT_TRUE(hilbert_order(Points(0, 3), 2).empty());
    EXPECT_TRUE(hilbert_order(Points(0, 3), 3).empty());
}

TEST(HilbertOrder, KeepsTheOrderOfPointsInOneCell)
{
    const Index places = 50;
    Points points(20 * places, 3);
    const Points distinct = random_points(places, 2);
    for (Index i = 0; i < points.rows(); ++i)
        points.row(i) = distinct.row(i % places);
    const std::vector<Index> order = hilbert_order(points, 3);
    for (std::size_t i = 1; i < order.size(); ++i)
        if (order[i] % places == order[i - 1] % places) {
            EXPECT_LT(order[i - 1], order[i]);
        }
    EXPECT_EQ(hilbert_order(Points::Constant(500, 3, 7.5), 2), counted(500));
}

TEST(HilbertOrder, MakesStepsOfTheSpacingOfThePoints)
{
    const Index n = 20'000;
    const double plane_spacing = 8 / std::sqrt(n);
    const double space_spacing = 8 / std::cbrt(n);
    Points points = random_points(n, 3);
    // A random order takes steps of half the box; those along the curve stay near the spacing.
    EXPECT_LT(mean_step(points, hilbert_order(points, 3)), 1.5 * space_spacing);
    points.col(2).setZero();
    EXPECT_LT(mean_step(points, hilbert_order(points, 2)), 1.5 * plane_spacing);
}

TEST(HilbertOrder, IgnoresHeightInThePlane)
{
    Points points = random_points(500, 4);
    const std::vector<Index> order = hilbert_order(points, 2);
    points.col(2) *= 1e9;
    EXPECT_EQ(hilbert_order(points, 2), order);
}

TEST(HilbertOrder, DoesNotDependOnTheUnitOfLength)
{
    const Points points = random_points(5000, 5);
    const std::vector<Index> order = hilbert_order(points, 3);
    for (const int exponent : {-900, -30, 30, 1000}) // powers of two scale without rounding
        EXPECT_EQ(hilbert_order(points * std::ldexp(1.0, exponent), 3), order) << exponent;
}

TEST(HilbertOrder, HoldsOutAtTheLimitsOfNumbers)
{
    const double largest = std::numeric_limits<double>::max();
    const double smallest = std::numeric_limits<double>::denorm_min();
    Points points(4, 3);
    points << -largest, -largest, 0, largest, -largest, 0, 0, 0, 0, -largest, largest, 0;
    EXPECT_EQ(hilbert_order(points, 2).size(), 4U);
    points << 0, 0, 0, smallest, 0, 0, 0, smallest, 0, smallest, smallest, 0;
    EXPECT_EQ(hilbert_order(points, 2).size(), 4U);
}

TEST(HilbertOrder, IsTheSameForAnyNumberOfThreads)
{
    const Points points = random_points(100'000, 6);
    set_thread_count(1);
    const std::vector<Index> order = hilbert_order(points, 2);
    for (const int threads : {2, 3}) {
        set_thread_count(threads);
        EXPECT_EQ(hilbert_order(points, 2), order);
    }
    set_thread_count(0);
}

TEST(RadixSort, AgreesWithAStableSort)
{
    std::mt19937_64 random(7);
    for (const int bits : {1, 8, 13, 40, 64}) {
        std::vector<Keyed<std::uint64_t>> items(70'000);
        for (std::size_t i = 0; i < items.size(); ++i)
            items[i] = {random() >> (64 - bits), static_cast<Index>(i)};
        std::vector<Keyed<std::uint64_t>> expected = items;
        std::stable_sort(expected.begin(), expected.end(), [](auto a, auto b) { return a.key < b.key; });
        radix_sort(items, bits);
        EXPECT_TRUE(std::equal(items.begin(), items.end(), expected.begin(), [](auto a, auto b) {
            return a.key == b.key && a.item == b.item;
        })) << bits;
    }
}

} // namespace

} // namespace morph
