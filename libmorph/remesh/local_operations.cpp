#include "libmorph/remesh/local_operations.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

constexpr double kGoodEnough = 0.35; // quality a collapse may lower triangles to; relaxation mends that

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

/// Each edge once: by the halfedge of the lower number.
bool stands_for_edge(const CornerTable& net, Index h)
{
    return net.from[at(h)] >= 0 && (net.twin[at(h)] < 0 || h < net.twin[at(h)]);
}

/// A vertex may go along an edge for what holds it.
bool free_to_go(const CornerTable& net, Index vertex, Index edge_tag)
{
    const Index curve = net.vertices[at(vertex)].curve;
    if (curve == kFreeVertex)
        return edge_tag == kNoTag;
    return curve >= 0 && edge_tag >= 0 && edge_tag != kKeptTag && edge_tag / 2 == curve;
}

/// Two feature edges would fall together at the corner opposite to an edge.
bool joins_features(const CornerTable& net, Index h)
{
    const auto both = [&](Index half) {
        return half >= 0 && net.tag[at(CornerTable::next(half))] != kNoTag &&
               net.tag[at(CornerTable::previous(half))] != kNoTag;
    };
    return both(h) || both(net.twin[at(h)]);
}

} // namespace

bool try_collapse(RemeshState& made, Index h, Index keep, double least_quality, double longest)
{
    const CornerTable& net = made.net;
    const Index gone = net.from[at(h)] == keep ? net.to(h) : net.from[at(h)];
    if (!free_to_go(net, gone, net.tag[at(h)]) || joins_features(net, h))
        return false;
    const Index g = net.twin[at(h)];
    const Eigen::Vector3d& goal = net.point(keep);
    double before = 1, after = 1;
    bool fits = true;
    net.around(gone, [&](Index out) {
        if (!fits)
            return;
        before = std::min(before, triangle_quality(made, out / 3));
        if (out / 3 == h / 3 || (g >= 0 && out / 3 == g / 3))
            return;
        const Index a = net.to(out), b = net.apex(out);
        fits = may_replace(made, goal, net.point(a), net.point(b), surface_normal(made, out / 3)) &&
               relative_length(net, keep, a) < longest && relative_length(net, keep, b) < longest;
        after = std::min(after, triangle_quality(goal, net.point(a), net.point(b), made.planar));
    });
    if (!fits || after < std::min(before, least_quality) || !net.collapsible(h))
        return false;
    made.net.collapse(h, keep);
    return true;
}

std::size_t collapse_short_edges(RemeshState& made)
{
    CornerTable& net = made.net;
    std::size_t count = 0;
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h) {
        if (!stands_for_edge(net, h) || relative_length(net, net.from[at(h)], net.to(h)) >= kShortEdge)
            continue;
        const Index a = net.from[at(h)], b = net.to(h);
        count += try_collapse(made, h, b, kGoodEnough) || try_collapse(made, h, a, kGoodEnough);
    }
    return count;
}

Index try_split(RemeshState& made, Index h)
{
    CornerTable& net = made.net;
    const Index mark = net.tag[at(h)];
    if (mark == kKeptTag)
        return -1;
    const TableVertex &a = net.vertices[at(net.from[at(h)])], &b = net.vertices[at(net.to(h))];
    TableVertex middle;
    middle.below = a.below;
    if (mark == kNoTag)
        place_free(made, middle, (a.point + b.point) / 2);
    else {
        const auto [from, to] = edge_parameters(made, h);
        parametrize_marker(made, middle, mark / 2, (from + to) / 2);
    }
    for (const Index half : {h, net.twin[at(h)]})
        if (half >= 0) {
            const Eigen::Vector3d normal = surface_normal(made, half / 3);
            const Eigen::Vector3d &from = net.point(net.from[at(half)]), &to = net.point(net.to(half)),
                                  &top = net.point(net.apex(half));
            if (!may_replace(made, from, middle.point, top, normal) ||
                !may_replace(made, middle.point, to, top, normal))
                return -1;
        }
    return net.split(h, middle);
}

std::size_t split_long_edges(RemeshState& made, double longest)
{
    CornerTable& net = made.net;
    const auto present = static_cast<Index>(net.from.size());
    std::size_t count = 0;
    for (Index h = 0; h < present; ++h)
        if (stands_for_edge(net, h) && relative_length(net, net.from[at(h)], net.to(h)) > longest)
            count += try_split(made, h) >= 0 ? 1 : 0;
    return count;
}

} // namespace morph
