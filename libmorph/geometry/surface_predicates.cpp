#include "libmorph/geometry/surface_predicates.h"

#include "libmorph/core/predicates.h"

#include <CGAL/Exact_rational.h>

#include <array>
#include <cmath>
#include <limits>

namespace morph {

namespace {

using Exact = CGAL::Exact_rational;

template <class Number>
using Triple = std::array<Number, 3>;

template <class Number>
Triple<Number> difference(const Eigen::Vector3d& head, const Eigen::Vector3d& tail)
{
    return {Number(head.x()) - Number(tail.x()), Number(head.y()) - Number(tail.y()),
            Number(head.z()) - Number(tail.z())};
}

template <class Number>
Triple<Number> cross(const Triple<Number>& a, const Triple<Number>& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// As cross(), every term taken positive: the scale of its rounding errors.
Triple<double> absolute_cross(const Triple<double>& a, const Triple<double>& b)
{
    const auto term = [&](std::size_t i, std::size_t j) {
        return std::abs(a[i] * b[j]) + std::abs(a[j] * b[i]);
    };
    return {term(1, 2), term(2, 0), term(0, 1)};
}

template <class Number>
Number dot(const Triple<Number>& a, const Triple<Number>& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class Number>
struct QuadVectors {
    QuadVectors(const Eigen::Vector3d& corner, const Eigen::Vector3d& next_corner,
                const Eigen::Vector3d& opposite, const Eigen::Vector3d& previous_corner)
        : next(difference<Number>(next_corner, corner)),
          previous(difference<Number>(previous_corner, corner)),
          diagonal(difference<Number>(opposite, corner)),
          other_diagonal(difference<Number>(previous_corner, next_corner))
    {
    }

    Number jacobian() const { return dot(cross(next, previous), cross(diagonal, other_diagonal)); }

    Triple<Number> next, previous, diagonal, other_diagonal;
};

} // namespace

bool on_one_line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
{
    const auto flat = [&](int x, int y) {
        return orientation({a[x], a[y]}, {b[x], b[y]}, {c[x], c[y]}) == 0;
    };
    return flat(0, 1) && flat(1, 2) && flat(2, 0);
}

int quad_corner_sign(const Eigen::Vector3d& corner, const Eigen::Vector3d& next,
                     const Eigen::Vector3d& opposite, const Eigen::Vector3d& previous)
{
    // Every product in the Jacobian passes through 11 roundings at most.
    constexpr double kRelativeError = 16 * std::numeric_limits<double>::epsilon();
    constexpr double kUnderflow = 1e-290;
    const QuadVectors<double> quad(corner, next, opposite, previous);
    const double scale =
        dot(absolute_cross(quad.next, quad.previous), absolute_cross(quad.diagonal, quad.other_diagonal));
    const double jacobian = quad.jacobian();
    const double bound = kRelativeError * scale + kUnderflow;
    if (std::abs(jacobian) > bound)
        return jacobian > 0 ? 1 : -1;
    return static_cast<int>(CGAL::sign(QuadVectors<Exact>(corner, next, opposite, previous).jacobian()));
}

} // namespace morph
