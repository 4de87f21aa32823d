#include "libmorph/remesh/feature_curve.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace morph {

namespace {

/// Derivative at the middle one of three points, of the parabola through them.
Eigen::Vector3d middle_slope(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                             double before, double after)
{
    return ((b - a) / before * after + (c - b) / after * before) / (before + after);
}

/// Of a line that turns from one direction to another over a length.
double radius_of_turn(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double length)
{
    const double turn = std::atan2(from.cross(to).norm(), from.dot(to));
    return turn > 0 ? length / turn : std::numeric_limits<double>::infinity();
}

} // namespace

FeatureCurve::FeatureCurve(const std::vector<Eigen::Vector3d>& nodes, bool closed, Shape shape)
    : nodes_(nodes), closed_(closed)
{
    if (closed)
        nodes_.push_back(nodes.front());
    u_.push_back(0);
    for (std::size_t i = 1; i < nodes_.size(); ++i)
        u_.push_back(u_.back() + (nodes_[i] - nodes_[i - 1]).norm());
    const std::size_t last = nodes_.size() - 1;
    if (shape == Shape::straight || last < 2)
        return;
    const auto step = [&](std::size_t i) { return u_[i + 1] - u_[i]; };
    slopes_.resize(nodes_.size());
    for (std::size_t i = 1; i < last; ++i)
        slopes_[i] = middle_slope(nodes_[i - 1], nodes_[i], nodes_[i + 1], step(i - 1), step(i));
    if (closed) {
        slopes_[0] = middle_slope(nodes_[last - 1], nodes_[0], nodes_[1], step(last - 1), step(0));
        slopes_[last] = slopes_[0];
    } else { // the parabola of the three nodes at the end
        slopes_[0] = 2 * (nodes_[1] - nodes_[0]) / step(0) - slopes_[1];
        slopes_[last] = 2 * (nodes_[last] - nodes_[last - 1]) / step(last - 1) - slopes_[last - 1];
    }
}

FeatureCurve::FeatureCurve(Curve curve, double begin, double end, bool closed)
    : spline_(std::move(curve)), u_{begin, end}, closed_(closed)
{
}

double FeatureCurve::inside(double u) const
{
    if (!closed_)
        return std::clamp(u, begin(), end());
    const double turns = std::floor((u - begin()) / period());
    return std::clamp(u - turns * period(), begin(), end());
}

std::size_t FeatureCurve::piece(double u) const
{
    const auto above = std::upper_bound(u_.begin() + 1, u_.end() - 1, u);
    return static_cast<std::size_t>(above - u_.begin()) - 1;
}

Eigen::Vector3d FeatureCurve::point(double u) const
{
    u = inside(u);
    if (spline_) {
        const Eigen::Vector2d p = spline_->point(u);
        return {p.x(), p.y(), 0};
    }
    const std::size_t i = piece(u);
    const double h = u_[i + 1] - u_[i], t = (u - u_[i]) / h;
    if (slopes_.empty())
        return (1 - t) * nodes_[i] + t * nodes_[i + 1];
    // As a change of the straight piece, which it is exactly where the slopes are along it.
    const Eigen::Vector3d rise = nodes_[i + 1] - nodes_[i];
    return nodes_[i] + t * rise +
           t * (1 - t) * ((1 - t) * (h * slopes_[i] - rise) + t * (rise - h * slopes_[i + 1]));
}

Eigen::Vector3d FeatureCurve::tangent(double u) const
{
    u = inside(u);
    if (spline_) {
        const Eigen::Vector2d d = spline_->derivatives(u, 1)[1];
        return {d.x(), d.y(), 0};
    }
    const std::size_t i = piece(u);
    const double h = u_[i + 1] - u_[i], t = (u - u_[i]) / h;
    const Eigen::Vector3d rise = nodes_[i + 1] - nodes_[i];
    if (slopes_.empty())
        return rise / h;
    const Eigen::Vector3d a = h * slopes_[i] - rise, b = rise - h * slopes_[i + 1];
    return (rise + (1 - 4 * t + 3 * t * t) * a + (2 * t - 3 * t * t) * b) / h;
}

double FeatureCurve::radius(double u) const
{
    return spline_ ? spline_radius(u) : polygon_radius(piece(inside(u)));
}

double FeatureCurve::spline_radius(double u) const
{
    const auto d = spline_->derivatives(inside(u), 2);
    const double speed = d[1].norm(), turn = std::abs(d[1].x() * d[2].y() - d[1].y() * d[2].x());
    return turn > 0 ? speed * speed * speed / turn : std::numeric_limits<double>::infinity();
}

double FeatureCurve::polygon_radius(std::size_t i) const
{
    const std::size_t pieces = nodes_.size() - 1;
    if (pieces < 2)
        return std::numeric_limits<double>::infinity();
    const std::size_t before = i > 0 ? i - 1 : (closed_ ? pieces - 1 : i);
    const std::size_t after = i + 1 < pieces ? i + 1 : (closed_ ? 0 : i);
    const auto step = [&](std::size_t k) { return u_[k + 1] - u_[k]; };
    const double length =
        (before == i ? 0 : (step(before) + step(i)) / 2) + (after == i ? 0 : (step(after) + step(i)) / 2);
    return radius_of_turn(nodes_[before + 1] - nodes_[before], nodes_[after + 1] - nodes_[after], length);
}

} // namespace morph
