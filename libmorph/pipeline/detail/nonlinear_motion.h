#pragma once

#include "libmorph/deform/boundary_move.h"
#include "tools/case/case_file.h"
#include "tools/deform/placement.h"

namespace morph::tools {

/// How a case's boundary takes the mesh along where that is no product of weights and displacements.
struct BoundaryCarry {
    DirichletBoundary held;
    Matrix rows; ///< k x K: how the held vertices follow the control points
    BoundaryMove move;
    int steps = 1;
    std::vector<std::string> rigid_markers = {}; ///< these move as one rigid body each
};

/// Whether a case asks for what weights cannot do: rotations, steps, sliding markers, rigid layers, a method
/// that couples x and y.
bool carries_boundary(const DeformEntry& deform);

/// The boundary of a case with all that [deform] asks for.
BoundaryCarry boundary_carry(const PlacedBoundaries& placed, const CaseFile& file);

/// The held boundary of a case.
DirichletBoundary dirichlet_boundary(const BoundaryConditions& conditions);

/// Move the vertices with their boundary.
/// @param mesh           before the move
/// @param displacements  K x 2
/// @param positions      n x 3: where they go
/// @return the number of steps taken
int carry_boundary(const Mesh& mesh, const BoundaryCarry& carry, const Matrix& displacements,
                   Eigen::Map<Points> positions);

} // namespace morph::tools
