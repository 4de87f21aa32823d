#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace morph {

/// 1 for a simple polygon that runs counter-clockwise, -1 for one that runs clockwise. Decided exactly.
///
/// @param points  n x 3, z is not looked at
/// @param loop    rows of @p points, at least 3
int loop_orientation(const Eigen::Ref<const Points>& points, const std::vector<Index>& loop);

/// The first of some polygons that has not got plane on its left that belongs to the domain they bound: a
/// hole that is turned inside out, lies in another one or outside of everything. Decided exactly.
///
/// The boundary of a domain winds once around each of its points and not at all around any other. Elements
/// that are all positive cover a point as often as their boundary winds around it, so that without such a
/// polygon none of them overlap, and with one they must or are not all positive. O(polygons x vertices).
///
/// @param points  n x 3, z is not looked at
/// @param loops   simple polygons that meet in single vertices at most, the domain on the left
/// @return its number, or nothing where all polygons are in place
std::optional<std::size_t> find_misplaced_loop(const Eigen::Ref<const Points>& points,
                                               const std::vector<std::vector<Index>>& loops);

} // namespace morph
