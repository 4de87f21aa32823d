#pragma once

#include "libmorph/remesh/remesh_state.h"

namespace morph {

/// Halve edges longer than @p longest times the target length, feature edges on their curves: those that
/// there are, each once, and not what splitting makes.
/// @return how many
std::size_t split_long_edges(RemeshState& state, double longest);

/// Take out edges shorter than kShortEdge times the target length, where that makes neither a long edge nor a
/// bad triangle. Vertices on feature curves go along these only, fixed ones stay.
/// @return how many
std::size_t collapse_short_edges(RemeshState& state);

/// Collapse an edge onto its end @p keep, if the triangles that change are then at least of this quality or
/// better than before, and their edges not longer than that times the target length.
bool try_collapse(RemeshState& state, Index h, Index keep, double least_quality, double longest = kLongEdge);

/// Put a vertex in the middle of an edge, if the triangles next to it may be cut so.
/// @return its number, -1 if not
Index try_split(RemeshState& state, Index h);

/// Flip edges to the shorter sum of opposite angles [Lawson 1977] (in the plane exact), but no feature edge
/// and on a surface no crease.
/// @return how many
std::size_t flip_edges(RemeshState& state);

} // namespace morph
