#include "libmorph/weights/harmonic_curves.h"

namespace morph {

Weights harmonic_curve_weights(const Mesh& mesh, const std::vector<NamedCurve>& curves,
                               Diffusivity diffusivity)
{
    const BoundaryConditions conditions = boundary_conditions(mesh, curves);
    return extended_weights(conditions, *harmonic_extension(mesh, conditions.boundary, diffusivity));
}

} // namespace morph
