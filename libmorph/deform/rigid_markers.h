#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/boundary_extension.h"

#include <string>
#include <vector>

namespace morph {

/// The displacement of a boundary with each of some markers turned and shifted as one rigid body: its
/// vertices get the rigid motion that fits their displacement best in the least-squares sense [Kabsch 1976,
/// Acta Crystallographica A32, 922-923; in the plane the angle is the argument of one complex sum]. What
/// bends the marker is left out.
///
/// @param displacement  k x 2, row i moves held.vertices[i]; length unit of the mesh
/// @throws InputError  no such marker, or one that is neither moved nor fixed
Matrix with_rigid_markers(const Mesh& mesh, const DirichletBoundary& held, Matrix displacement,
                          const std::vector<std::string>& markers);

} // namespace morph
