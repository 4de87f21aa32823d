#include "libmorph/geometry/closest_on_triangle.h"

#include <Eigen/Geometry>

#include <cmath>

namespace morph {

namespace {

TrianglePoint closest_on_side(const std::array<Eigen::Vector3d, 3>& corner, std::size_t k,
                              const Eigen::Vector3d& p)
{
    const std::size_t next = (k + 1) % 3;
    const Eigen::Vector3d side = corner[next] - corner[k];
    const double along = side.dot(p - corner[k]);
    const double length2 = side.squaredNorm();
    TrianglePoint found;
    if (!(along > 0)) {
        found.point = corner[k];
        found.feature = -static_cast<int>(k) - 1;
    } else if (along >= length2) {
        found.point = corner[next];
        found.feature = -static_cast<int>(next) - 1;
    } else {
        found.point = corner[k] + along / length2 * side;
        found.feature = static_cast<int>(k) + 1;
    }
    found.distance2 = (p - found.point).squaredNorm();
    return found;
}

} // namespace

TrianglePoint closest_on_triangle(const std::array<Eigen::Vector3d, 3>& corner, const Eigen::Vector3d& p)
{
    const Eigen::Vector3d normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    const auto left_of = [&](std::size_t k) {
        return normal.dot((corner[(k + 1) % 3] - corner[k]).cross(p - corner[k])) > 0;
    };
    if (left_of(0) && left_of(1) && left_of(2)) {
        const double height = normal.dot(p - corner[0]) / normal.squaredNorm();
        return {p - height * normal, height * height * normal.squaredNorm(), 0};
    }
    TrianglePoint best = closest_on_side(corner, 0, p);
    for (std::size_t k = 1; k < 3; ++k)
        if (const TrianglePoint other = closest_on_side(corner, k, p); other.distance2 < best.distance2)
            best = other;
    return best;
}

} // namespace morph
