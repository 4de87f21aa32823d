#pragma once

#include "libmorph/core/types.h"

#include <vector>

namespace morph {

/// A length that depends on a few points only, with its derivatives by their coordinates.
struct LocalMeasure {
    double value = 0;          ///< NaN where the length does not exist
    std::vector<Index> points; ///< p, rows of the points given
    Eigen::VectorXd gradient;  ///< p c, first the c coordinates of points[0], then those of points[1], ...
    Eigen::MatrixXd hessian;   ///< p c x p c, in the same order
};

/// Extent of a closed polygon along a line: from the first to the last point where its sides cross the line.
///
/// The value is that of the polygon. It has a kink wherever an end point passes over a node, and the nearest
/// point that satisfies a bound would often lie in one, where no gradient exists. So the derivatives are
/// those of a smooth shape through the nodes, whose slope runs linearly from node to node: gradients off by
/// the square of the sides' length and the Hessian by the length itself, the gradient without jumps. The side
/// of a node that lies on the line counts once. NaN when the line does not cross.
///
/// @param polygon  m x 3, in order, the last node joined to the first; z is not looked at
/// @param at       a point of the line
/// @param along    its direction, of length 1
LocalMeasure extent_along(const Points& polygon, const Eigen::Vector2d& at, const Eigen::Vector2d& along);

/// Distance of two points; its gradient is 0 where they coincide.
/// @param ends        2 x 3
/// @param components  c, 2 or 3: how many coordinates count
LocalMeasure distance_between(const Points& ends, Eigen::Index components);

} // namespace morph
