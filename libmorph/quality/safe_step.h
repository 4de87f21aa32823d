#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph {

/// How much of a move leaves every element as it should be.
struct SafeStep {
    double step = 1;    ///< in [0, 1]
    Index element = -1; ///< file number of the one that allows no more; -1 when step is 1
};

/// The largest step up to which no element is inverted, the vertices going straight from @p before to
/// @p after: as they do under weights, where the move is linear in the control points.
///
/// Every corner Jacobian of every element, at positions (1 - t) before + t after without rounding, is
/// positive for all t from 0 to step, and some corner of the element is not at the double after step: decided
/// exactly, see stays_positive_until(). Of elements that allow equally much the one with the lowest number is
/// named. The step is 0 when an element is inverted before the move already. Equal for any thread count.
/// @param mesh          planar, n vertices
/// @param before,after  n x 3, length unit of the mesh, z is not looked at
/// @throws InputError  the mesh is a surface in space, or a matrix has another number of rows than n
SafeStep safe_step(const Mesh& mesh, const PositionsView& before, const PositionsView& after);

} // namespace morph
