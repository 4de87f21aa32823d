#pragma once

#include "libmorph/deform/boundary_move.h"

namespace morph {

/// As many steps as it takes.
inline constexpr int kAutoSteps = 0;

/// The most steps that kAutoSteps takes.
inline constexpr int kMostAutoSteps = 50;

/// Move a mesh with its boundary in increments, each computed on the mesh that the one before left.
///
/// The boundary goes from where it is to where it is displaced by the local rigid motions of
/// boundary_frames(): after a part f of the way every frame has turned by f times its angle, so that a body
/// that turns keeps its size on the way. With kAutoSteps each increment is half of what safe_step() allows
/// for the rest of the way at once, and all of it when nothing inverts; after kMostAutoSteps, or where the
/// mesh is inverted already, the rest is moved in one.
///
/// @param mesh          moved in place; the held vertices end at their place + @p displacement exactly
/// @param displacement  k x 2, length unit of the mesh
/// @param steps         1 or more, or kAutoSteps
/// @return the number of steps taken
/// @throws InputError, SolverError  as @p move, boundary_frames() and safe_step(); @p steps is negative
int move_in_steps(Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement,
                  const BoundaryMove& move, int steps);

} // namespace morph
