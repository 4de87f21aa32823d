#include "libmorph/pipeline/remesh_guard.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/group_regions.h"
#include "libmorph/remesh/remesh.h"
#include "libmorph/remesh/retriangulate.h"
#include "libmorph/remesh/target_size.h"
#include "libmorph/remesh/transferred_fields.h"

#include <algorithm>

namespace morph {

namespace {

constexpr double kFlat = 0.2;        // quality
constexpr double kMuchFlatter = 0.5; // of the quality before the move: layers are flat from the start
constexpr int kRings = 2;            // around what is bad

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

Mesh at_start(const Mesh& mesh, const Points& before)
{
    Mesh start = mesh;
    points(start) = before;
    return start;
}

std::vector<Index> bad_elements(const Mesh& mesh, const Mesh& start)
{
    std::vector<Index> bad = inverted_elements(mesh, points(mesh));
    const std::vector<double> now = triangle_qualities(mesh), then = triangle_qualities(start);
    for (std::size_t f = 0; f < now.size(); ++f)
        if (now[f] < kFlat && now[f] < kMuchFlatter * then[f])
            bad.push_back(static_cast<Index>(f));
    return bad;
}

/// Of the triangles; inverted ones are below 0.
double worst_quality(const Mesh& mesh)
{
    const std::vector<double> all = triangle_qualities(mesh);
    return all.empty() ? 1 : *std::min_element(all.begin(), all.end());
}

/// A moved mesh with its bad part triangulated again.
struct Filled {
    Mesh mesh;
    std::vector<bool> kept; ///< by its elements
    Index cut_out = 0;
};

Filled filled(const Mesh& mesh, const std::vector<bool>& kept, const Points& before)
{
    RetriangulateSettings settings;
    settings.shape = &before;
    const Retriangulated made = retriangulate(mesh, kept, settings);
    Filled result{build_mesh(made.data), {}, made.cut_out};
    for (const Index element : result.mesh.numbering.element)
        result.kept.push_back(!made.made[at(element)]);
    return result;
}

/// With the borders between groups kept, unless they are tangled themselves.
Filled filled_between(Mesh& mesh, const std::vector<bool>& kept, const Points& before)
{
    try {
        const RegionBorders borders(mesh, group_regions(mesh));
        Filled result = filled(mesh, kept, before);
        borders.remove_from(result.mesh);
        return result;
    } catch (const InputError&) {
        return filled(mesh, kept, before);
    }
}

/// Takes the last of the fields off: edge lengths, positive. On the boundary, whose edges stay as they are,
/// not below what these have now.
Eigen::VectorXd take_sizes(Mesh& mesh)
{
    Eigen::VectorXd sizes = mesh.fields.back().values.col(0);
    mesh.fields.pop_back();
    for (const HalfedgeHandle h : mesh.kernel.halfedges())
        if (mesh.kernel.is_boundary(h)) {
            const Index a = mesh.kernel.from_vertex_handle(h).idx(),
                        b = mesh.kernel.to_vertex_handle(h).idx();
            const double length = (points(mesh).row(a) - points(mesh).row(b)).norm();
            sizes[a] = std::max(sizes[a], length);
            sizes[b] = std::max(sizes[b], length);
        }
    return (sizes.array() > 0).select(sizes, sizes.maxCoeff()); // vertices of no element have none
}

Mesh remeshed(Mesh& mesh, const GroupRegions& regions, const std::vector<bool>& kept,
              const Eigen::VectorXd& sizes)
{
    const RegionBorders borders(mesh, regions);
    RemeshSettings settings;
    settings.kept = kept;
    settings.numbering = NumberingRule::keep_old;
    settings.hold_features = true;
    Mesh result = build_mesh(remesh(mesh, sizes, settings).data);
    borders.remove_from(result);
    return result;
}

} // namespace

std::optional<RemeshedPart> remesh_bad_part(Mesh& mesh, const Points& before)
{
    const Mesh start = at_start(mesh, before);
    const std::vector<Index> bad = bad_elements(mesh, start);
    if (bad.empty())
        return std::nullopt;
    const bool valid = inverted_elements(mesh, points(mesh)).empty();
    Mesh moved = mesh;
    moved.fields.push_back({"size", FieldLocation::vertex, current_sizes(start)});
    Filled part = filled_between(moved, all_but(mesh, bad, kRings), before);
    const Eigen::VectorXd sizes = take_sizes(part.mesh);
    const GroupRegions regions = group_regions(part.mesh);
    Mesh improved = remeshed(part.mesh, regions, part.kept, sizes);
    if (valid && worst_quality(improved) <= worst_quality(mesh))
        return std::nullopt;
    const Locator locator(part.mesh);
    if (!part.mesh.groups.empty())
        improved.groups = transferred_groups(locator, regions, improved);
    if (!part.mesh.fields.empty())
        improved.fields = transferred_fields(locator, improved, part.mesh.fields);
    const RemeshedPart counts{part.cut_out, mesh.numbering.file_vertices, improved.numbering.file_vertices};
    mesh = std::move(improved);
    return counts;
}

} // namespace morph
