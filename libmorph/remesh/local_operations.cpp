#include "libmorph/remesh/local_operations.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

constexpr double kGoodEnough = 0.35; // quality a collapse may lower triangles to; smoothing repairs that

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Each edge once: by the halfedge of the lower number.
bool stands_for_edge(const CornerTable& table, Index h)
{
    return table.from[at(h)] >= 0 && (table.twin[at(h)] < 0 || h < table.twin[at(h)]);
}

/// A vertex may go along an edge for what holds it.
bool free_to_go(const CornerTable& table, Index vertex, Index edge_tag)
{
    const Index curve = table.vertices[at(vertex)].curve;
    if (curve == kFreeVertex)
        return edge_tag == kNoTag;
    return curve >= 0 && edge_tag >= 0 && edge_tag != kKeptTag && edge_tag / 2 == curve;
}

/// Two feature edges would fall together at the corner opposite to an edge.
bool joins_features(const CornerTable& table, Index h)
{
    const auto both = [&](Index half) {
        return half >= 0 && table.tag[at(CornerTable::next(half))] != kNoTag &&
               table.tag[at(CornerTable::previous(half))] != kNoTag;
    };
    return both(h) || both(table.twin[at(h)]);
}

} // namespace

bool try_collapse(RemeshState& state, Index h, Index keep, double least_quality, double longest)
{
    const CornerTable& table = state.table;
    const Index gone = table.from[at(h)] == keep ? table.to(h) : table.from[at(h)];
    if (!free_to_go(table, gone, table.tag[at(h)]) || joins_features(table, h))
        return false;
    const Index g = table.twin[at(h)];
    const Eigen::Vector3d& goal = table.point(keep);
    double before = 1, after = 1;
    bool fits = true;
    table.around(gone, [&](Index out) {
        if (!fits)
            return;
        before = std::min(before, triangle_quality(state, out / 3));
        if (out / 3 == h / 3 || (g >= 0 && out / 3 == g / 3))
            return;
        const Index a = table.to(out), b = table.apex(out);
        fits = may_replace(state, goal, table.point(a), table.point(b), surface_normal(state, out / 3)) &&
               relative_length(table, keep, a) < longest && relative_length(table, keep, b) < longest;
        after = std::min(after, triangle_quality(goal, table.point(a), table.point(b), state.planar));
    });
    if (!fits || after < std::min(before, least_quality) || !table.collapsible(h))
        return false;
    state.table.collapse(h, keep);
    return true;
}

std::size_t collapse_short_edges(RemeshState& state)
{
    CornerTable& table = state.table;
    std::size_t count = 0;
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h) {
        if (!stands_for_edge(table, h) ||
            relative_length(table, table.from[at(h)], table.to(h)) >= kShortEdge)
            continue;
        const Index a = table.from[at(h)], b = table.to(h);
        count += try_collapse(state, h, b, kGoodEnough) || try_collapse(state, h, a, kGoodEnough);
    }
    return count;
}

Index try_split(RemeshState& state, Index h)
{
    CornerTable& table = state.table;
    const Index mark = table.tag[at(h)];
    if (mark == kKeptTag)
        return -1;
    const TableVertex &a = table.vertices[at(table.from[at(h)])], &b = table.vertices[at(table.to(h))];
    TableVertex middle;
    middle.below = a.below;
    if (mark == kNoTag)
        put_at(state, middle, (a.point + b.point) / 2);
    else {
        const auto [from, to] = edge_parameters(state, h);
        put_on_curve(state, middle, mark / 2, (from + to) / 2);
    }
    for (const Index half : {h, table.twin[at(h)]})
        if (half >= 0) {
            const Eigen::Vector3d normal = surface_normal(state, half / 3);
            const Eigen::Vector3d &from = table.point(table.from[at(half)]),
                                  &to = table.point(table.to(half)), &top = table.point(table.apex(half));
            if (!may_replace(state, from, middle.point, top, normal) ||
                !may_replace(state, middle.point, to, top, normal))
                return -1;
        }
    return table.split(h, middle);
}

std::size_t split_long_edges(RemeshState& state, double longest)
{
    CornerTable& table = state.table;
    const auto present = static_cast<Index>(table.from.size());
    std::size_t count = 0;
    for (Index h = 0; h < present; ++h)
        if (stands_for_edge(table, h) && relative_length(table, table.from[at(h)], table.to(h)) > longest)
            count += try_split(state, h) >= 0 ? 1 : 0;
    return count;
}

} // namespace morph
