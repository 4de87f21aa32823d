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

bool is_kept_side(const CornerTable& table, Index h)
{
    return table.from[at(h)] >= 0 && table.tag[at(h)] == kKeptTag;
}

/// The longest size that each vertex is given: what its curves allow, and no more than the longest kept side
/// there.
std::vector<double> most_at_vertices(const RemeshState& state)
{
    constexpr double kMaxTurn = std::numbers::pi / 6;
    constexpr double kUnlimited = std::numeric_limits<double>::infinity();
    const CornerTable& table = state.table;
    std::vector<double> by_curves(table.vertices.size(), kUnlimited), by_kept(table.vertices.size(), 0);
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h) {
        const bool kept = is_kept_side(table, h);
        if (!kept && !on_curve(table, h))
            continue;
        const double own = (table.point(table.from[at(h)]) - table.point(table.to(h))).norm();
        const double most = kept ? own : std::max(kMaxTurn * least_radius(state, h), own);
        for (const Index v : {table.from[at(h)], table.to(h)})
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

bool on_curve(const CornerTable& table, Index h)
{
    const Index mark = table.tag[at(h)];
    return mark >= 0 && mark != kKeptTag && table.twin[at(h)] < h;
}

double least_radius(const RemeshState& state, Index h)
{
    constexpr int kSamples = 4; // along an edge: a curve given may turn much between two nodes
    const auto [from, to] = edge_parameters(state, h);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kSamples; ++i) {
        const double u = from + (to - from) * (i + 0.5) / kSamples;
        least = std::min(least, state.curves[at(state.table.tag[at(h)] / 2)].radius(u));
    }
    return least;
}

void limit_by_curves(RemeshState& state)
{
    constexpr double kGradation = 1.2;
    CornerTable& table = state.table;
    const std::vector<double> most = most_at_vertices(state);
    std::vector<Index> lowered;
    for (std::size_t v = 0; v < most.size(); ++v)
        if (most[v] < table.vertices[v].size) {
            table.vertices[v].size = most[v];
            lowered.push_back(static_cast<Index>(v));
        }
    limit_gradation(table, kGradation, lowered);
    for (std::size_t v = 0; v < table.vertices.size(); ++v)
        state.background.vertices()[v].size = table.vertices[v].size;
}

} // namespace morph
