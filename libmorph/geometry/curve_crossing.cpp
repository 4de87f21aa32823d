#include "libmorph/geometry/curve_crossing.h"

#include "libmorph/core/predicates.h"
#include "libmorph/geometry/curve_arc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace morph {

namespace {

constexpr double kStraight = 1e-10;  // of the size: arcs this straight are taken for their chords
constexpr double kSamePlace = 1e-12; // of the size: ends this close coincide

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Projections of the control points on a direction.
std::array<double, 2> extent(const Arc& arc, const Eigen::Vector2d& direction)
{
    std::array<double, 2> range{arc.first().dot(direction), arc.first().dot(direction)};
    for (const Eigen::Vector2d& point : arc.points()) {
        range[0] = std::min(range[0], point.dot(direction));
        range[1] = std::max(range[1], point.dot(direction));
    }
    return range;
}

bool separated_along(const Arc& a, const Arc& b, const Eigen::Vector2d& direction)
{
    const auto first = extent(a, direction);
    const auto second = extent(b, direction);
    return first[1] < second[0] || second[1] < first[0];
}

/// A line between the two arcs exists across an axis, a chord, or the normal of one.
bool separated(const Arc& a, const Arc& b)
{
    for (const Eigen::Vector2d& chord : {Eigen::Vector2d(1, 0), a.chord(), b.chord()}) {
        if (separated_along(a, b, chord) || separated_along(a, b, {-chord.y(), chord.x()}))
            return true;
    }
    return false;
}

PlanePoint plane(const Eigen::Vector2d& point)
{
    return {point.x(), point.y()};
}

bool on_segment_box(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p)
{
    return (p.array() >= a.array().min(b.array())).all() && (p.array() <= a.array().max(b.array())).all();
}

/// The closed chords of two arcs have a point in common; exact.
bool chords_meet(const Arc& a, const Arc& b)
{
    const auto side = [](const Arc& arc, const Eigen::Vector2d& p) {
        return orientation(plane(arc.first()), plane(arc.last()), plane(p));
    };
    const std::array<int, 4> sides{side(a, b.first()), side(a, b.last()), side(b, a.first()),
                                   side(b, a.last())};
    if (sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0)
        return true;
    return (sides[0] == 0 && on_segment_box(a.first(), a.last(), b.first())) ||
           (sides[1] == 0 && on_segment_box(a.first(), a.last(), b.last())) ||
           (sides[2] == 0 && on_segment_box(b.first(), b.last(), a.first())) ||
           (sides[3] == 0 && on_segment_box(b.first(), b.last(), a.last()));
}

/// Share of the chord of @p a at which the line through that of @p b meets it; 1/2 when they are parallel.
double share_of_chord(const Arc& a, const Arc& b)
{
    const double denominator = cross(a.chord(), b.chord());
    const double share = cross(b.first() - a.first(), b.chord()) / denominator;
    return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5;
}

CurveCrossing place_of(const Arc& a, const Arc& b)
{
    const double s = share_of_chord(a, b);
    const double t = share_of_chord(b, a);
    return {a.begin() + s * (a.end() - a.begin()), b.begin() + t * (b.end() - b.begin()),
            a.first() + s * a.chord()};
}

using Found = std::optional<CurveCrossing>;

Found meet(const Arc& a, const Arc& b, double straight, int depth)
{
    if (separated(a, b))
        return {};
    const double bend_a = a.bend();
    const double bend_b = b.bend();
    if (std::max(bend_a, bend_b) <= straight || depth == kMaxHalvings)
        return chords_meet(a, b) ? Found(place_of(a, b)) : Found();
    if (bend_a > bend_b) {
        for (const Arc& half : a.halves())
            if (Found found = meet(half, b, straight, depth + 1))
                return found;
    } else {
        for (const Arc& half : b.halves())
            if (Found found = meet(a, half, straight, depth + 1))
                return found;
    }
    return {};
}

/// Do arcs meet elsewhere than where @p b goes on from the end of @p a?
Found meet_again(const Arc& a, const Arc& b, double straight, int depth)
{
    const Eigen::Vector2d ahead = a.chord().normalized() + b.chord().normalized();
    if (a.advances(ahead) && b.advances(ahead))
        return {};
    if ((a.bend() <= straight && b.bend() <= straight) || depth == kMaxHalvings) {
        const bool turns_back = orientation(plane(a.first()), plane(a.last()), plane(b.last())) == 0 &&
                                a.chord().dot(b.chord()) < 0;
        return turns_back ? Found(CurveCrossing{a.end(), b.begin(), a.last()}) : Found();
    }
    const std::array<Arc, 2> A = a.halves();
    const std::array<Arc, 2> B = b.halves();
    for (const auto& [i, j] : {std::pair(0U, 0U), std::pair(0U, 1U), std::pair(1U, 1U)})
        if (Found found = meet(A[i], B[j], straight, depth + 1))
            return found;
    return meet_again(A[1], B[0], straight, depth + 1);
}

/// Calls visit(i, j) for arcs whose extents in x overlap, i from the first list and j from the second,
/// until it returns a crossing.
template <class Visit>
Found sweep(const std::vector<Arc>& arcs, const std::vector<Arc>& others, const Visit& visit)
{
    const auto low_ends = [](const std::vector<Arc>& list) {
        std::vector<std::array<double, 2>> ranges;
        ranges.reserve(list.size());
        for (const Arc& arc : list)
            ranges.push_back(extent(arc, {1, 0}));
        return ranges;
    };
    const auto ranges = low_ends(arcs);
    const auto other_ranges = low_ends(others);
    std::vector<std::size_t> order(others.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return other_ranges[i][0] < other_ranges[j][0]; });
    double widest = 0;
    for (const auto& range : other_ranges)
        widest = std::max(widest, range[1] - range[0]);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        // Whatever starts before this ends before the arc begins.
        auto j = std::lower_bound(order.begin(), order.end(), ranges[i][0] - widest,
                                  [&](std::size_t k, double x) { return other_ranges[k][0] < x; });
        for (; j != order.end() && other_ranges[*j][0] <= ranges[i][1]; ++j)
            if (other_ranges[*j][1] >= ranges[i][0])
                if (Found found = visit(i, *j))
                    return found;
    }
    return {};
}

double size_of(const Curve& curve)
{
    const Points2& points = curve.definition().control_points;
    return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

CurveCrossing ordered(CurveCrossing crossing)
{
    if (crossing.u > crossing.v)
        std::swap(crossing.u, crossing.v);
    return crossing;
}

} // namespace

std::optional<CurveCrossing> find_self_crossing(const Curve& curve)
{
    const double size = size_of(curve);
    const double straight = kStraight * size;
    const std::vector<Arc> arcs = curve_arcs(curve, straight);
    if (arcs.empty())
        return {};
    const bool loop = (arcs.back().last() - arcs.front().first()).norm() <= kSamePlace * size;
    const Found found = sweep(arcs, arcs, [&](std::size_t i, std::size_t j) -> Found {
        if (j <= i)
            return {};
        if (loop && i == 0 && j + 1 == arcs.size())
            return meet_again(arcs[j], arcs[i], straight, 0);
        return j == i + 1 ? meet_again(arcs[i], arcs[j], straight, 0) : meet(arcs[i], arcs[j], straight, 0);
    });
    return found ? Found(ordered(*found)) : Found();
}

std::optional<CurveCrossing> find_crossing(const Curve& a, const Curve& b)
{
    const double size = std::max(size_of(a), size_of(b));
    const double straight = kStraight * size;
    const std::vector<Arc> first = curve_arcs(a, straight);
    const std::vector<Arc> second = curve_arcs(b, straight);
    const auto joined = [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q) {
        return !a.closed() && !b.closed() && (p - q).norm() <= kSamePlace * size;
    };
    return sweep(first, second, [&](std::size_t i, std::size_t j) -> Found {
        // An arc at an end of its curve, turned so that it leads up to that end.
        const auto leads_out = [&](const std::vector<Arc>& arcs, std::size_t k,
                                   bool at_start) -> std::optional<Arc> {
            if (k != (at_start ? 0 : arcs.size() - 1))
                return {};
            return at_start ? arcs[k].reversed() : arcs[k];
        };
        for (const bool start_a : {true, false})
            for (const bool start_b : {true, false}) {
                const auto out_a = leads_out(first, i, start_a);
                const auto out_b = leads_out(second, j, start_b);
                if (out_a && out_b && joined(out_a->last(), out_b->last()))
                    return meet_again(*out_a, out_b->reversed(), straight, 0);
            }
        return meet(first[i], second[j], straight, 0);
    });
}

} // namespace morph
