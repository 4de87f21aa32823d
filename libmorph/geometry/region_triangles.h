#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace morph {

/// A part of the plane bounded by polygons, by rows of a table of points.
struct PolygonRegion {
    std::vector<std::array<Index, 2>> outline; ///< directed edges, the region on their left
    std::vector<std::array<Index, 2>> inner;   ///< edges inside it that triangles must not cross
    std::vector<Index> vertices;               ///< further points, used where they lie strictly inside
};

/// The constrained Delaunay triangulation of a region (CGAL): counter-clockwise triangles, decided exactly.
///
/// Inside is where the outline winds around once, so that it may have holes.
///
/// @param points  n x 3, z is not looked at
/// @param region  its edges meet in common vertices only (see find_edge_crossing())
/// @return none where the outline bounds no region on its left: it winds around some place other than once
///         or not at all, or an inner edge lies outside
std::optional<std::vector<std::array<Index, 3>>> region_triangles(const Eigen::Ref<const Points>& points,
                                                                  const PolygonRegion& region);

} // namespace morph
