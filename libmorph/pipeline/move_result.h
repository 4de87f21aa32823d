#pragma once

#include "libmorph/deform/constraints.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/pipeline/placement.h"
#include "libmorph/pipeline/remesh_guard.h"
#include "libmorph/quality/quality.h"
#include "libmorph/quality/safe_step.h"
#include "libmorph/untangle/untangle.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// Where pulled vertices came to.
struct PullOutcome {
    std::vector<Index> vertices; ///< m, file numbers
    Matrix residual;             ///< m x 2 or m x 3: displacement asked for minus the one reached
    Index rank = 0;              ///< how many of them the control points can move independently
};

/// What the fit of a lattice to moved curves, pulls and constraints did to the displacements.
struct ControlOutcome {
    std::optional<PullOutcome> pull;
    std::optional<ConstrainedMove> constrained;

    /// Of a lattice fitted to moved curves: the largest distance of a boundary node to where its curve moves it,
    /// length unit of the mesh.
    std::optional<double> curve_misfit;
};

/// Range of the weights, and how far rows that should sum to one do not: those of the curves' own nodes, and
/// of the vertices that a lattice moves.
struct WeightsCheck {
    double min = 0;
    double max = 0;
    double partition_error = 0;
};

/// Seconds that a move took.
struct MoveSeconds {
    double apply = 0; ///< until the vertices were where they go
    double guard = 0; ///< checks and repair
};

/// A moved mesh, what was found out about it and what was repaired.
struct MoveResult {
    Points positions;     ///< n x 3: where the vertices are, length unit of the mesh
    Matrix displacements; ///< K x d: of the control points, as they were used
    ControlOutcome control;
    std::vector<BoundaryFit> fits;     ///< one for each curve
    int steps = 1;                     ///< taken, see DeformSettings::steps
    std::optional<SafeStep> safe_step; ///< planar meshes, moves linear in the control points

    // With a guard:
    std::vector<std::string> crossings;  ///< of moved boundaries, a sentence each: no valid mesh exists then
    std::optional<QualityReport> before; ///< of the mesh before the move
    std::optional<QualityReport> after;
    Index tangled = 0; ///< inverted elements before the repair

    /// Where there was something to untangle; file numbers, ascending.
    std::optional<UntangleResult> untangled;

    std::optional<RemeshedPart> remeshed; ///< where elements were replaced
    std::optional<Mesh> mesh;             ///< then: the whole mesh at its place, with numbers of its own

    std::vector<std::string> warnings; ///< repairs that could not be done
    MoveSeconds seconds;
};

/// The moved mesh in the numbering of its file, for a writer.
/// @param mesh    before the move
/// @param result  of Deformer::move() on that mesh
MeshData to_mesh_data(const Mesh& mesh, const MoveResult& result);

/// Whether the moved mesh can be used, as far as the guard looked: no inverted element, no boundary across
/// itself or another.
bool is_valid(const MoveResult& result);

} // namespace morph
