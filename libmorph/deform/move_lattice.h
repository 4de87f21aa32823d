#pragma once

#include "libmorph/weights/embed.h"

namespace morph {

/// Move embedded points with the control points of a lattice: x += sum R_ijk(u) D_ijk.
///
/// The same as lattice_weights() and apply_weights() to rounding, without the matrix: the sum is taken one
/// direction after the other, so that a point costs the same whatever the number of control points. Points
/// outside stay. Linear in @p displacements; zero moves nothing; equal bytes for any thread count.
///
/// @param embedding      of n points in @p lattice
/// @param displacements  N x dimension, length unit of the mesh, rows as the control points
/// @param positions      n x 3, moved in place
/// @throws InputError    the sizes do not fit
void move_by_lattice(const Lattice& lattice, const Embedding& embedding, const Matrix& displacements,
                     Eigen::Map<Points> positions);

/// Move embedded points from one lattice to another: x += S_to(u) - S_from(u).
///
/// For weights as design variables, on which S does not depend linearly [Lamousin & Waggenspack 1994, IEEE
/// Computer Graphics and Applications 14(6), 59-65]. Between equal lattices nothing moves.
///
/// @param embedding    of n points in @p from
/// @param to           differs from @p from in control points and weights only
/// @param positions    n x 3, moved in place
/// @throws InputError  the sizes do not fit, or degrees or knots differ
void move_by_lattice(const Lattice& from, const Lattice& to, const Embedding& embedding,
                     Eigen::Map<Points> positions);

} // namespace morph
