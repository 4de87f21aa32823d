#include "libmorph/weights/harmonic_curves.h"

#include "libmorph/weights/boundary.h"

#include <algorithm>

namespace morph {

Weights harmonic_curve_weights(const Mesh& mesh, const std::vector<NamedCurve>& curves,
                               Diffusivity diffusivity)
{
    std::vector<CurveBoundary> boundaries;
    std::vector<std::string> carried;
    for (const NamedCurve& named : curves) {
        boundaries.push_back(parametrize_marker(mesh, named.marker, named.curve));
        carried.push_back(named.marker);
    }
    const BoundaryConditions conditions = boundary_conditions(mesh, boundaries, other_markers(mesh, carried));
    return {conditions.columns,
            harmonic_weights(mesh, {conditions.held, conditions.moving_edges, conditions.marker_edges},
                             diffusivity)};
}

std::vector<std::string> other_markers(const Mesh& mesh, const std::vector<std::string>& carried)
{
    std::vector<std::string> names;
    const auto contains = [](const std::vector<std::string>& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    for (const Marker& m : mesh.markers)
        if (!contains(carried, m.name) && !contains(names, m.name))
            names.push_back(m.name);
    return names;
}

} // namespace morph
