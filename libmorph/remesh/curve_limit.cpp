#include "libmorph/remesh/curve_limit.h"

#include "libmorph/remesh/wanted_size.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace morph {

namespace {

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

} // namespace

bool on_curve(const TriangleNet& net, Index h)
{
    const Index mark = net.tag[at(h)];
    return mark >= 0 && mark != kKeptTag && net.twin[at(h)] < h;
}

double least_radius(const Remaking& made, Index h)
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

void limit_by_curves(Remaking& made)
{
    constexpr double kTurn = std::numbers::pi / 6;
    constexpr double kGradation = 1.2;
    TriangleNet& net = made.net;
    std::vector<Index> lowered;
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h) {
        if (!on_curve(net, h))
            continue;
        const std::array<Index, 2> ends{net.from[at(h)], net.to(h)};
        const double own = (net.point(ends[0]) - net.point(ends[1])).norm();
        const double most = std::max(kTurn * least_radius(made, h), own);
        for (const Index v : ends) {
            double& size = net.vertices[at(v)].size;
            if (size <= most)
                continue;
            size = most;
            lowered.push_back(v);
        }
    }
    limit_gradation(net, kGradation, lowered);
    for (std::size_t v = 0; v < net.vertices.size(); ++v)
        made.underlay.vertices()[v].size = net.vertices[v].size;
}

} // namespace morph
