#include "tools/deform/boundary_carry.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/move_in_steps.h"
#include "libmorph/deform/rigid_frames.h"
#include "libmorph/deform/rigid_layers.h"
#include "libmorph/deform/rigid_markers.h"
#include "libmorph/deform/slide.h"
#include "tools/deform/extension_methods.h"

namespace morph::tools {

namespace {

BoundaryMove plain_move(const DeformEntry& deform)
{
    return [deform](const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement) {
        const AnyExtension made = extension_method(deform).make({mesh, held, deform, displacement});
        if (const auto* coupled = std::get_if<std::unique_ptr<CoupledExtension>>(&made))
            return Matrix((*coupled)->extend(displacement));
        const BoundaryExtension& extension = *std::get<std::unique_ptr<BoundaryExtension>>(made);
        return uses_rotations(deform) ? extend_with_rotations(extension, mesh, held, displacement)
                                      : extension.extend(displacement);
    };
}

std::vector<SlidingMarker> sliding_markers(const CaseFile& file)
{
    std::vector<SlidingMarker> markers;
    for (const std::string& name : file.deform.slide) {
        SlidingMarker sliding{name, std::nullopt};
        for (const BoundaryEntry& boundary : file.boundaries)
            if (boundary.name == name)
                sliding.curve = Curve(boundary.curve);
        markers.push_back(std::move(sliding));
    }
    return markers;
}

} // namespace

bool carries_boundary(const DeformEntry& deform)
{
    const bool coupled = deform.method != "ffd" && extension_method(deform).couples(deform);
    return coupled || uses_rotations(deform) || deform.steps != 1 || !deform.slide.empty() ||
           !deform.rigid.empty();
}

DirichletBoundary dirichlet_boundary(const BoundaryConditions& conditions)
{
    return {conditions.held.vertices, conditions.moving_edges, conditions.marker_edges};
}

BoundaryCarry boundary_carry(const PlacedBoundaries& placed, const CaseFile& file)
{
    if (uses_rotations(file.deform) && extension_method(file.deform).couples(file.deform))
        throw InputError(file.path + ":" + std::to_string(file.deform.line) +
                         ": [deform] rotations go with "
                         "methods that move x and y apart; \"" +
                         file.deform.method + "\" as it is set moves them together");
    BoundaryCarry carry{dirichlet_boundary(placed.conditions), placed.conditions.held.values,
                        plain_move(file.deform), file.deform.steps};
    std::vector<RigidLayer> layers;
    for (const RigidEntry& entry : file.deform.rigid) {
        if (entry.distance > 0)
            layers.push_back({entry.marker, entry.distance});
        else
            carry.rigid_markers.push_back(entry.marker);
    }
    if (!layers.empty())
        carry.move = with_rigid_layers(carry.move, layers);
    if (!file.deform.slide.empty())
        carry.move = with_sliding(carry.move, sliding_markers(file));
    return carry;
}

int carry_boundary(const Mesh& mesh, const BoundaryCarry& carry, const Matrix& displacements,
                   Eigen::Map<Points> positions)
{
    Mesh moving = mesh;
    const Matrix moved =
        with_rigid_markers(mesh, carry.held, carry.rows * displacements, carry.rigid_markers);
    const int steps = move_in_steps(moving, carry.held, moved, carry.move, carry.steps);
    positions = points(moving);
    return steps;
}

} // namespace morph::tools
