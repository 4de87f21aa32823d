#pragma once

#include "libmorph/pipeline/detail/prepared_motion.h"

namespace morph {

/// Change the displacements of a lattice so that the nodes of the curves come near to where their curves move
/// them.
///
/// Least squares alone would take any swing of control points far from the nodes for the last bit of
/// exactness, and tear the mesh around with it. A change of the control points therefore counts too, a
/// thousandth of what the control point that moves the nodes most does [Tikhonov & Arsenin 1977, Solutions of
/// Ill-Posed Problems].
///
/// @param displacements  K x 2, changed in place
/// @return the largest distance that is left, length unit of the mesh
double fit_lattice(const Mesh& mesh, const PreparedMotion& motion, Matrix& displacements);

} // namespace morph
