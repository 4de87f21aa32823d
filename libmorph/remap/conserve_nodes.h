#pragma once

#include "libmorph/remap/locate.h"
#include "libmorph/remap/transfer.h"

namespace morph {

/// Transfer nodal values from one planar mesh to another so that their integral is preserved.
///
/// The consistent L2 (Galerkin) projection on the region common to both meshes [Farrell, Piggott, Pain,
/// Gorman & Wilson 2009, Computer Methods in Applied Mechanics and Engineering 198, 2632-2642]: of all fields
/// of the target the one nearest to the source in the mean square, M u = r with M_ij = int phi_i phi_j and
/// r_i = int phi_i u_S, both integrated exactly on clipped polygons. Fields are piecewise linear on both
/// meshes: a quad is its two triangles along the diagonal from its first corner (of the file) to its third,
/// one that is not convex those along its inner diagonal.
///
/// A triangle of the target less than half covered says little about its corners, and what there is could
/// swing them to any value. It is taken lumped: each corner gets the weighted mean of the source continued
/// linearly to it; see lumped_mixed_mass(). That keeps M well conditioned whatever the meshes, and what
/// follows exact:
/// - the integral over the common region is that of the source to 1e-12 of the integral of its magnitude,
/// - constant and linear functions are reproduced, to rounding,
/// - smooth functions are approximated at second order.
/// A value may leave the range of the source's where that jumps. Equal bytes for any thread count. O(1) for
/// each pair of overlapping elements, see Supermesh, and some 30 multiplications by M.
///
/// @param source  of n vertices, planar
/// @param values  n x components, finite, rows in the source's own numbering
/// @return rows for the vertices of the target
/// @throws InputError  a mesh lies in space, the source has no element, values has not n rows
/// @throws SolverError  the iteration does not converge; with finite values it does
Transfer conserve_nodes(const Locator& source, const Mesh& target, const Matrix& values);

} // namespace morph
