#pragma once

#include "libmorph/basis/curve.h"
#include "libmorph/pipeline/constraint_settings.h"
#include "libmorph/pipeline/deform_settings.h"
#include "libmorph/pipeline/lattice_settings.h"
#include "libmorph/weights/weights.h"

#include <optional>
#include <string>
#include <vector>

namespace morph {

/// A marker, the curve through its nodes and how the control points of the curve move.
struct CurveMove {
    std::string where = {};  ///< in front of messages about it: "case.toml:12: "
    std::string marker = {}; ///< its name, and that of its control points
    CurveDefinition curve = {};
    Points2 displacements = {}; ///< K x 2, length unit of the mesh; empty: zero
    Index nodes = 0;            ///< for generate_mesh(): how many nodes the curve gets
};

/// @throws InputError  as Curve; names the marker
Curve make_curve(const CurveMove& move);

/// Vertices of the mesh, by number or as those nearest to points, and how far they are to move.
struct PullSettings {
    std::string where = {};           ///< in front of messages about it: "case.toml:12: "
    std::vector<Index> vertices = {}; ///< file numbers
    Matrix points = {};               ///< m x 3; may be empty
    Matrix displacements = {};        ///< a row for each vertex, then for each point; x, y and z
};

/// What is to move and how.
///
/// Method::ffd: the lattice moves every vertex inside it, fitted to the moved curves where there are curves. Any
/// other method: the curves move their markers or, without curves, the lattice moves its markers, and the mesh
/// follows. Every entry has a text `where` that messages about it begin with: the place in a case file, empty
/// for settings made in a program. Messages name the entry itself in any case.
struct MotionSettings {
    std::string where = {}; ///< in front of messages about the whole: "case.toml: "
    std::vector<CurveMove> curves = {};
    std::optional<LatticeSettings> lattice = {};
    std::vector<PullSettings> pulls = {}; ///< reached by the smallest change of the displacements
    std::optional<ConstraintSettings> constraints = {};
    DeformSettings deform = {};
};

/// Whether the lattice moves anything: with Method::ffd, or without curves.
bool uses_lattice(const MotionSettings& settings);

/// Whether the weights of the lattice's control points change with the move.
bool moves_lattice_weights(const MotionSettings& settings);

/// Whether the vertices move in proportion to the displacements: not under a lattice whose weights change
/// too, nor where needs_nonlinear_motion().
bool is_linear(const MotionSettings& settings);

/// @throws InputError  the move is not linear: there are no weights to save or to read, and no gradient
void require_linear(const MotionSettings& settings);

/// The control points that the settings speak of, in the order of the columns of the weights.
std::vector<ControlPoint> control_points(const MotionSettings& settings);

/// @throws InputError  names the entry: nothing to move; rows that do not fit; a number out of range
void check(const MotionSettings& settings);

} // namespace morph
