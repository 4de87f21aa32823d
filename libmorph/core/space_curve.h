#pragma once

#include "libmorph/core/types.h"

#include <vector>

namespace morph {

/// Order of points along a Hilbert curve through their bounding box, so that points near each other
/// in space come near each other in memory.
///
/// Points that fall into the same cell of the curve's grid (2^31 cells a side in the plane, 2^21 in
/// space) keep their order.
///
/// @param points     n x 3, finite
/// @param dimension  2: x and y are used · 3: x, y and z
/// @return n point numbers, first on the curve first
std::vector<Index> hilbert_order(const Eigen::Ref<const Points>& points, int dimension);

} // namespace morph
