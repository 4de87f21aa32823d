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
/// @param targets  n x 3; z = 0 for a planar source
/// @throws InputError  see Locator::locate(); the source has no element
TargetLocations locate_targets(const Locator& source, Points targets);

} // namespace morph
