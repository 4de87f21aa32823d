#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace morph {

/// Two edges that meet where they should not.
struct EdgeCrossing {
    std::array<Index, 2> edges{}; ///< numbers in the list given, ascending
    Eigen::Vector2d point;        ///< where, to rounding
};

/// Two edges in the plane that cross, touch or overlap anywhere but at a vertex they share, if there are any: of all
/// such pairs the one whose numbers are lowest. Decided exactly. Edges with the same two vertices are one
/// edge.
///
/// CGAL's box intersection finds the pairs that can meet: O(m log m) and their number.
///
/// @param points  n x 3, z is not looked at
/// @param edges   pairs of rows of @p points
std::optional<EdgeCrossing> find_edge_crossing(const Eigen::Ref<const Points>& points,
                                               const std::vector<std::array<Index, 2>>& edges);

} // namespace morph
