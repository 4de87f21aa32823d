#include "libmorph/geometry/corner_motion.h"

#include <CGAL/Mpzf.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace morph {

namespace {

// Every coefficient below passes through 15 roundings at most, of half an epsilon each.
constexpr double kRelativeError = 8 * std::numeric_limits<double>::epsilon();

// Far above what products below the normal range can lose, which that bound leaves out.
constexpr double kUnderflow = 1e-290;

/// A sum of products with the sum of their absolute values, the scale of its rounding errors.
struct Rounded {
    double value = 0;
    double size = 0;

    double error() const { return kRelativeError * size + kUnderflow; }
    double least() const { return value - error(); }
    double most() const { return value + error(); }
};

Rounded operator+(Rounded a, Rounded b)
{
    return {a.value + b.value, a.size + b.size};
}

Rounded operator*(double factor, Rounded a)
{
    return {factor * a.value, factor * a.size};
}

template <class Number>
struct Edge {
    Number x, y;
};

template <class Number>
Edge<Number> edge(PlanePoint from, PlanePoint to)
{
    return {Number(to.x) - Number(from.x), Number(to.y) - Number(from.y)};
}

Rounded cross(const Edge<double>& a, const Edge<double>& b)
{
    const double left = a.x * b.y;
    const double right = a.y * b.x;
    return {left - right, std::abs(left) + std::abs(right)};
}

CGAL::Mpzf cross(const Edge<CGAL::Mpzf>& a, const Edge<CGAL::Mpzf>& b)
{
    return a.x * b.y - a.y * b.x;
}

/// The Jacobian as start (1 - t)^2 + middle t (1 - t) + end t^2.
template <class Number, class Coefficient>
struct Jacobian {
    explicit Jacobian(const MovingCorner& c)
    {
        const auto next_start = edge<Number>(c.corner.start, c.next.start);
        const auto next_end = edge<Number>(c.corner.end, c.next.end);
        const auto previous_start = edge<Number>(c.corner.start, c.previous.start);
        const auto previous_end = edge<Number>(c.corner.end, c.previous.end);
        start = cross(next_start, previous_start);
        middle = cross(next_start, previous_end) + cross(next_end, previous_start);
        end = cross(next_end, previous_end);
    }

    Coefficient start, middle, end;
};

using RoundedJacobian = Jacobian<double, Rounded>;
using ExactJacobian = Jacobian<CGAL::Mpzf, CGAL::Mpzf>;

enum class Answer { no, yes, unknown };

Answer rounded_answer(const RoundedJacobian& j, double time)
{
    const double rest = 1 - time;
    const Rounded last = rest * rest * j.start + time * rest * j.middle + time * time * j.end;
    if (j.start.most() < 0 || last.most() < 0)
        return Answer::no;
    if (!(j.start.least() > 0) || !(last.least() > 0))
        return Answer::unknown;
    const Rounded inner = 2 * rest * j.start + time * j.middle;
    if (inner.least() >= 0)
        return Answer::yes;
    constexpr double kRoundingFactor = 1 + kRelativeError;
    const double tip = std::abs(j.middle.value);
    if (j.end.least() > 0 &&
        std::pow(tip + j.middle.error(), 2) * kRoundingFactor < 4 * j.start.least() * j.end.least())
        return Answer::yes;
    const bool dips = inner.most() < 0 && tip > j.middle.error() && j.end.most() > 0;
    if (dips && std::pow(tip - j.middle.error(), 2) > 4 * j.start.most() * j.end.most() * kRoundingFactor)
        return Answer::no;
    return Answer::unknown;
}

bool exact_answer(const MovingCorner& corner, double time)
{
    using Exact = CGAL::Mpzf;
    const ExactJacobian j(corner);
    if (CGAL::sign(j.start) <= 0)
        return false;
    const Exact t(time);
    const Exact rest = Exact(1) - t;
    const Exact inner = Exact(2) * rest * j.start + t * j.middle;
    const Exact last = rest * (rest * j.start + t * j.middle) + t * t * j.end;
    if (CGAL::sign(last) <= 0)
        return false;
    return CGAL::sign(inner) >= 0 || CGAL::sign(Exact(4) * j.start * j.end - j.middle * j.middle) > 0;
}

bool is_finite(const MovingCorner& c)
{
    for (const MovingPoint& p : {c.corner, c.next, c.previous})
        for (const double coordinate : {p.start.x, p.start.y, p.end.x, p.end.y})
            if (!std::isfinite(coordinate))
                return false;
    return true;
}

} // namespace

bool stays_positive_until(const MovingCorner& corner, double time)
{
    const Answer answer = rounded_answer(RoundedJacobian(corner), time);
    if (answer != Answer::unknown)
        return answer == Answer::yes;
    return is_finite(corner) && exact_answer(corner, time);
}

double turning_time(const MovingCorner& corner)
{
    const RoundedJacobian j(corner);
    const double start = j.start.value, middle = j.middle.value, end = j.end.value;
    if (!(start > 0))
        return 0;
    const double discriminant = middle * middle - 4 * start * end;
    const double slope = 2 * start - middle;
    const double divisor = slope + std::sqrt(std::max(0.0, discriminant));
    const bool turns = discriminant >= 0 && divisor > 0;
    return turns ? std::min(1.0, 2 * start / divisor) : 1;
}

} // namespace morph
