#pragma once

#include "libmorph/remesh/remesh_state.h"

namespace morph {

/// A halfedge is on a feature curve and stands for its edge.
bool on_curve(const CornerTable& table, Index h);

/// Smallest radius of curvature of the feature curve along a halfedge of the corner table that is on one.
double least_radius(const RemeshState& state, Index h);

/// Lower the target sizes where edges on smooth feature curves would turn by more than 30 degrees, unless
/// those of the input do, and around these places so that sizes grow from there by no more than a factor
/// of 1.2. A hole stays round that way however large the target sizes are.
///
/// @param state  not remeshed yet, with its features found; lowers sizes of its table and background mesh
void limit_by_curves(RemeshState& state);

} // namespace morph
