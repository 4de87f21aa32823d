#include "libmorph/geometry/nearest_points.h"

#include "libmorph/core/parallel.h"
#include "tests/support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace {

using namespace morph;
using Neighbors = std::vector<NearestPoints::Neighbor>;

Points random_points(Index count, int dimension, double scale, std::uint32_t seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-scale, scale);
    Points points = Points::Zero(count, 3);
    for (Index i = 0; i < count; ++i)
        for (int c = 0; c < dimension; ++c)
            points(i, c) = uniform(random);
    return points;
}

std::vector<Neighbors> nearest(const Points& points, const Points& queries, int k)
{
    std::vector<Neighbors> found(static_cast<std::size_t>(queries.rows()));
    NearestPoints(points).nearest(
        queries, k, [&](Index q, std::span<const NearestPoints::Neighbor> neighbors) {
            found[static_cast<std::size_t>(q)].assign(neighbors.begin(), neighbors.end());
        });
    return found;
}

/// Rows of the points, nearest first, equally near ones in order.
std::vector<Index> sorted_by_distance(const Points& points, const Eigen::RowVector3d& query)
{
    std::vector<Index> rows(static_cast<std::size_t>(points.rows()));
    std::iota(rows.begin(), rows.end(), 0);
    std::stable_sort(rows.begin(), rows.end(), [&](Index a, Index b) {
        return (points.row(a) - query).squaredNorm() < (points.row(b) - query).squaredNorm();
    });
    return rows;
}

TEST(NearestPoints, AgreesWithSortingAllDistances)
{
    for (const int dimension : {2, 3})
        for (const double scale : {1.0, 1e-200, 1e200}) {
            const Points points = random_points(500, dimension, scale, 1);
            const Points queries = random_points(50, dimension, 1.5 * scale, 2);
            const auto found = nearest(points, queries, 20);
            // In units of 1: the reference squares distances itself.
            const Points unit = points / scale, unit_queries = queries / scale;
            for (Index q = 0; q < queries.rows(); ++q) {
                const auto expected = sorted_by_distance(unit, unit_queries.row(q));
                for (std::size_t i = 0; i < 20; ++i) {
                    const auto& neighbor = found[static_cast<std::size_t>(q)][i];
                    EXPECT_EQ(neighbor.point, expected[i]);
                    EXPECT_NEAR(neighbor.distance / scale,
                                (unit.row(expected[i]) - unit_queries.row(q)).norm(), 1e-15);
                }
            }
        }
}

TEST(NearestPoints, GivesAllPointsWhereThereAreFewerThanAskedFor)
{
    const Points points = random_points(3, 2, 1, 1);
    EXPECT_EQ(nearest(points, points, 100)[0].size(), 3U);
    EXPECT_EQ(nearest(points.topRows(1), points, 5)[2].size(), 1U);
}

TEST(NearestPoints, PutsEqualPointsInTheOrderOfTheirRows)
{
    const Points points = Points::Constant(5000, 3, 0.25);
    for (const int k : {1, 7, 5000}) {
        const auto found = nearest(points, points.topRows(1), k)[0];
        ASSERT_EQ(found.size(), static_cast<std::size_t>(k));
        for (std::size_t i = 0; i < found.size(); ++i)
            ASSERT_EQ(found[i].point, static_cast<Index>(i));
    }
}

TEST(NearestPoints, TakesTheLowestRowsOfThoseEquallyFarAtTheLastPlace)
{
    for (const int dimension : {2, 3}) {
        // Eighths have exact squares, so that equal distances are equal in the reference too.
        const auto rounded = [](const Points& points) -> Points { return (points.array() * 8).round() / 8; };
        const Points points = rounded(random_points(2000, dimension, 1, 5));
        const Points queries = rounded(random_points(100, dimension, 4, 6));
        for (const int k : {1, 2, 30}) {
            const auto found = nearest(points, queries, k);
            for (Index q = 0; q < queries.rows(); ++q) {
                const auto expected = sorted_by_distance(points, queries.row(q));
                for (std::size_t i = 0; i < static_cast<std::size_t>(k); ++i)
                    ASSERT_EQ(found[static_cast<std::size_t>(q)][i].point, expected[i]);
            }
        }
    }
}

TEST(NearestPoints, CountsTheHeightOfAQueryAbovePlanarPoints)
{
    Points query(1, 3);
    query << 0, 0, 4;
    Points point(1, 3);
    point << 3, 0, 0;
    EXPECT_DOUBLE_EQ(nearest(point, query, 1)[0][0].distance, 5);
}

TEST(NearestPoints, GivesTheSameAnswerForAnyThreadCount)
{
    Points points = random_points(3000, 2, 1, 5);
    points = (points.array() * 8).round() / 8; // many at the same distance
    set_thread_count(1);
    const auto one = nearest(points, points, 7);
    set_thread_count(4);
    const auto four = nearest(points, points, 7);
    set_thread_count(0);
    for (std::size_t q = 0; q < one.size(); ++q)
        for (std::size_t i = 0; i < 7; ++i)
            ASSERT_EQ(one[q][i].point, four[q][i].point);
}

TEST(NearestPoints, RefusesWhatHasNoNearest)
{
    const Points none(0, 3);
    EXPECT_EQ(test::message_of([&] { NearestPoints{none}; }), "the nearest of no points is asked for");
    Points points = Points::Zero(3, 3);
    EXPECT_EQ(test::message_of([&] { nearest(points, points, 0); }),
              "the number of neighbours is 0, but at least 1 was expected");
    Points far = Points::Constant(1, 3, 1e200);
    EXPECT_EQ(test::message_of([&] { nearest(points, far, 1); }),
              "point 0 is not finite, or too far from the others to decide which are near");
    for (int c = 0; c < 3; ++c) {
        Points query = Points::Zero(2, 3);
        query(1, c) = NAN;
        EXPECT_EQ(test::message_of([&] { nearest(points, query, 1); }),
                  "point 1 is not finite, or too far from the others to decide which are near");
    }
    points(1, 2) = INFINITY;
    EXPECT_EQ(test::message_of([&] { NearestPoints{points}; }),
              "point 1 has a coordinate that is not finite");
}

} // namespace
