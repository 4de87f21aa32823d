#pragma once

#include <Eigen/Core>

#include <array>

namespace morph {

/// A point of a triangle.
struct TrianglePoint {
    Eigen::Vector3d point;
    double distance2 = 0; ///< squared, length unit squared
    int feature = 0; ///< 0: inside · 1 to 3: on the side from that corner to the next · -1 to -3: that corner
};

/// The point of a triangle in space closest to @p p; a triangle without area is its sides.
TrianglePoint closest_on_triangle(const std::array<Eigen::Vector3d, 3>& corner, const Eigen::Vector3d& p);

} // namespace morph
