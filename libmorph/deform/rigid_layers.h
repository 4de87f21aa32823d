#pragma once

#include "libmorph/deform/boundary_move.h"

#include <string>
#include <vector>

namespace morph {

/// The cells next to a marker that keep their shape.
struct RigidLayer {
    std::string marker;
    double distance = 0; ///< from the marker, length unit of the mesh
};

/// The same move with the vertices within a distance of some markers held to them: each follows the local
/// rigid motion, boundary_frames(), of the nearest place of its marker. So layers keep their heights and
/// their angle with the wall wherever the wall only turns and shifts; a marker that moves rigidly takes them
/// along as one body.
///
/// @throws InputError  from the move: no such marker, a distance below 0, as boundary_frames()
BoundaryMove with_rigid_layers(BoundaryMove move, std::vector<RigidLayer> layers);

} // namespace morph
