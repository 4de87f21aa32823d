#pragma once

#include "libmorph/basis/curve.h"
#include "libmorph/deform/boundary_move.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// A marker whose nodes may slide along it.
struct SlidingMarker {
    std::string name;
    std::optional<Curve>
        curve; ///< what they slide along; without it the marker itself, straight or a polygon
};

/// The same move with nodes of some markers sliding along them instead of being held: a symmetry line, a
/// channel's wall. They go where the move takes them when they are free, brought back to the nearest place of
/// the line or curve. Ends of a marker, and nodes that another marker shares, do as that one does, or stay.
///
/// Where nodes would pass each other, or come nearer to each other than a tenth of their distance, all of
/// that marker slide by less, in proportion.
///
/// The move is computed twice, once to find where the nodes go.
///
/// @throws InputError  from the move: no such marker, it branches, a sliding node is moved as well
BoundaryMove with_sliding(BoundaryMove move, std::vector<SlidingMarker> markers);

} // namespace morph
