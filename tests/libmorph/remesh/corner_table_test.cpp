#include "libmorph/remesh/corner_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace morph {
namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// n x n squares, each cut in two.
CornerTable grid(Index n)
{
    std::vector<TableVertex> vertices(at((n + 1) * (n + 1)));
    std::vector<std::array<Index, 3>> triangles;
    for (Index j = 0; j <= n; ++j)
        for (Index i = 0; i <= n; ++i)
            vertices[at(j * (n + 1) + i)].point = {double(i), double(j), 0};
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
            const Index a = j * (n + 1) + i, b = a + n + 1;
            triangles.push_back({a, a + 1, b + 1});
            triangles.push_back({a, b + 1, b});
        }
    return {vertices, triangles};
}

/// Every link of the net against every other.
void expect_sound(const CornerTable& net)
{
    std::set<std::array<Index, 2>> sides;
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h) {
        if (!net.alive(h / 3))
            continue;
        EXPECT_TRUE(sides.insert({net.from[at(h)], net.to(h)}).second);
        const Index g = net.twin[at(h)];
        if (g < 0)
            continue;
        EXPECT_EQ(net.twin[at(g)], h);
        EXPECT_EQ(net.from[at(g)], net.to(h));
        EXPECT_EQ(net.to(g), net.from[at(h)]);
    }
    std::vector<int> uses(net.vertices.size(), 0), around(net.vertices.size(), 0);
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h)
        if (net.alive(h / 3))
            ++uses[at(net.from[at(h)])];
    for (std::size_t v = 0; v < net.vertices.size(); ++v) {
        if (net.vertices[v].out < 0)
            continue;
        net.around(static_cast<Index>(v), [&](Index h) {
            EXPECT_EQ(net.from[at(h)], static_cast<Index>(v));
            ++around[v];
        });
    }
    EXPECT_EQ(around, uses); // a circulation passes all triangles of its vertex: it starts at the border
}

Index count_alive(const CornerTable& net)
{
    Index count = 0;
    for (Index t = 0; t < net.triangle_slots(); ++t)
        count += net.alive(t) ? 1 : 0;
    return count;
}

TEST(CornerTable, SplittingAnInnerEdgeAddsTwoTrianglesAndABorderEdgeOne)
{
    CornerTable net = grid(1);
    Index inner = 0, border = 0;
    for (Index h = 0; h < 6; ++h)
        (net.twin[at(h)] >= 0 ? inner : border) = h;
    net.split(inner, {});
    EXPECT_EQ(count_alive(net), 4);
    net.split(border, {});
    EXPECT_EQ(count_alive(net), 5);
    expect_sound(net);
}

TEST(CornerTable, StaysSoundUnderRandomOperations)
{
    CornerTable net = grid(6);
    std::mt19937 random(7);
    int collapses = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto h = static_cast<Index>(random() % net.from.size());
        if (!net.alive(h / 3))
            continue;
        const Index g = net.twin[at(h)];
        switch (random() % 3) {
        case 0:
            net.split(h, {});
            break;
        case 1: {
            // Two border vertices whose edge is none would pinch the net.
            const bool bridge = g >= 0 && net.at_border(net.from[at(h)]) && net.at_border(net.to(h));
            if (!bridge && net.collapsible(h)) {
                const Index keep = random() % 2 == 0 || g >= 0 ? net.to(h) : net.from[at(h)];
                if (g < 0 || !net.at_border(net.from[at(h)])) {
                    net.collapse(h, keep);
                    ++collapses;
                }
            }
            break;
        }
        default: {
            std::vector<Index> near;
            if (g < 0)
                break;
            net.neighbours(net.apex(h), near);
            if (std::find(near.begin(), near.end(), net.apex(g)) == near.end())
                net.flip(h);
        }
        }
        if (i % 300 == 0)
            expect_sound(net);
    }
    EXPECT_GT(collapses, 100);
    std::vector<Index> order;
    for (std::size_t v = net.vertices.size(); v-- > 0;)
        order.push_back(static_cast<Index>(v));
    const Index triangles = count_alive(net);
    net.renumber(order);
    EXPECT_EQ(net.triangle_slots(), triangles);
    expect_sound(net);
}

TEST(CornerTable, CollapseMovesTheTagOfTheSideThatGoesToTheOneThatStays)
{
    CornerTable net = grid(2); // vertex 4 is the middle
    Index h = -1;
    net.around(4, [&](Index out) { h = net.to(out) == 5 ? out : h; });
    ASSERT_GE(h, 0);
    const Index side = CornerTable::previous(h); // from the corner opposite to the vertex that goes
    const Index beyond = net.twin[at(side)];
    net.tag[at(side)] = 6;
    net.tag[at(beyond)] = 7;
    const Index top = net.apex(h);
    net.collapse(h, 5);
    Index found = kNoTag;
    net.around(5, [&](Index out) { found = net.to(out) == top ? net.tag[at(out)] : found; });
    EXPECT_EQ(found, 7); // it runs from the vertex to the corner
    expect_sound(net);
}

TEST(CornerTable, CollapsesAVertexOfManyTriangles)
{
    constexpr Index kAround = 200;
    std::vector<TableVertex> vertices(at(kAround + 1));
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 0; i < kAround; ++i)
        triangles.push_back({kAround, i, (i + 1) % kAround});
    CornerTable net(vertices, triangles);
    const Index h = net.vertices[at(kAround)].out;
    net.collapse(h, net.to(h));
    EXPECT_EQ(count_alive(net), kAround - 2);
    expect_sound(net);
}

TEST(CornerTable, GivesEachFanOfAVertexItsOwnCopy)
{
    std::vector<TableVertex> vertices(5);
    const CornerTable net(vertices, {{0, 1, 2}, {0, 3, 4}});
    EXPECT_EQ(net.vertices.size(), 6U);
    expect_sound(net);
}

} // namespace
} // namespace morph
