#include "tools/case/generate_mesh.h"

#include "libmorph/core/error.h"
#include "libmorph/geometry/mesh_domain.h"

namespace morph::tools {

namespace {

DomainSpec domain_of(const CaseFile& file)
{
    if (!file.generate)
        throw InputError(file.path + ": nothing to generate: [mesh] has file, expected generate = { box = "
                                     "[xmin, ymin, xmax, ymax], size = ... }");
    DomainSpec spec;
    spec.box = file.generate->box;
    spec.size = file.generate->size;
    for (const BoundaryEntry& entry : file.boundaries) {
        if (entry.nodes == 0)
            throw InputError(file.path + ":" + std::to_string(entry.line) + ": boundary '" + entry.name +
                             "' needs nodes = ..., the number of nodes it gets in the generated mesh");
        spec.curves.push_back({entry.name, Curve(entry.curve), entry.nodes});
    }
    return spec;
}

} // namespace

MeshData generate_mesh(const CaseFile& file)
{
    const DomainSpec spec = domain_of(file);
    try {
        return mesh_domain(spec);
    } catch (const InputError& error) {
        throw InputError(file.path + ": " + error.what());
    } catch (const SolverError& error) {
        throw SolverError(file.path + ": " + error.what());
    }
}

} // namespace morph::tools
