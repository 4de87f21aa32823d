#include "libmorph/weights/fit_marker.h"

#include "libmorph/core/error.h"

#include <optional>

namespace morph {

namespace {

CurveFit fit_chain(const Mesh& mesh, const Chain& chain, const std::string& name, const FitSettings& settings)
{
    try {
        return fit_curve(points(mesh)(chain.vertices, {0, 1}), chain.closed, settings);
    } catch (const InputError& error) {
        throw InputError("marker '" + name + "': " + error.what());
    }
}

} // namespace

FittedMarker fit_marker(const Mesh& mesh, const std::string& name, const FitSettings& settings)
{
    if (mesh.dimension != 2)
        throw InputError(
            "marker '" + name +
            "': the mesh is a surface in space; curves are fitted in planar meshes (z = 0) only");
    FittedMarker fitted{name, marker_chain(marker(mesh, name), mesh.numbering), {}, {}};
    fitted.fit = fit_chain(mesh, fitted.chain, name, settings);
    for (const Index corner : fitted.fit.corners) {
        const Index vertex = fitted.chain.vertices[static_cast<std::size_t>(corner)];
        fitted.corner_ids.push_back(mesh.numbering.vertex[static_cast<std::size_t>(vertex)]);
    }
    return fitted;
}

std::vector<FittedCrossing> fitted_crossings(const std::vector<FittedMarker>& markers)
{
    std::vector<Curve> curves;
    for (const FittedMarker& marker : markers)
        curves.emplace_back(marker.fit.curve);
    std::vector<FittedCrossing> found;
    for (std::size_t a = 0; a < curves.size(); ++a)
        for (std::size_t b = a; b < curves.size(); ++b)
            if (const auto crossing =
                    a == b ? find_self_crossing(curves[a]) : find_crossing(curves[a], curves[b]))
                found.push_back({static_cast<Index>(a), static_cast<Index>(b), *crossing});
    return found;
}

} // namespace morph
