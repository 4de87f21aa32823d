#pragma once

#include "libmorph/pipeline/move_result.h"
#include "libmorph/pipeline/settings.h"

namespace morph {

/// Look for crossing boundaries and inverted elements in a moved mesh, and repair what the guard says.
/// @param mesh                before the move
/// @param curve_displacements  of placed.boundaries, K x 2
/// @param result              its positions are those after the move; repaired in place
void check_and_repair(const Mesh& mesh, const PlacedBoundaries& placed, const Matrix& curve_displacements,
                      Guard guard, MoveResult& result);

} // namespace morph
