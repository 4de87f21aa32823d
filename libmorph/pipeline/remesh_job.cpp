#include "libmorph/pipeline/remesh_job.h"

#include "libmorph/core/error.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remap/locate.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/bounded_remesh.h"
#include "libmorph/remesh/group_regions.h"
#include "libmorph/remesh/remesh.h"
#include "libmorph/remesh/retriangulate.h"
#include "libmorph/remesh/transferred_fields.h"

#include <cmath>
#include <utility>

namespace morph {

namespace {

Retriangulated retriangulated(const Mesh& mesh, const std::vector<bool>& kept, const std::string& where)
{
    try {
        return retriangulate(mesh, kept);
    } catch (const InputError& error) {
        throw InputError(where + error.what());
    }
}

/// The mesh; a planar one with inverted elements with these and two rings around them triangulated again.
Mesh without_inverted(const Mesh& mesh, const std::string& where, std::optional<CutOut>& cut_out)
{
    constexpr int kRings = 2;
    if (mesh.dimension != 2)
        return mesh;
    const std::vector<Index> inverted = inverted_elements(mesh, points(mesh));
    if (inverted.empty())
        return mesh;
    const Retriangulated filled = retriangulated(mesh, all_but(mesh, inverted, kRings), where);
    cut_out = {static_cast<Index>(inverted.size()), filled.cut_out,
               mesh.numbering.file_vertices - static_cast<Index>(filled.data.points.rows())};
    return build_mesh(filled.data);
}

RemeshSettings settings_of(const Mesh& mesh, const RemeshJob& job)
{
    RemeshSettings settings;
    if (job.only_bad > 0)
        settings.kept = all_but_bad(mesh, job.only_bad);
    keep_zones(mesh, job.zones, settings.kept);
    if (!settings.kept.empty())
        settings.numbering = NumberingRule::keep_old;
    settings.iterations = job.iterations;
    settings.fresh = job.fresh;
    settings.features = job.features;
    return settings;
}

/// With a target number of vertices, sizes are corrected by how many there are too many or too few, as long as
/// that helps.
RemeshResult remesh_to(const Mesh& old, Index vertices, const RemeshSettings& settings,
                       Eigen::VectorXd& sizes)
{
    constexpr int kCorrections = 4;
    constexpr double kNear = 0.02; // of the target number
    RemeshResult made = remesh(old, sizes, settings);
    for (int i = 0; i < kCorrections && vertices > 0; ++i) {
        const double ratio = static_cast<double>(made.data.points.rows()) / vertices;
        if (std::abs(ratio - 1) <= kNear)
            break;
        const Eigen::VectorXd corrected = std::sqrt(ratio) * sizes;
        RemeshResult next = remesh(old, corrected, settings);
        const double next_ratio = static_cast<double>(next.data.points.rows()) / vertices;
        if (std::abs(next_ratio - ratio) <= kNear * ratio)
            break;
        sizes = corrected;
        made = std::move(next);
    }
    return made;
}

/// Sets the sizes to those that the mesh was made with, and what was possible of them.
Mesh remeshed(Mesh& old, const GroupRegions& regions, const RemeshJob& job, const RemeshSettings& settings,
              RemeshTargets& targets)
{
    const RegionBorders borders(old, regions);
    RemeshResult made = job.hausdorff > 0 ? remesh_within(old, job.hausdorff, targets.sizes, settings)
                                          : remesh_to(old, targets.vertices, settings, targets.sizes);
    targets.possible = std::move(made.sizes);
    Mesh mesh = build_mesh(made.data);
    borders.remove_from(mesh);
    return mesh;
}

void keep_sections(const Mesh& old, RemeshedMesh& result)
{
    result.mesh.sections.clear(); // remeshing hands over all of them
    for (const OpaqueSection& section : old.sections)
        if (section.names_vertices)
            result.left_out.push_back(section.what);
        else
            result.mesh.sections.push_back(section);
}

/// Groups, fields, and the targets at the vertices of the new mesh.
void transfer(const Mesh& old, const GroupRegions& regions, bool fields, RemeshedMesh& result)
{
    const Locator locator(old);
    Mesh& mesh = result.mesh;
    if (!old.groups.empty())
        mesh.groups = transferred_groups(locator, regions, mesh);
    if (fields)
        mesh.fields = transferred_fields(locator, mesh, old.fields);
    RemeshTargets& targets = result.targets;
    const std::vector<Field> there =
        transferred_fields(locator, mesh,
                           {{"sizes", FieldLocation::vertex, targets.sizes},
                            {"possible", FieldLocation::vertex, targets.possible}});
    targets.sizes = there[0].values;
    targets.possible = there[1].values;
}

} // namespace

RemeshedMesh remesh(const Mesh& mesh, const RemeshJob& job)
{
    Stopwatch watch;
    RemeshedMesh result;
    Mesh old = without_inverted(mesh, job.where, result.cut_out);
    const RemeshSettings settings = settings_of(old, job);
    result.targets.sizes = target_sizes(old, job.sizes, settings.features, job.where);
    result.targets.vertices = target_vertices(old, job.sizes);
    const GroupRegions regions = group_regions(old);
    result.mesh = remeshed(old, regions, job, settings, result.targets);
    result.remesh_seconds = watch.lap();
    keep_sections(old, result);
    transfer(old, regions, job.transfer_fields, result);
    result.transfer_seconds = watch.lap();
    return result;
}

} // namespace morph
