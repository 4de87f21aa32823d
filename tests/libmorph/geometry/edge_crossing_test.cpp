#include "libmorph/geometry/edge_crossing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace {

using namespace morph;
using Edges = std::vector<std::array<Index, 2>>;

Points rows(std::initializer_list<std::array<double, 2>> places)
{
    Points points = Points::Zero(static_cast<Index>(places.size()), 3);
    Index row = 0;
    for (const auto& place : places)
        points.row(row++).head<2>() << place[0], place[1];
    return points;
}

Edges closed(Index count)
{
    Edges edges;
    for (Index i = 0; i < count; ++i)
        edges.push_back({i, (i + 1) % count});
    return edges;
}

TEST(EdgeCrossing, IsThePlaceWhereTwoEdgesCross)
{
    const auto found = find_edge_crossing(rows({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), closed(4));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->edges, (std::array<Index, 2>{0, 2}));
    EXPECT_LT((found->point - Eigen::Vector2d(1, 1)).norm(), 1e-15);
}

TEST(EdgeCrossing, IsNoneWhereEdgesOnlyShareTheirEnds)
{
    EXPECT_FALSE(find_edge_crossing(rows({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), closed(4)));
    EXPECT_FALSE(find_edge_crossing(rows({{0, 0}, {1, 0}, {2, 0}}), {{0, 1}, {1, 2}})); // straight on
    EXPECT_FALSE(find_edge_crossing(rows({{0, 0}, {1, 0}}), {{0, 1}, {1, 0}}));         // one edge
    EXPECT_FALSE(find_edge_crossing(Points(0, 3), {}));
}

TEST(EdgeCrossing, TouchingAndOverlappingEdgesCount)
{
    // An end on another edge; a spike that goes back on itself; two equal places that are two vertices.
    EXPECT_TRUE(find_edge_crossing(rows({{0, 0}, {2, 0}, {1, 0}, {1, 1}}), {{0, 1}, {2, 3}}));
    EXPECT_TRUE(find_edge_crossing(rows({{0, 0}, {2, 0}, {1, 0}}), {{0, 1}, {1, 2}}));
    EXPECT_TRUE(find_edge_crossing(rows({{0, 0}, {2, 0}, {1, 0}, {3, 0}}), {{0, 1}, {2, 3}}));
    EXPECT_TRUE(find_edge_crossing(rows({{0, 0}, {1, 0}, {1, 0}, {1, 1}}), {{0, 1}, {2, 3}}));
}

TEST(EdgeCrossing, IsDecidedExactlyWhereEdgesNearlyTouch)
{
    // The end of the second edge lies one ulp above or on the first, a diagonal.
    const double x = 0.3;
    const auto meets = [&](double y) {
        return find_edge_crossing(rows({{0, 0}, {1, 1}, {x, y}, {0, 1}}), {{0, 1}, {2, 3}}).has_value();
    };
    EXPECT_TRUE(meets(x));
    EXPECT_FALSE(meets(std::nextafter(x, 1.0)));
    EXPECT_TRUE(meets(std::nextafter(x, 0.0)));
}

TEST(EdgeCrossing, OfManyEdgesIsTheFirstThatALookAtEachPairFinds)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(0, 1);
    for (int round = 0; round < 200; ++round) {
        Points points = Points::Zero(40, 3);
        Edges edges;
        for (Index i = 0; i < 20; ++i) { // short edges: some rounds have crossings, some have none
            points.row(2 * i) << place(random), place(random), 0;
            points.row(2 * i + 1) =
                points.row(2 * i) + 0.08 * Eigen::RowVector3d(place(random), place(random), 0);
            edges.push_back({2 * i, 2 * i + 1});
        }
        std::optional<std::array<Index, 2>> wanted;
        for (Index i = 0; i < 20 && !wanted; ++i)
            for (Index j = i + 1; j < 20 && !wanted; ++j)
                if (find_edge_crossing(
                        points, {edges[static_cast<std::size_t>(i)], edges[static_cast<std::size_t>(j)]}))
                    wanted = {i, j};
        const auto found = find_edge_crossing(points, edges);
        ASSERT_EQ(found.has_value(), wanted.has_value());
        if (found) {
            EXPECT_EQ(found->edges, *wanted);
        }
    }
}

TEST(EdgeCrossing, IsNoneInALargePolygonAndFoundInABentOne)
{
    constexpr Index kCount = 20000;
    Points circle = Points::Zero(kCount, 3);
    for (Index i = 0; i < kCount; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCount;
        circle.row(i) << std::cos(angle), std::sin(angle), 0;
    }
    EXPECT_FALSE(find_edge_crossing(circle, closed(kCount)));
    circle.row(100) *= -0.5; // a spike through the other side's inside, not its edges
    EXPECT_FALSE(find_edge_crossing(circle, closed(kCount)));
    circle.row(100) *= 3;
    EXPECT_TRUE(find_edge_crossing(circle, closed(kCount)));
}

} // namespace
