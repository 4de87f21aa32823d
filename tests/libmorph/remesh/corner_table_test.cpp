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

/// Every link of the corner table against every other.
void expect_sound(const CornerTable& table)
{
    std::set<std::array<Index, 2>> sides;
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h) {
        if (!table.alive(h / 3))
            continue;
        EXPECT_TRUE(sides.insert({table.from[at(h)], table.to(h)}).second);
        const Index g = table.twin[at(h)];
        if (g < 0)
            continue;
        EXPECT_EQ(table.twin[at(g)], h);
        EXPECT_EQ(table.from[at(g)], table.to(h));
        EXPECT_EQ(table.to(g), table.from[at(h)]);
    }
    std::vector<int> uses(table.vertices.size(), 0), around(table.vertices.size(), 0);
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h)
        if (table.alive(h / 3))
            ++uses[at(table.from[at(h)])];
    for (std::size_t v = 0; v < table.vertices.size(); ++v) {
        if (table.vertices[v].out < 0)
            continue;
        table.around(static_cast<Index>(v), [&](Index h) {
            EXPECT_EQ(table.from[at(h)], static_cast<Index>(v));
            ++around[v];
        });
    }
    EXPECT_EQ(around, uses); // a circulation passes all triangles of its vertex: it starts at the border
}

Index count_alive(const CornerTable& table)
{
    Index count = 0;
    for (Index t = 0; t < table.triangle_slots(); ++t)
        count += table.alive(t) ? 1 : 0;
    return count;
}

TEST(CornerTable, SplittingAnInnerEdgeAddsTwoTrianglesAndABorderEdgeOne)
{
    CornerTable table = grid(1);
    Index inner = 0, border = 0;
    for (Index h = 0; h < 6; ++h)
        (table.twin[at(h)] >= 0 ? inner : border) = h;
    table.split(inner, {});
    EXPECT_EQ(count_alive(table), 4);
    table.split(border, {});
    EXPECT_EQ(count_alive(table), 5);
    expect_sound(table);
}

TEST(CornerTable, StaysSoundUnderRandomOperations)
{
    CornerTable table = grid(6);
    std::mt19937 random(7);
    int collapses = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto h = static_cast<Index>(random() % table.from.size());
        if (!table.alive(h / 3))
            continue;
        const Index g = table.twin[at(h)];
        switch (random() % 3) {
        case 0:
            table.split(h, {});
            break;
        case 1: {
            // Two border vertices whose edge is none would pinch the corner table.
            const bool bridge = g >= 0 && table.at_border(table.from[at(h)]) && table.at_border(table.to(h));
            if (!bridge && table.collapsible(h)) {
                const Index keep = random() % 2 == 0 || g >= 0 ? table.to(h) : table.from[at(h)];
                if (g < 0 || !table.at_border(table.from[at(h)])) {
                    table.collapse(h, keep);
                    ++collapses;
                }
            }
            break;
        }
        default: {
            std::vector<Index> near;
            if (g < 0)
                break;
            table.neighbours(table.apex(h), near);
            if (std::find(near.begin(), near.end(), table.apex(g)) == near.end())
                table.flip(h);
        }
        }
        if (i % 300 == 0)
            expect_sound(table);
    }
    EXPECT_GT(collapses, 100);
    std::vector<Index> order;
    for (std::size_t v = table.vertices.size(); v-- > 0;)
        order.push_back(static_cast<Index>(v));
    const Index triangles = count_alive(table);
    table.renumber(order);
    EXPECT_EQ(table.triangle_slots(), triangles);
    expect_sound(table);
}

TEST(CornerTable, CollapseMovesTheTagOfTheSideThatGoesToTheOneThatStays)
{
    CornerTable table = grid(2); // vertex 4 is the middle
    Index h = -1;
    table.around(4, [&](Index out) { h = table.to(out) == 5 ? out : h; });
    ASSERT_GE(h, 0);
    const Index side = CornerTable::previous(h); // from the corner opposite to the vertex that goes
    const Index beyond = table.twin[at(side)];
    table.tag[at(side)] = 6;
    table.tag[at(beyond)] = 7;
    const Index top = table.apex(h);
    table.collapse(h, 5);
    Index found = kNoTag;
    table.around(5, [&](Index out) { found = table.to(out) == top ? table.tag[at(out)] : found; });
    EXPECT_EQ(found, 7); // it runs from the vertex to the corner
    expect_sound(table);
}

TEST(CornerTable, CollapsesAVertexOfManyTriangles)
{
    constexpr Index kAround = 200;
    std::vector<TableVertex> vertices(at(kAround + 1));
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 0; i < kAround; ++i)
        triangles.push_back({kAround, i, (i + 1) % kAround});
    CornerTable table(vertices, triangles);
    const Index h = table.vertices[at(kAround)].out;
    table.collapse(h, table.to(h));
    EXPECT_EQ(count_alive(table), kAround - 2);
    expect_sound(table);
}

TEST(CornerTable, GivesEachFanOfAVertexItsOwnCopy)
{
    std::vector<TableVertex> vertices(5);
    const CornerTable table(vertices, {{0, 1, 2}, {0, 3, 4}});
    EXPECT_EQ(table.vertices.size(), 6U);
    expect_sound(table);
}

} // namespace
} // namespace morph
