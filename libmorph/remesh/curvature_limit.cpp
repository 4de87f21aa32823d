#include "libmorph/remesh/curvature_limit.h"

#include "libmorph/remesh/target_size.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

bool is_kept_side(const CornerTable& net, Index h)
{
    return net.from[at(h)] >= 0 && net.tag[at(h)] == kKeptTag;
}

/// The longest size that each vertex is given: what its curves allow, and no more than the longest kept side
/// there.
std::vector<double> most_at_vertices(const RemeshState& made)
{
    constexpr double kTurn = std::numbers::pi / 6;
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const CornerTable& net = made.net;
    std::vector<double> by_curves(net.vertices.size(), kNone), by_kept(net.vertices.size(), 0);
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h) {
        const bool kept = is_kept_side(net, h);
        if (!kept && !on_curve(net, h))
            continue;
        const double own = (net.point(net.from[at(h)]) - net.point(net.to(h))).norm();
        const double most = kept ? own : std::max(kTurn * least_radius(made, h), own);
        for (const Index v : {net.from[at(h)], net.to(h)})
            if (kept)
                by_kept[at(v)] = std::max(by_kept[at(v)], most);
            else
                by_curves[at(v)] = std::min(by_curves[at(v)], most);
    }
    for (std::size_t v = 0; v < by_curves.size(); ++v)
        if (by_kept[v] > 0)
            by_curves[v] = std::min(by_curves[v], by_kept[v]);
    return by_curves;
}

} // namespace

bool on_curve(const CornerTable& net, Index h)
{
    const Index mark = net.tag[at(h)];
    return mark >= 0 && mark != kKeptTag && net.twin[at(h)] < h;
}

double least_radius(const RemeshState& made, Index h)
{
    constexpr int kSamples = 4; // along an edge: a curve given may turn much between two nodes
    const auto [from, to] = edge_parameters(made, h);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kSamples; ++i) {
        const double u = from + (to - from) * (i + 0.5) / kSamples;
        least = std::min(least, made.curves[at(made.net.tag[at(h)] / 2)].radius(u));
    }
    return least;
}

void limit_by_curves(RemeshState& made)
{
    constexpr double kGradation = 1.2;
    CornerTable& net = made.net;
    const std::vector<double> most = most_at_vertices(made);
    std::vector<Index> lowered;
    for (std::size_t v = 0; v < most.size(); ++v)
        if (most[v] < net.vertices[v].size) {
            net.vertices[v].size = most[v];
            lowered.push_back(static_cast<Index>(v));
        }
    limit_gradation(net, kGradation, lowered);
    for (std::size_t v = 0; v < net.vertices.size(); ++v)
        made.underlay.vertices()[v].size = net.vertices[v].size;
}

} // namespace morph
