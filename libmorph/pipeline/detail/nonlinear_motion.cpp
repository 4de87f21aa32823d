#include "libmorph/pipeline/detail/nonlinear_motion.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/move_in_steps.h"
#include "libmorph/deform/rigid_frames.h"
#include "libmorph/deform/rigid_layers.h"
#include "libmorph/deform/rigid_markers.h"
#include "libmorph/deform/slide.h"
#include "libmorph/pipeline/detail/extension_methods.h"

namespace morph {

namespace {

BoundaryMove plain_move(const DeformSettings& deform)
{
    return [deform](const Mesh& mesh, const DirichletBoundary& boundary, const Matrix& displacement) {
        const auto extension = make_extension(mesh, boundary, deform, displacement);
        return uses_rotations(deform) ? extend_with_rotations(*extension, mesh, boundary, displacement)
                                      : extension->extend(displacement);
    };
}

std::vector<SlidingMarker> sliding_markers(const MotionSettings& settings)
{
    std::vector<SlidingMarker> markers;
    for (const std::string& name : settings.deform.slide) {
        SlidingMarker sliding{name, std::nullopt};
        for (const CurveMove& curve : settings.curves)
            if (curve.marker == name)
                sliding.curve = make_curve(curve);
        markers.push_back(std::move(sliding));
    }
    return markers;
}

} // namespace

NonlinearMotion nonlinear_motion(const PlacedBoundaries& placed, const MotionSettings& settings)
{
    const DeformSettings& deform = settings.deform;
    if (uses_rotations(deform) && couples_directions(deform))
        throw InputError(deform.where + "[deform] rotations go with methods that move x and y apart; \"" +
                         to_string(deform.method) + "\" as it is set moves them together");
    NonlinearMotion motion{placed.conditions.boundary, placed.conditions.values, plain_move(deform),
                           deform.steps};
    std::vector<RigidLayer> layers;
    for (const RigidMarker& rigid : deform.rigid) {
        if (rigid.distance > 0)
            layers.push_back({rigid.marker, rigid.distance});
        else
            motion.rigid_markers.push_back(rigid.marker);
    }
    if (!layers.empty())
        motion.move = with_rigid_layers(motion.move, layers);
    if (!deform.slide.empty())
        motion.move = with_sliding(motion.move, sliding_markers(settings));
    return motion;
}

int move_nonlinear(const Mesh& mesh, const NonlinearMotion& motion, const Matrix& displacements,
                   Eigen::Map<Points> positions)
{
    Mesh moving = mesh;
    const Matrix moved =
        with_rigid_markers(mesh, motion.boundary, motion.rows * displacements, motion.rigid_markers);
    const int steps = move_in_steps(moving, motion.boundary, moved, motion.move, motion.steps);
    positions = points(moving);
    return steps;
}

} // namespace morph
