#include "libmorph/quality/metrics.h"

#include "libmorph/core/predicates.h"
#include "libmorph/geometry/surface_predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace morph {

namespace {

constexpr double kLargestNumber = std::numeric_limits<double>::max();

/// A value whose sign was decided exactly, with the size that floating point gives it (tiny if it gives
/// none).
double with_sign(double value, int sign)
{
    return sign == 0 ? 0 : sign * std::max(std::numeric_limits<double>::min(), std::abs(value));
}

/// value / scale, 0 where the scale is zero or the element too large or small for doubles.
double ratio(double value, double scale)
{
    const double quotient = scale > 0 ? value / scale : 0;
    return std::isfinite(quotient) ? quotient : 0;
}

PlanePoint plane_point(const Eigen::Vector2d& p)
{
    return {p.x(), p.y()};
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

std::size_t next_corner(std::size_t k, std::size_t corners)
{
    return k + 1 == corners ? 0 : k + 1;
}

std::size_t previous_corner(std::size_t k, std::size_t corners)
{
    return k == 0 ? corners - 1 : k - 1;
}

/// Lengths and scalar products of the edges, in the plane or in space.
template <class Vector>
ElementShape edge_shape(const std::array<Vector, 4>& p, std::size_t corners)
{
    std::array<Vector, 4> edge;
    ElementShape shape;
    shape.corners = static_cast<int>(corners);
    for (std::size_t k = 0; k < corners; ++k) {
        edge[k] = p[next_corner(k, corners)] - p[k];
        shape.length[k] = edge[k].norm();
    }
    for (std::size_t k = 0; k < corners; ++k)
        shape.dot[k] = -edge[k].dot(edge[previous_corner(k, corners)]);
    return shape;
}

double edge_product(const ElementShape& shape, std::size_t k)
{
    return shape.length[k] * shape.length[previous_corner(k, static_cast<std::size_t>(shape.corners))];
}

} // namespace

ElementShape planar_shape(const CornerPoints& points, int corners)
{
    const auto n = static_cast<std::size_t>(corners);
    std::array<Eigen::Vector2d, 4> p;
    for (std::size_t k = 0; k < n; ++k)
        p[k] = points[k].head<2>();
    ElementShape shape = edge_shape(p, n);
    if (n == 3) {
        // All three corners of a triangle have the same Jacobian, twice the area.
        const double jacobian =
            with_sign(cross(p[1] - p[0], p[2] - p[0]),
                      orientation(plane_point(p[0]), plane_point(p[1]), plane_point(p[2])));
        shape.jacobian = {jacobian, jacobian, jacobian, 0};
        shape.area = jacobian / 2;
        return shape;
    }
    for (std::size_t k = 0; k < n; ++k) {
        const Eigen::Vector2d& next = p[next_corner(k, n)];
        const Eigen::Vector2d& previous = p[previous_corner(k, n)];
        const int sign = orientation(plane_point(p[k]), plane_point(next), plane_point(previous));
        shape.jacobian[k] = with_sign(cross(next - p[k], previous - p[k]), sign);
    }
    const int side = cross_sign(plane_point(p[0]), plane_point(p[2]), plane_point(p[1]), plane_point(p[3]));
    shape.area = with_sign(cross(p[2] - p[0], p[3] - p[1]), side) / 2;
    return shape;
}

ElementShape surface_shape(const CornerPoints& p, int corners)
{
    const auto n = static_cast<std::size_t>(corners);
    ElementShape shape = edge_shape(p, n);
    if (n == 3) {
        const double size = (p[1] - p[0]).cross(p[2] - p[0]).norm();
        const double jacobian = with_sign(size, on_one_line(p[0], p[1], p[2]) ? 0 : 1);
        shape.jacobian = {jacobian, jacobian, jacobian, 0};
        shape.area = jacobian / 2;
        return shape;
    }
    const Eigen::Vector3d normal = (p[2] - p[0]).cross(p[3] - p[1]);
    shape.area = normal.norm() / 2;
    for (std::size_t k = 0; k < n; ++k) {
        const Eigen::Vector3d& next = p[next_corner(k, n)];
        const Eigen::Vector3d& previous = p[previous_corner(k, n)];
        const double along = (next - p[k]).cross(previous - p[k]).dot(normal.stableNormalized());
        shape.jacobian[k] = with_sign(along, quad_corner_sign(p[k], next, p[(k + 2) % n], previous));
    }
    return shape;
}

double min_jacobian(const ElementShape& shape)
{
    return *std::min_element(shape.jacobian.begin(), shape.jacobian.begin() + shape.corners);
}

bool is_inverted(const ElementShape& shape)
{
    return min_jacobian(shape) <= 0;
}

double scaled_jacobian(const ElementShape& shape)
{
    if (shape.corners == 3) {
        const double longest =
            std::max({edge_product(shape, 0), edge_product(shape, 1), edge_product(shape, 2)});
        return std::clamp(2 / std::numbers::sqrt3 * ratio(shape.jacobian[0], longest), -1.0, 1.0);
    }
    double smallest = 1;
    for (std::size_t k = 0; k < 4; ++k)
        smallest = std::min(smallest, ratio(shape.jacobian[k], edge_product(shape, k)));
    return std::max(smallest, -1.0);
}

AngleRange angle_range(const ElementShape& shape)
{
    const double side = shape.area < 0 ? -1 : 1;
    AngleRange range{360, 0};
    for (std::size_t k = 0; k < static_cast<std::size_t>(shape.corners); ++k) {
        double angle = std::atan2(side * shape.jacobian[k], shape.dot[k]) * (180 / std::numbers::pi);
        if (angle < 0)
            angle += 360;
        if (std::isnan(angle)) // edges whose squares overflow
            angle = 0;
        range.min = std::min(range.min, angle);
        range.max = std::max(range.max, angle);
    }
    return range;
}

double aspect_ratio(const ElementShape& shape)
{
    double perimeter = 0;
    double longest = 0;
    for (const double length : shape.length) {
        perimeter += length;
        longest = std::max(longest, length);
    }
    const double ideal = shape.corners == 3 ? 4 * std::numbers::sqrt3 : 4;
    const double area = std::abs(shape.area);
    const double aspect = area > 0 ? longest * perimeter / (ideal * area) : kLargestNumber;
    return std::isfinite(aspect) ? aspect : kLargestNumber;
}

double skew(const ElementShape& shape)
{
    if (is_inverted(shape))
        return 0;
    double sum = 0;
    if (shape.corners == 3) {
        for (const double length : shape.length)
            sum += length * length;
        return std::min(1.0, ratio(4 * std::numbers::sqrt3 * shape.area, sum));
    }
    for (std::size_t k = 0; k < 4; ++k)
        sum += edge_product(shape, k) / shape.jacobian[k];
    return std::min(1.0, ratio(4, sum));
}

double size_skew(const ElementShape& shape, double reference_area)
{
    const double larger = std::max(shape.area, reference_area);
    const double smaller = std::min(shape.area, reference_area);
    return std::sqrt(std::max(0.0, ratio(smaller, larger))) * skew(shape);
}

} // namespace morph
