#include "libmorph/remap/corner_weights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace morph {

namespace {

using CornerWeights = std::array<double, 4>;
using Eigen::Vector2d;

Vector2d vector(PlanePoint from, PlanePoint to)
{
    return {to.x - from.x, to.y - from.y};
}

double cross(const Vector2d& a, const Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// s and t with s a + t b = r by elimination with complete pivoting. Its residual is small even where a and b
/// are all but parallel, and that is what makes linear fields exact in slivers; Cramer's rule leaves a large
/// one. With a and b parallel, one of s and t is 0.
Vector2d solve(Vector2d a, Vector2d b, Vector2d r)
{
    const bool other_column = b.lpNorm<Eigen::Infinity>() > a.lpNorm<Eigen::Infinity>();
    if (other_column)
        std::swap(a, b);
    if (std::abs(a.y()) > std::abs(a.x()))
        for (Vector2d* v : {&a, &b, &r})
            std::swap(v->x(), v->y());
    if (a.x() == 0)
        return Vector2d::Zero();
    const double factor = a.y() / a.x();
    const double pivot = b.y() - factor * b.x();
    const double t = pivot == 0 ? 0 : (r.y() - factor * r.x()) / pivot;
    const double s = (r.x() - b.x() * t) / a.x();
    return other_column ? Vector2d(t, s) : Vector2d(s, t);
}

CornerWeights triangle_weights(const PlaneElement& element, const std::array<int, 3>& triangle, PlanePoint p)
{
    const auto at = [&](std::size_t k) { return element.corner[static_cast<std::size_t>(triangle[k])]; };
    const std::array<double, 3> coordinates = barycentric(at(0), at(1), at(2), p);
    CornerWeights weights{};
    for (std::size_t k = 0; k < 3; ++k)
        weights[static_cast<std::size_t>(triangle[k])] = coordinates[k];
    return weights;
}

CornerWeights split_weights(const PlaneElement& quad, Diagonal diagonal, PlanePoint p)
{
    const auto triangle = halves(diagonal);
    const auto at = [&](std::size_t k) { return quad.corner[static_cast<std::size_t>(triangle[0][k])]; };
    return triangle_weights(quad, triangle[triangle_contains(at(0), at(1), at(2), p) ? 0 : 1], p);
}

/// The bilinear map of a quad from (u, v) in the unit square: a + u e + v f + u v g.
struct BilinearMap {
    PlanePoint a;
    Vector2d e, f, g;

    explicit BilinearMap(const PlaneElement& quad)
        : a(quad.corner[0]), e(vector(a, quad.corner[1])), f(vector(a, quad.corner[3])),
          g(vector(quad.corner[1], quad.corner[2]) - f)
    {
    }

    Vector2d residual(const Vector2d& h, const Vector2d& uv) const
    {
        return h - uv.x() * e - uv.y() * (f + uv.x() * g);
    }

    /// Root of the quadratic for v that lies in [0, 1], up to rounding, and the u that goes with it.
    Vector2d closed_form(const Vector2d& h) const
    {
        const double a2 = cross(g, f);
        const double a1 = cross(e, f) + cross(h, g);
        const double a0 = cross(h, e);
        const double root = std::sqrt(std::max(a1 * a1 - 4 * a2 * a0, 0.0));
        const double q = -0.5 * (a1 + std::copysign(root, a1));
        double v = q == 0 ? 0.5 : a0 / q;
        if (const double other = a2 == 0 ? v : q / a2; std::abs(other - 0.5) < std::abs(v - 0.5))
            v = other;
        const Vector2d along = e + v * g;
        const double length2 = along.squaredNorm();
        return {length2 == 0 ? 0.5 : (h - v * f).dot(along) / length2, v};
    }

    Vector2d newton_step(const Vector2d& h, const Vector2d& uv) const
    {
        return uv + solve(e + uv.y() * g, f + uv.x() * g, residual(h, uv));
    }
};

CornerWeights bilinear_weights(const PlaneElement& quad, PlanePoint p)
{
    const BilinearMap map(quad);
    const Vector2d h = vector(map.a, p);
    Vector2d uv = map.closed_form(h);
    constexpr int kMostSteps = 4; // the closed form is there up to cancellation; Newton's steps repair that
    double error = map.residual(h, uv).norm();
    for (int i = 0; i < kMostSteps; ++i) {
        const Vector2d next = map.newton_step(h, uv);
        const double next_error = map.residual(h, next).norm();
        if (!(next_error < error))
            break;
        uv = next;
        error = next_error;
    }
    const double u = uv.x(), v = uv.y();
    return {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
}

} // namespace

std::array<double, 3> barycentric(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint p)
{
    const Vector2d w = solve(vector(a, b), vector(a, c), vector(a, p));
    return {1 - w.x() - w.y(), w.x(), w.y()};
}

CornerWeights corner_weights(const PlaneElement& element, PlanePoint p, QuadRule rule)
{
    for (std::size_t k = 0; k < static_cast<std::size_t>(element.corners); ++k)
        if (element.corner[k].x == p.x && element.corner[k].y == p.y) {
            CornerWeights weights{};
            weights[k] = 1;
            return weights;
        }
    if (element.corners == 3)
        return triangle_weights(element, {0, 1, 2}, p);
    if (!is_convex(element))
        return split_weights(element, inner_diagonal(element), p);
    return rule == QuadRule::split ? split_weights(element, Diagonal::first_third, p)
                                   : bilinear_weights(element, p);
}

CornerWeights corner_weights(const std::array<Eigen::Vector3d, 4>& corner, int corners,
                             const Eigen::Vector3d& p, QuadRule rule)
{
    const Eigen::Vector3d normal = corners == 3 ? (corner[1] - corner[0]).cross(corner[2] - corner[0])
                                                : (corner[2] - corner[0]).cross(corner[3] - corner[1]);
    int axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const auto seen = [axis](const Eigen::Vector3d& q) {
        return PlanePoint{q[(axis + 1) % 3], q[(axis + 2) % 3]};
    };
    PlaneElement element{{}, corners};
    for (std::size_t k = 0; k < static_cast<std::size_t>(corners); ++k)
        element.corner[k] = seen(corner[k]);
    return corner_weights(element, seen(p), rule);
}

} // namespace morph
