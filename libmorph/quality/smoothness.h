#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph {

/// How unsmooth a displacement is: its Dirichlet energy, half the integral of |grad d|^2 over the undeformed
/// mesh, summed over the components of d; area unit of the mesh.
///
/// d is linear in triangles; of a quad both ways of cutting it into two triangles count half. 0 for a
/// translation. Of all displacements with the same boundary values the harmonic one has the least. Elements
/// without area are left out. Equal for any thread count.
/// @param before,after  n x 3 positions of the vertices of a planar mesh
/// @throws InputError  another number of rows than the mesh has vertices
double dirichlet_energy(const Mesh& mesh, const PositionsView& before, const PositionsView& after);

} // namespace morph
