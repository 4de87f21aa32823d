#pragma once

#include "libmorph/remap/clip.h"
#include "libmorph/remap/locate.h"

#include <functional>
#include <span>
#include <vector>

namespace morph {

/// What a part of a target element and a part of a source element have in common.
struct Overlap {
    Index source = 0;                 ///< face of the source
    const ElementPart* target_part{}; ///< of the target element
    ElementPart source_part;          ///< of the source element
    ConvexPolygon piece;              ///< relative to the origin of the target element, of positive area
};

/// A target element with all it has in common with the source, by ascending source face.
struct TargetOverlaps {
    Index target = 0;  ///< face of the target
    PlanePoint origin; ///< its first corner: coordinates of parts and pieces are relative to it, so that they
                       ///  have all their digits however far from 0 the mesh lies
    const ElementParts* parts{}; ///< of the target element
    std::span<const Overlap> overlaps;
};

/// Call visit once for each element of a planar target, in blocks on every core.
///
/// The source elements that touch a target element are found by a flood over the sides of the source that
/// touch it, from the source element that holds one of its corners. They cover the target element when no
/// side among them is on the boundary of the source: a point of it outside of them would be seen from a
/// point inside along a segment within the element (its parts are convex) that leaves them through a side
/// which touches it, but the flood has crossed all of those. Where the flood does meet the boundary, or no
/// corner lies in the source, holes, concave sides and other parts may hide more: there the elements whose
/// boxes meet come from the tree. Whether a side touches is decided exactly, so that rounding loses nothing.
///
/// O(number of overlaps), and O(log m) for target elements at the boundary. @p source must not overlap itself
/// for the flood to find all.
/// @throws InputError  source or target is a surface in space
void for_each_overlap(const Locator& source, const Mesh& target, Parts parts,
                      const std::function<void(const TargetOverlaps&)>& visit);

} // namespace morph
