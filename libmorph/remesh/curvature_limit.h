#pragma once

#include "libmorph/remesh/remesh_state.h"

namespace morph {

/// A halfedge is on a feature curve and stands for its edge.
bool on_curve(const CornerTable& net, Index h);

/// Smallest radius of curvature of the feature curve along a halfedge of the net that is on one.
double least_radius(const RemeshState& made, Index h);

/// Lower the sizes wanted where edges on smooth feature curves would turn by more than 30 degrees, unless
/// those of the input do, and around these places so that sizes grow from there by no more than a factor
/// of 1.2. A hole stays round that way however long the edges wanted are.
///
/// @param made  not remade yet, with its features found; sizes of its net and its underlay are lowered
void limit_by_curves(RemeshState& made);

} // namespace morph
