#include "libmorph/remesh/corner_table.h"

#include <algorithm>

namespace morph {

namespace {

/// A halfedge by its ends, the smaller first, so that sorting brings twins together.
struct Side {
    Index low, high, halfedge;

    bool operator<(const Side& other) const
    {
        return low != other.low ? low < other.low
                                : (high != other.high ? high < other.high : halfedge < other.halfedge);
    }
};

} // namespace

CornerTable::CornerTable(std::vector<TableVertex> net_vertices,
                         const std::vector<std::array<Index, 3>>& triangles)
    : vertices(std::move(net_vertices))
{
    from.reserve(3 * triangles.size());
    for (const auto& corners : triangles)
        from.insert(from.end(), corners.begin(), corners.end());
    tag.assign(from.size(), kNoTag);
    match_twins();
    for (std::size_t h = 0; h < from.size(); ++h) {
        Index& out = vertices[at(from[h])].out;
        if (out < 0)
            out = static_cast<Index>(h);
        if (twin[h] >= 0)
            continue;
        if (out == static_cast<Index>(h) || twin[at(out)] >= 0)
            out = static_cast<Index>(h);
        else
            give_fan_a_vertex(static_cast<Index>(h));
    }
}

/// @param h  the first of the halfedges from a vertex that has another fan of triangles too
void CornerTable::give_fan_a_vertex(Index h)
{
    const auto copy = static_cast<Index>(vertices.size());
    vertices.push_back(vertices[at(from[at(h)])]);
    vertices.back().out = h;
    for (; h >= 0; h = twin[at(previous(h))])
        from[at(h)] = copy;
}

void CornerTable::match_twins()
{
    std::vector<Index> first(vertices.size() + 1, 0);
    for (std::size_t h = 0; h < from.size(); ++h)
        ++first[at(std::min(from[h], to(static_cast<Index>(h)))) + 1];
    for (std::size_t v = 0; v < vertices.size(); ++v)
        first[v + 1] += first[v];
    std::vector<Side> sides(from.size());
    std::vector<Index> place(first.begin(), first.end() - 1);
    for (std::size_t h = 0; h < from.size(); ++h) {
        const Index end = to(static_cast<Index>(h));
        const Index low = std::min(from[h], end), high = std::max(from[h], end);
        sides[at(place[at(low)]++)] = {low, high, static_cast<Index>(h)};
    }
    twin.assign(from.size(), -1);
    for (std::size_t v = 0; v < vertices.size(); ++v)
        std::sort(sides.begin() + first[v], sides.begin() + first[v + 1]);
    for (std::size_t i = 1; i < sides.size(); ++i)
        if (sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high)
            join(sides[i].halfedge, sides[i - 1].halfedge);
}

void CornerTable::neighbours(Index vertex, std::vector<Index>& found) const
{
    found.clear();
    Index last = -1;
    around(vertex, [&](Index h) {
        found.push_back(to(h));
        last = h;
    });
    if (twin[at(previous(last))] < 0)
        found.push_back(apex(last));
}

void CornerTable::join(Index a, Index b)
{
    if (a >= 0)
        twin[at(a)] = b;
    if (b >= 0)
        twin[at(b)] = a;
}

void CornerTable::set(Index h, Index vertex, Index other, Index mark)
{
    from[at(h)] = vertex;
    tag[at(h)] = mark;
    join(h, other);
}

Index CornerTable::add_triangle()
{
    const auto first = static_cast<Index>(from.size());
    from.resize(from.size() + 3, -1);
    twin.resize(from.size(), -1);
    tag.resize(from.size(), kNoTag);
    return first;
}

Index CornerTable::split(Index h, const TableVertex& vertex)
{
    const auto middle = static_cast<Index>(vertices.size());
    vertices.push_back(vertex);
    const Index g = twin[at(h)];
    const std::array<Index, 2> halves{h, g};
    std::array<Index, 2> beyond{-1, -1}; // from the middle to the far end of each half
    for (std::size_t side = 0; side < 2; ++side) {
        const Index half = halves[side];
        if (half < 0)
            continue;
        const Index after = next(half);
        const Index end = to(half), top = apex(half);
        const Index made = add_triangle();
        set(made + 1, end, twin[at(after)], tag[at(after)]);
        if (vertices[at(end)].out == after)
            vertices[at(end)].out = made + 1;
        set(made, middle, -1, tag[at(half)]);
        set(made + 2, top, -1, kNoTag);
        set(after, middle, made + 2, kNoTag);
        beyond[side] = made;
    }
    join(h, beyond[1]);
    join(beyond[0], g);
    vertices[at(middle)].out = beyond[0];
    return middle;
}

bool CornerTable::collapsible(Index h) const
{
    const Index u = from[at(h)], v = to(h);
    const Index g = twin[at(h)];
    const auto leaves_a_side = [&](Index half) {
        return half < 0 || twin[at(next(half))] >= 0 || twin[at(previous(half))] >= 0;
    };
    if (!leaves_a_side(h) || !leaves_a_side(g))
        return false;
    std::array<Index, 64> near{};
    std::size_t count = 0;
    Index last = -1;
    around(u, [&](Index out) {
        if (count + 2 < near.size())
            near[count++] = to(out);
        last = out;
    });
    if (count + 2 >= near.size())
        return false;
    if (twin[at(previous(last))] < 0)
        near[count++] = apex(last);
    int common = 0;
    const auto look = [&](Index w) {
        common += std::find(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), w) !=
                  near.begin() + static_cast<std::ptrdiff_t>(count);
    };
    around(v, [&](Index out) {
        look(to(out));
        last = out;
    });
    if (twin[at(previous(last))] < 0)
        look(apex(last));
    return common == (g < 0 ? 1 : 2);
}

/// Halfedge @p h belongs to a vertex: go clockwise to the border, if there is one.
void CornerTable::start_at_border(Index vertex, Index h)
{
    Index out = h;
    while (twin[at(out)] >= 0) {
        out = next(twin[at(out)]);
        if (out == h)
            break;
    }
    vertices[at(vertex)].out = out;
}

/// The triangle of @p h, of which the end @p keep stays, shrinks to its other two sides in one.
void CornerTable::close(Index h, Index keep)
{
    const bool keep_is_end = from[at(h)] != keep;
    const Index to_top = keep_is_end ? next(h) : previous(h);  // the side of the kept vertex
    const Index of_gone = keep_is_end ? previous(h) : next(h); // and that of the one that goes
    const Index top = apex(h);
    const Index kept_beyond = twin[at(to_top)], gone_beyond = twin[at(of_gone)];
    Index mark = tag[at(to_top)];
    if (mark == kNoTag && tag[at(of_gone)] != kNoTag)
        mark = tag[at(of_gone)] == kKeptTag ? kKeptTag : tag[at(of_gone)] ^ 1;
    const Index reversed = mark < 0 || mark == kKeptTag ? mark : mark ^ 1;
    if (gone_beyond >= 0)
        tag[at(gone_beyond)] = mark;
    if (kept_beyond >= 0)
        tag[at(kept_beyond)] = reversed;
    join(kept_beyond, gone_beyond);
    const Index base = h - h % 3;
    std::fill_n(from.begin() + base, 3, -1);
    // Of the two halfedges beyond, one runs from the top to the kept vertex and one back.
    const Index down = keep_is_end ? kept_beyond : gone_beyond;
    const Index up = keep_is_end ? gone_beyond : kept_beyond;
    start_at_border(top, down >= 0 ? down : next(up));
    vertices[at(keep)].out = up >= 0 ? up : next(down);
}

void CornerTable::collapse(Index h, Index keep)
{
    const Index gone = from[at(h)] == keep ? to(h) : from[at(h)];
    const Index g = twin[at(h)];
    std::vector<Index> outs;
    around(gone, [&](Index out) { outs.push_back(out); });
    for (const Index out : outs)
        if (out / 3 != h / 3 && (g < 0 || out / 3 != g / 3))
            from[at(out)] = keep;
    close(h, keep);
    if (g >= 0)
        close(g, keep);
    vertices[at(gone)].out = -1;
    start_at_border(keep, vertices[at(keep)].out);
}

void CornerTable::flip(Index h)
{
    const Index g = twin[at(h)];
    const Index a = from[at(h)], b = to(h), c = apex(h), d = apex(g);
    const std::array<Index, 4> old{previous(h), next(g), previous(g), next(h)}; // c a, a d, d b, b c
    std::array<Index, 4> beyond{}, mark{};
    for (std::size_t i = 0; i < 4; ++i) {
        beyond[i] = twin[at(old[i])];
        mark[i] = tag[at(old[i])];
    }
    const Index s = h - h % 3, t = g - g % 3;
    const std::array<Index, 4> made{s, s + 1, t, t + 1};
    const std::array<Index, 4> start{c, a, d, b};
    // A border starts at one of the four sides; which halfedge that is has changed.
    for (std::size_t i = 0; i < 4; ++i) {
        Index& out = vertices[at(start[i])].out;
        if (out / 3 == s / 3 || out / 3 == t / 3)
            out = made[i];
    }
    for (std::size_t i = 0; i < 4; ++i) {
        from[at(made[i])] = start[i];
        tag[at(made[i])] = mark[i];
        twin[at(made[i])] = -1;
    }
    for (std::size_t i = 0; i < 4; ++i)
        join(made[i], beyond[i]);
    set(s + 2, d, t + 2, kNoTag);
    set(t + 2, c, s + 2, kNoTag);
}

void CornerTable::renumber(const std::vector<Index>& order)
{
    std::vector<Index> number(vertices.size(), -1);
    std::vector<TableVertex> kept;
    for (const Index v : order)
        if (vertices[at(v)].out >= 0) {
            number[at(v)] = static_cast<Index>(kept.size());
            kept.push_back(vertices[at(v)]);
        }
    std::vector<Index> lowest(kept.size() + 1, 0); // triangles by their smallest vertex, counted
    const auto smallest = [&](Index t) {
        return std::min({number[at(corner(t, 0))], number[at(corner(t, 1))], number[at(corner(t, 2))]});
    };
    for (Index t = 0; t < triangle_slots(); ++t)
        if (alive(t))
            ++lowest[at(smallest(t)) + 1];
    for (std::size_t v = 0; v < kept.size(); ++v)
        lowest[v + 1] += lowest[v];
    std::vector<Index> place(at(triangle_slots()), -1);
    const auto count = static_cast<std::size_t>(lowest.back());
    for (Index t = 0; t < triangle_slots(); ++t)
        if (alive(t))
            place[at(t)] = lowest[at(smallest(t))]++;
    const auto moved = [&](Index h) { return h < 0 ? -1 : 3 * place[at(h / 3)] + h % 3; };
    CornerTable made;
    made.from.resize(3 * count);
    made.twin.resize(3 * count);
    made.tag.resize(3 * count);
    for (Index h = 0; h < static_cast<Index>(from.size()); ++h)
        if (alive(h / 3)) {
            const std::size_t to = at(moved(h));
            made.from[to] = number[at(from[at(h)])];
            made.twin[to] = moved(twin[at(h)]);
            made.tag[to] = tag[at(h)];
        }
    for (TableVertex& vertex : kept)
        vertex.out = moved(vertex.out);
    made.vertices = std::move(kept);
    *this = std::move(made);
}

} // namespace morph
