#pragma once

#include "libmorph/deform/constraints.h"
#include "libmorph/weights/weights_view.h"
#include "tools/deform/boundary_carry.h"
#include "tools/deform/case_control.h"
#include "tools/deform/case_weights.h"
#include "tools/deform/placed_lattice.h"
#include "tools/deform/placement.h"

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace morph::tools {

/// A case brought onto its mesh: its control points, whichever they are, and how the mesh follows them.
struct CaseMotion {
    PlacedBoundaries curves; ///< boundaries on their curves; none when a lattice moves the boundary
    std::optional<PlacedLattice> lattice;         ///< with [lattice]
    std::variant<Weights, SparseWeights> weights; ///< with carry those of the boundary alone
    std::optional<BoundaryCarry> carry;           ///< when the mesh does not follow by weights
    Matrix displacements;                         ///< K x 2 or K x 3, rows as the columns of the weights

    const std::vector<ControlPoint>& columns() const;
    WeightsView rows() const;
    /// Control points that must keep their displacement.
    std::vector<Index> held() const;
};

/// Bring a case onto its mesh and fill its weights.
///
/// Method "ffd": the lattice moves every vertex in it. Any other method: the curves move their markers, or,
/// without curves, the lattice moves its markers, and the method carries the rest.
/// @param weights_file  read the weights from it; empty: fill them
/// @throws InputError, SolverError
CaseMotion prepare_motion(const Mesh& mesh, const CaseFile& file, const std::string& weights_file = "");

/// What the fit of a lattice to moved curves, pulls and constraints did to the displacements.
struct ControlOutcome {
    std::optional<PullOutcome> pull;
    std::optional<ConstrainedMove> constrained;
    std::optional<double>
        curve_misfit; ///< largest distance of a boundary node to its moved curve, length unit of the mesh
};

/// Let the curves that a lattice is fitted to, then [[pull]], then [constraints] have their say about the
/// displacements.
ControlOutcome control_motion(const Mesh& mesh, const CaseFile& file, CaseMotion& motion);

/// Whether the vertices move in proportion to the displacements: not under a lattice whose weights change
/// too, nor with rotations, steps, sliding markers and rigid layers.
bool is_linear(const CaseFile& file);

/// Move the vertices.
/// @param mesh       before the move
/// @param positions  n x 3, moved in place; may be those of @p mesh
/// @return the number of steps taken, 1 but for [deform] steps
int apply_motion(const Mesh& mesh, const CaseFile& file, const CaseMotion& motion,
                 Eigen::Map<Points> positions);

/// Range of the weights, and how far rows that should sum to one do not: those of the curves' own nodes, and
/// of the vertices that a lattice moves.
struct WeightsCheck {
    double min = 0;
    double max = 0;
    double partition_error = 0;
};
WeightsCheck check_weights(const CaseMotion& motion);

/// The weights as a matrix that stores all of them, for files and for whoever needs their range.
Weights dense_weights(const CaseMotion& motion);

} // namespace morph::tools
