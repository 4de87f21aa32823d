#include "libmorph/pipeline/generate.h"

#include "libmorph/core/error.h"
#include "libmorph/geometry/mesh_domain.h"

namespace morph {

namespace {

DomainSpec domain_of(const GenerateSettings& settings, const std::vector<CurveMove>& curves)
{
    DomainSpec spec;
    spec.box = settings.box;
    spec.size = settings.size;
    for (const CurveMove& curve : curves) {
        if (curve.nodes == 0)
            throw InputError(curve.where + "boundary '" + curve.marker +
                             "' needs nodes = ..., the number of nodes it gets in the generated mesh");
        spec.curves.push_back({curve.marker, make_curve(curve), curve.nodes});
    }
    return spec;
}

} // namespace

MeshData generate_mesh(const GenerateSettings& settings, const std::vector<CurveMove>& curves)
{
    const DomainSpec spec = domain_of(settings, curves);
    try {
        return mesh_domain(spec);
    } catch (const InputError& error) {
        throw InputError(settings.where + error.what());
    } catch (const SolverError& error) {
        throw SolverError(settings.where + error.what());
    }
}

} // namespace morph
