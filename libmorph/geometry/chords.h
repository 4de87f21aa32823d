#pragma once

#include "libmorph/geometry/outline.h"

#include <utility>
#include <vector>

namespace morph {

/// The straight piece from one node of a loop to the next.
struct Chord {
    std::size_t loop = 0;
    std::size_t node = 0; ///< it starts at this node of the loop
    std::size_t loop_nodes = 0;
    Eigen::Vector2d a, b;
    double sagitta = 0; ///< largest distance of the curve from the chord, sampled
};

/// The largest sagitta of a chord that may stand for its curve, as a part of its length: the node halfway
/// then lies well inside the circle over the chord, as refinement needs it.
inline constexpr double kLargestSag = 0.35;

/// All chords of all loops, in order.
std::vector<Chord> chords_of(const std::vector<OutlineLoop>& loops);

/// Pairs of chords, the smaller number first, in order, that come within the sum of their sags (with a
/// margin) or @p touching of each other, although they share no node.
std::vector<std::pair<std::size_t, std::size_t>> meeting_chords(const std::vector<Chord>& chords,
                                                                double touching);

/// The curve cannot be distinguished from the chord any more: splitting it further decides nothing.
bool is_flat(const Chord& chord, double touching);

} // namespace morph
