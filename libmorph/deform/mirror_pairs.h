#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <vector>

namespace morph {

/// Pairs of control points that mirror each other in a line of the plane, or a plane in space: each point
/// with its image, or with itself on the mirror.
///
/// @param control_points  K x 2 or K x 3
/// @param at              a point of the mirror
/// @param normal          of the mirror, of any length but 0; z = 0 in the plane
/// @return rows of @p control_points, the smaller first, in their order
/// @throws InputError     a point has no image of its own within 1e-6 of the size of the whole; or the normal
///                        has no direction
std::vector<std::array<Index, 2>> mirror_pairs(const Matrix& control_points, const Eigen::Vector3d& at,
                                               const Eigen::Vector3d& normal);

} // namespace morph
