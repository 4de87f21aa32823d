#include "libmorph/basis/node_path.h"

#include "libmorph/basis/bezier.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

// Share of the effort that goes by length alone, so that knots do not crowd where the curve bends.
constexpr double kLengthShare = 0.2;

double segment_length(const NodePath& path, Index i)
{
    return (path.points.row(i + 1) - path.points.row(i)).norm();
}

/// Angle between the edges before and after a point.
double turn_at(const NodePath& path, Index i)
{
    const Eigen::RowVector2d before = path.points.row(i) - path.points.row(i - 1);
    const Eigen::RowVector2d after = path.points.row(i + 1) - path.points.row(i);
    return std::abs(std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after)));
}

/// One segment of the nodes, the last point left out, with points added on its edges until there are at
/// least @p inner between its ends.
void append_segment(const Points2& nodes, Index first, Index edges, Index inner,
                    std::vector<Eigen::RowVector2d>& points)
{
    const Index pieces = (inner + edges) / edges; // edges * pieces - 1 >= inner
    const auto node = [&](Index i) { return nodes.row((first + i) % nodes.rows()); };
    for (Index edge = 0; edge < edges; ++edge)
        for (Index k = 0; k < pieces; ++k) {
            const double share = static_cast<double>(k) / pieces;
            points.emplace_back((1 - share) * node(edge) + share * node(edge + 1));
        }
}

void set_chord_lengths(NodePath& path)
{
    const Index count = static_cast<Index>(path.points.rows());
    path.t.assign(static_cast<std::size_t>(count), 0.0);
    for (Index i = 1; i < count; ++i)
        path.t[static_cast<std::size_t>(i)] =
            path.t[static_cast<std::size_t>(i) - 1] + segment_length(path, i - 1);
    const double total = path.t.back();
    for (double& t : path.t)
        t /= total;
}

/// Value at a place between points i and i + 1, counted in points.
double at_place(const std::vector<double>& values, double place)
{
    const double low = std::min(std::floor(place), static_cast<double>(values.size()) - 2);
    const auto i = static_cast<std::size_t>(low);
    return values[i] + (place - low) * (values[i + 1] - values[i]);
}

/// The place, counted in points, where increasing values reach @p value.
double place_of(const std::vector<double>& values, Index first, Index last, double value)
{
    const auto begin = values.begin() + first;
    const auto after =
        std::clamp(std::upper_bound(begin, values.begin() + last, value), begin + 1, values.begin() + last);
    const double low = *(after - 1);
    const double step = *after - low;
    const double share = step > 0 ? std::clamp((value - low) / step, 0.0, 1.0) : 0.0;
    return static_cast<double>(after - values.begin() - 1) + share;
}

/// Places of the knots inside one segment of @p spans spans, at equal steps of the effort but so far apart
/// that each span holds a point.
std::vector<double> place_in_segment(const Effort& effort, Index first, Index last, Index spans)
{
    const double low = effort[static_cast<std::size_t>(first)];
    const double high = effort[static_cast<std::size_t>(last)];
    const double mean = static_cast<double>(last - first) / spans;
    const double apart = std::min(mean, 1 + 0.5 * std::min(1.0, mean - 1));
    std::vector<double> places;
    double least = first;
    for (Index j = 1; j < spans; ++j) {
        const double wanted = place_of(effort, first, last, low + (high - low) * j / spans);
        least = std::max(wanted, least + apart);
        places.push_back(least);
    }
    double most = last;
    for (std::size_t j = places.size(); j-- > 0;) {
        most = std::min(places[j], most - apart);
        places[j] = most;
    }
    return places;
}

/// Number of spans of each segment: one each, and the rest where the effort per span is largest.
std::vector<Index> share_spans(const NodePath& path, const Effort& effort, int degree, Index control_points)
{
    const auto segments = static_cast<Index>(path.pins.size()) - 1;
    if (path.smooth_seam)
        return {control_points};
    std::vector<Index> spans(static_cast<std::size_t>(segments), 1);
    const auto most = [&](std::size_t s) { return path.pins[s + 1] - path.pins[s] + 1 - degree; };
    const auto load = [&](std::size_t s) {
        const double total = effort[static_cast<std::size_t>(path.pins[s + 1])] -
                             effort[static_cast<std::size_t>(path.pins[s])];
        return spans[s] < most(s) ? total / spans[s] : -1.0;
    };
    for (Index extra = control_points - segments * degree - (path.closed ? 0 : 1); extra > 0; --extra) {
        std::size_t busiest = 0;
        for (std::size_t s = 1; s < spans.size(); ++s)
            if (load(s) > load(busiest))
                busiest = s;
        ++spans[busiest];
    }
    return spans;
}

/// |D^p C| is constant on each piece; vectors of it, one per piece.
std::vector<Eigen::Vector2d> highest_derivatives(const std::vector<BezierPiece>& pieces)
{
    std::vector<Eigen::Vector2d> derivatives;
    for (const BezierPiece& piece : pieces) {
        std::vector<Eigen::Vector3d> difference = piece.control;
        double factor = 1;
        for (std::size_t p = difference.size() - 1; p > 0; --p) {
            for (std::size_t k = 0; k < p; ++k)
                difference[k] = difference[k + 1] - difference[k];
            factor *= static_cast<double>(p) / (piece.end - piece.begin);
        }
        derivatives.emplace_back(factor * difference[0].head<2>());
    }
    return derivatives;
}

/// |D^(p+1) C|^(1/(p+1)) on each piece, from the jumps to the neighbouring pieces, not across corners.
std::vector<double> piece_efforts(const std::vector<BezierPiece>& pieces, const NodePath& path, int degree)
{
    const std::vector<Eigen::Vector2d> D = highest_derivatives(pieces);
    const auto is_pin = [&](double u) {
        return std::any_of(path.pins.begin(), path.pins.end(),
                           [&](Index pin) { return path.t[static_cast<std::size_t>(pin)] == u; });
    };
    std::vector<double> sum(pieces.size(), 0.0);
    std::vector<int> count(pieces.size(), 0);
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const std::size_t next = (k + 1) % pieces.size();
        if (next == k || (is_pin(pieces[k].end) && !(next == 0 && path.smooth_seam)))
            continue;
        const double width = 0.5 * (pieces[k].end - pieces[k].begin + pieces[next].end - pieces[next].begin);
        for (const std::size_t side : {k, next}) {
            sum[side] += (D[next] - D[k]).norm() / width;
            ++count[side];
        }
    }
    for (std::size_t k = 0; k < pieces.size(); ++k)
        sum[k] = count[k] > 0 ? std::pow(sum[k] / count[k], 1.0 / (degree + 1)) : 0.0;
    return sum;
}

} // namespace

NodePath make_path(const Points2& nodes, bool closed, const std::vector<Index>& corners, int degree)
{
    NodePath path;
    path.closed = closed;
    path.smooth_seam = closed && corners.empty();
    const auto count = static_cast<Index>(nodes.rows());
    std::vector<Index> cuts = corners; // rows of nodes, unrolled: the first again at the end
    if (path.smooth_seam)
        cuts = {0};
    if (closed) {
        cuts.push_back(cuts.front() + count);
    } else {
        cuts.insert(cuts.begin(), 0);
        cuts.push_back(count - 1);
    }
    std::vector<Eigen::RowVector2d> points;
    for (std::size_t s = 0; s + 1 < cuts.size(); ++s) {
        path.pins.push_back(static_cast<Index>(points.size()));
        append_segment(nodes, cuts[s], cuts[s + 1] - cuts[s], degree - 1, points);
    }
    path.pins.push_back(static_cast<Index>(points.size()));
    points.emplace_back(nodes.row(cuts.back() % count));
    path.points.resize(std::ssize(points), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        path.points.row(static_cast<Eigen::Index>(i)) = points[i];
    set_chord_lengths(path);
    return path;
}

Effort polygon_effort(const NodePath& path)
{
    const auto count = static_cast<Index>(path.points.rows());
    std::vector<double> turning(static_cast<std::size_t>(count), 0.0);
    for (Index i = 1; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const bool inside = i + 1 < count && !std::binary_search(path.pins.begin(), path.pins.end(), i);
        turning[at] = turning[at - 1] + (inside ? turn_at(path, i) : 0.0);
    }
    Effort effort = path.t;
    if (turning.back() > 0)
        for (std::size_t i = 0; i < effort.size(); ++i)
            effort[i] = 0.5 * effort[i] + 0.5 * turning[i] / turning.back();
    return effort;
}

Effort curve_effort(const NodePath& path, const Curve& curve)
{
    const std::vector<BezierPiece> pieces = bezier_pieces(curve);
    const std::vector<double> rate = piece_efforts(pieces, path, curve.degree());
    double total = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k)
        total += rate[k] * (pieces[k].end - pieces[k].begin);
    const double share = total > 0 ? (1 - kLengthShare) / total : 0.0;
    Effort effort;
    std::size_t piece = 0;
    double before = 0; // effort of the pieces passed
    for (const double t : path.t) {
        for (; piece + 1 < pieces.size() && t >= pieces[piece].end; ++piece)
            before += rate[piece] * (pieces[piece].end - pieces[piece].begin);
        effort.push_back(share * (before + rate[piece] * (t - pieces[piece].begin)) + kLengthShare * t);
    }
    return effort;
}

std::vector<double> place_knots(const NodePath& path, const Effort& effort, int degree, Index control_points)
{
    const std::vector<Index> spans = share_spans(path, effort, degree, control_points);
    std::vector<double> knots(path.closed ? 1 : static_cast<std::size_t>(degree) + 1, 0.0);
    for (std::size_t s = 0; s < spans.size(); ++s) {
        for (const double place : place_in_segment(effort, path.pins[s], path.pins[s + 1], spans[s]))
            knots.push_back(at_place(path.t, place));
        const bool open_end = !path.closed && s + 1 == spans.size();
        const int repeats = path.smooth_seam ? 1 : degree + (open_end ? 1 : 0);
        knots.insert(knots.end(), static_cast<std::size_t>(repeats),
                     path.t[static_cast<std::size_t>(path.pins[s + 1])]);
    }
    return knots;
}

} // namespace morph
