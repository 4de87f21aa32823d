#include "tools/deform/spread_methods.h"

#include "libmorph/core/error.h"
#include "libmorph/weights/harmonic.h"

#include <map>

namespace morph::tools {

namespace {

std::unique_ptr<Spread> make_harmonic(const Mesh& mesh, const HeldBoundary& held, const DeformEntry& deform)
{
    static const std::map<std::string, Diffusivity> kDiffusivities{
        {"uniform", Diffusivity::uniform},
        {"inverse-distance", Diffusivity::inverse_distance},
        {"inverse-area", Diffusivity::inverse_area},
    };
    return harmonic_spread(mesh, held, kDiffusivities.at(deform.diffusivity));
}

} // namespace

const std::vector<SpreadMethod>& spread_methods()
{
    static const std::vector<SpreadMethod> table{
        {"harmonic", "harmonic functions", make_harmonic},
    };
    return table;
}

const SpreadMethod& spread_method(const DeformEntry& deform)
{
    for (const SpreadMethod& method : spread_methods())
        if (method.name == deform.method)
            return method;
    throw InputError("method '" + deform.method + "' does not carry a boundary's move into the mesh");
}

} // namespace morph::tools
