#pragma once

#include "libmorph/pipeline/placement.h"
#include "libmorph/quality/quality.h"

#include <functional>
#include <string>
#include <vector>

namespace morph {

/// A mesh that some method has moved, and what that took.
struct MovedMesh {
    Points positions;              ///< n x 3
    Index control_variables = 0;   ///< numbers that an optimiser would set
    double weights_seconds = 0;    ///< once for a mesh
    double move_seconds = 0;       ///< for every move
    std::size_t weights_bytes = 0; ///< what is kept between moves
};

/// One way of making the move of some curves.
struct ComparedMethod {
    std::string name;
    std::string description;   ///< a few words
    bool uses_lattice = false; ///< MotionSettings::lattice or, without one, a lattice around all curves
    std::function<MovedMesh(const Mesh& mesh, const PlacedBoundaries& placed, const MotionSettings& motion)>
        move; ///< @p placed: the curves of @p motion; MotionSettings::deform is used but for its method
};

/// Every method, in the order of the table in the source; a new one is one more row there.
const std::vector<ComparedMethod>& compared_methods();

/// The method of that name; "NAME+untangle" repairs the elements that NAME leaves inverted.
/// @throws InputError  no such method; names the nearest
ComparedMethod compared_method(const std::string& name);

/// One method's result for one move.
struct ComparisonRow {
    std::string method;
    MovedMesh moved;
    double boundary_error =
        0; ///< largest distance of a boundary node from where its curve puts it, relative to
           ///  the size of the curve
    double rms_boundary_error = 0; ///< root mean square of the same
    QualityReport quality;         ///< with the mesh before the move as the reference
    double energy = 0;             ///< dirichlet_energy() of the displacement
    Index worst_element = -1;      ///< the one of the smallest scaled Jacobian, in the numbering of the mesh
};

/// Move a planar mesh by a method and measure what comes out.
/// @param mesh    undeformed; it is not changed
/// @param placed  parametrize_boundaries() of the mesh and @p motion
/// @param motion  the curves and how their control points move
/// @param method  from compared_method()
/// @throws InputError   the motion has no curve; as Deformer
/// @throws SolverError  as Deformer
ComparisonRow compare(const Mesh& mesh, const PlacedBoundaries& placed, const MotionSettings& motion,
                      const ComparedMethod& method);

} // namespace morph
