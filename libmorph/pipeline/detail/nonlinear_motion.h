#pragma once

#include "libmorph/deform/boundary_move.h"
#include "libmorph/pipeline/placement.h"
#include "libmorph/pipeline/settings.h"

#include <string>
#include <vector>

namespace morph {

/// How a boundary moves the mesh where that is no product of weights and displacements.
struct NonlinearMotion {
    DirichletBoundary boundary;
    Matrix rows; ///< k x K: how the boundary's vertices follow the control points
    BoundaryMove move;
    int steps = 1;
    std::vector<std::string> rigid_markers = {}; ///< each moves as one rigid body
};

/// The boundary of a move with all that its settings ask for.
/// @throws InputError  rotations with a method in which x and y influence each other
NonlinearMotion nonlinear_motion(const PlacedBoundaries& placed, const MotionSettings& settings);

/// Move the vertices with their boundary.
/// @param mesh           before the move
/// @param displacements  K x 2
/// @param positions      n x 3: where they go
/// @return the number of steps taken
int move_nonlinear(const Mesh& mesh, const NonlinearMotion& motion, const Matrix& displacements,
                   Eigen::Map<Points> positions);

} // namespace morph
