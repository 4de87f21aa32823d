#pragma once

#include "libmorph/remap/convex_parts.h"
#include "libmorph/remap/locate.h"

#include <functional>
#include <span>
#include <vector>

namespace morph {

/// What a convex piece of the target and one of the source have in common.
struct Overlap {
    Index face = -1;      ///< element of the source
    ConvexPart source;    ///< the piece of it
    ConvexPolygon common; ///< corners relative to @c origin
    PlanePoint origin;
    double area = 0; ///< of @c common, positive
};

/// A convex piece of the target with all that covers it.
struct SupermeshCell {
    Index face = -1;                 ///< element of the target
    Index number = -1;               ///< of the piece, counted through the whole target
    ConvexPart piece;                ///< of it
    std::span<const Overlap> covers; ///< at most one for each piece of the source
    double area = 0;                 ///< sum over @c covers
};

/// Finds what of a planar source covers each element of a planar target.
///
/// From the source element that holds the centre of a target piece T, a flood goes across every side that
/// clipping leaves a bit of inside T. T is convex, and so is T with a margin of rounding taken off: any two
/// source elements that reach into it are joined by a path inside it that avoids all vertices, and clipping
/// in floating point leaves a bit of each side that the path crosses. Only where the boundary of the source
/// runs through T may the path not exist (holes, concave sides, separate parts). So the areas prove the
/// answer: when what was found adds up to the area of T, nothing is missing. When it does not, or no element
/// holds the centre, the ElementTree lists all elements that T's box meets. Costs O(1) for each pair of
/// overlapping elements, plus O(log m) for each target piece that the source does not cover entirely.
///
/// Elements count with positive area whichever way round they run. Where elements of a tangled source overlap
/// each other, all of those are found as far as the flood reaches them; where it has covered T exactly once,
/// others may stay unseen.
class Supermesh {
public:
    /// @param source,target  outlive this and are not moved while it lives
    /// @throws InputError  either lies in space, the source has no element
    Supermesh(const Locator& source, const Mesh& target, Cut cut);

    /// Visit each piece of the target elements begin to end, in their order; those that nothing of the
    /// source covers with more than rounding too, with no covers. May run in several threads at once.
    void visit(std::size_t begin, std::size_t end,
               const std::function<void(const SupermeshCell&)>& visitor) const;

    /// m + 1: the number of the first piece of each element, and of all in the end.
    const std::vector<Index>& first_piece() const { return first_piece_; }

private:
    const Locator& source_;
    const Mesh& target_;
    Cut cut_;
    std::vector<Index> first_piece_;
    std::vector<Index> start_; ///< of each piece: the element of the source that holds its centre, or -1
};

} // namespace morph
