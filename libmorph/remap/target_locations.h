#pragma once

#include "libmorph/remap/locate.h"

#include <vector>

namespace morph {

/// Where n targets lie on a source mesh, and those outside how far from it.
struct TargetLocations {
    Points points;                                  ///< the targets, n x 3
    ContainingElements elements;                    ///< of the targets inside
    std::vector<Index> outside;                     ///< the other targets, ascending
    std::vector<ElementTree::Closest> outside_feet; ///< for each of them the closest point of the source
    Points feet;                  ///< surfaces only: the closest points of all targets, n x 3
    std::vector<double> distance; ///< surfaces only: of all targets to them, n
};

/// Find where targets lie on a source.
///
/// Planar source: a target is inside when some element holds it, exactly (see Locator). Surface: every target
/// belongs to the closest point of the surface; it is outside when that point lies on the rim of an open
/// surface, farther than 1e-9 of the surface's size away. O(log m) for each target of a surface and each
/// target outside.
/// @param source   finds elements of the source mesh
/// @param targets  n x 3; z = 0 for a planar source
/// @throws InputError  see Locator::locate(); the source has no element
TargetLocations locate_targets(const Locator& source, Points targets);

/// How many of some targets lie outside the source, and how far.
struct TargetCounts {
    std::size_t targets = 0;
    std::size_t outside = 0;
    Index farthest = -1;      ///< file number of the target farthest from the source; -1: none is outside
    Eigen::RowVector3d where; ///< it lies here
    double distance = 0;      ///< so far from the source, length unit of the mesh
};

/// Count the targets outside and find the farthest of them; of equally far ones that with the lowest number.
/// @param locations     from locate_targets()
/// @param file_numbers  n: of the targets
TargetCounts count_targets(const TargetLocations& locations, const std::vector<Index>& file_numbers);

/// n x 1: 0 for a target inside, 1 for one outside.
Matrix target_status(const TargetLocations& locations);

/// n x 1: the distance of each target from the source; 0 inside a planar source.
Matrix target_distances(const TargetLocations& locations);

} // namespace morph
