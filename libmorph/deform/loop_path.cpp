#include "libmorph/deform/loop_path.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace morph {

namespace {

using Polygon = std::vector<std::complex<double>>;

std::complex<double> edge(const Polygon& corners, std::size_t i)
{
    return corners[(i + 1) % corners.size()] - corners[i];
}

std::complex<double> mean(const Polygon& corners)
{
    return std::accumulate(corners.begin(), corners.end(), std::complex<double>()) /
           static_cast<double>(corners.size());
}

/// Angle by which the next edge turns against edge i.
double corner_turn(const Polygon& corners, std::size_t i)
{
    return std::arg(edge(corners, (i + 1) % corners.size()) / edge(corners, i));
}

/// By how much each edge turns from one shape to the other, without jumps from edge to edge.
std::vector<double> edge_turns(const Polygon& from, const Polygon& to)
{
    std::vector<double> turn{std::arg(edge(to, 0) / edge(from, 0))};
    double sum = 0, length = 0;
    for (std::size_t i = 0; i < from.size(); ++i) {
        sum += std::abs(edge(from, i)) * turn[i];
        length += std::abs(edge(from, i));
        turn.push_back(turn[i] + corner_turn(to, i) - corner_turn(from, i));
    }
    turn.pop_back(); // the first one once more
    const double full = 2 * std::numbers::pi;
    for (double& angle : turn)
        angle -= full * std::round(sum / length / full);
    return turn;
}

/// Make edges add up to 0 by Bowditch's rule. Stretching them alone would do, but take short ones through 0.
void close(Polygon& edges)
{
    std::complex<double> gap = 0;
    double length = 0;
    for (const std::complex<double>& e : edges) {
        gap += e;
        length += std::abs(e);
    }
    for (std::complex<double>& e : edges)
        e -= gap * (std::abs(e) / length);
}

} // namespace

LoopPath::LoopPath(Polygon from, Polygon to)
    : from_(std::move(from)), to_(std::move(to)), turn_(edge_turns(from_, to_))
{
}

Polygon LoopPath::at(double f) const
{
    if (f == 1)
        return to_;
    Polygon edges(from_.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const double stretch = std::abs(edge(to_, i)) / std::abs(edge(from_, i));
        edges[i] = edge(from_, i) * std::polar(1 + f * (stretch - 1), f * turn_[i]);
    }
    close(edges);
    Polygon corners{0};
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
        corners.push_back(corners.back() + edges[i]);
    const std::complex<double> shift = mean(from_) + f * (mean(to_) - mean(from_)) - mean(corners);
    for (std::complex<double>& corner : corners)
        corner += shift;
    return corners;
}

} // namespace morph
