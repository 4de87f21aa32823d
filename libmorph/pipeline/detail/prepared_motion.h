#pragma once

#include "libmorph/pipeline/detail/nonlinear_motion.h"
#include "libmorph/pipeline/lattice_placement.h"
#include "libmorph/pipeline/move_result.h"
#include "libmorph/weights/weights_view.h"

#include <optional>
#include <variant>
#include <vector>

namespace morph {

/// A move brought onto its mesh: its control points, whichever they are, and how the mesh follows them.
struct PreparedMotion {
    PlacedBoundaries curves; ///< boundaries on their curves; none when a lattice moves the boundary
    std::optional<PlacedLattice> lattice;
    std::variant<Weights, SparseWeights> weights; ///< of a nonlinear motion those of the boundary alone
    std::optional<NonlinearMotion> nonlinear;     ///< when the mesh does not follow by weights
    Matrix displacements;                         ///< K x 2 or K x 3, rows as the columns of the weights

    const std::vector<ControlPoint>& columns() const;
    WeightsView rows() const;
    /// Control points that must keep their displacement.
    std::vector<Index> held() const;
};

/// Bring a move onto its mesh and fill its weights, see MotionSettings.
/// @param given  use these weights instead of solving for them
/// @throws InputError, SolverError
PreparedMotion prepare_motion(const Mesh& mesh, const MotionSettings& settings, std::optional<Weights> given);

/// Range and sums of the rows of the weights.
WeightsCheck check_weights(const PreparedMotion& motion);

} // namespace morph
