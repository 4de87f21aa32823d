#include "tools/deform/remesh_guard.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/remesh.h"
#include "libmorph/remesh/retriangulate.h"
#include "libmorph/remesh/target_size.h"
#include "tools/remesh/group_regions.h"
#include "tools/remesh/transferred_fields.h"

#include <algorithm>

namespace morph::tools {

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

/// A moved mesh with its bad part triangulated anew.
struct Filled {
    Mesh mesh;
    std::vector<bool> kept; ///< by its elements
    Index cut_out = 0;
};

Filled filled(const Mesh& mesh, const std::vector<bool>& kept, const Points& before)
{
    RetriangulateSettings settings;
    settings.shape = &before;
    const Retriangulated anew = retriangulate(mesh, kept, settings);
    Filled result{build_mesh(anew.data), {}, anew.cut_out};
    for (const Index element : result.mesh.numbering.element)
        result.kept.push_back(!anew.made[at(element)]);
    return result;
}

/// With the borders between groups kept, unless they are tangled themselves.
Filled filled_between(Mesh& mesh, const std::vector<bool>& kept, const Points& before)
{
    Filled result;
    const auto fill = [&](const Mesh& from) {
        result = filled(from, kept, before);
        return std::move(result.mesh);
    };
    const std::size_t markers = mesh.markers.size();
    try {
        result.mesh = remesh_with_region_borders(mesh, group_regions(mesh), fill);
    } catch (const InputError&) {
        mesh.markers.resize(markers);
        result = filled(mesh, kept, before);
    }
    return result;
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

Mesh remade(const Mesh& mesh, const std::vector<bool>& kept, const Eigen::VectorXd& sizes)
{
    RemeshSettings settings;
    settings.kept = kept;
    settings.numbering = NumberingRule::keep_old;
    settings.hold_features = true;
    return build_mesh(remesh(mesh, sizes, settings).data);
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
    Mesh anew = remesh_with_region_borders(part.mesh, regions,
                                           [&](const Mesh& from) { return remade(from, part.kept, sizes); });
    if (valid && worst_quality(anew) <= worst_quality(mesh))
        return std::nullopt;
    const Locator locator(part.mesh);
    if (!part.mesh.groups.empty())
        anew.groups = transferred_groups(locator, regions, anew);
    if (!part.mesh.fields.empty())
        anew.fields = transferred_fields(locator, anew, part.mesh.fields);
    const RemeshedPart counts{part.cut_out, mesh.numbering.file_vertices, anew.numbering.file_vertices};
    mesh = std::move(anew);
    return counts;
}

} // namespace morph::tools
