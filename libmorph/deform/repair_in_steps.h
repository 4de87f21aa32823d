#pragma once

#include "libmorph/untangle/untangle.h"
#include "libmorph/weights/boundary_extension.h"

namespace morph {

/// Move a boundary in increments and untangle the mesh after each, so that the search always starts from a
/// valid mesh whose boundary is nearly there.
///
/// Polygons of the boundary go along their LoopPath, vertices on other walls straight. An increment that
/// cannot be untangled is halved, until it is too short to be worth while.
///
/// @param mesh          before the move, without inverted elements
/// @param displacement  k x 2, row i moves held.vertices[i]; length unit of the mesh
/// @param work          patch_vertices and iterations are added to
/// @return n x 3: the mesh after the move, the held vertices at their place + displacement; where some
///         increment failed, with inverted elements that the rest of the way in one has left
/// @throws InputError, SolverError  as harmonic_extension() and untangle()
Points repair_in_steps(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement,
                       UntangleResult& work);

} // namespace morph
