#include "libmorph/remesh/remesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/progress.h"
#include "libmorph/core/space_curve.h"
#include "libmorph/remesh/curve_limit.h"
#include "libmorph/remesh/relax.h"
#include "libmorph/remesh/resize.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

constexpr const char* kStage = "remeshing";

std::size_t at(Index i)
{
    return static_cast<std::size_t>(i);
}

void require_sizes(const Mesh& mesh, const Eigen::VectorXd& sizes)
{
    if (sizes.size() != vertex_count(mesh))
        throw InputError("there are " + std::to_string(sizes.size()) + " wanted sizes, but the mesh has " +
                         std::to_string(vertex_count(mesh)) + " vertices");
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (!(sizes[v] > 0) || !std::isfinite(sizes[v]))
            throw InputError("vertex " + std::to_string(mesh.numbering.vertex[at(v)]) +
                             " has the wanted size " + number_text(sizes[v]) + ", but it has to be positive");
}

std::vector<bool> kept_elements(const Mesh& mesh, const RemeshSettings& settings)
{
    std::vector<bool> kept = settings.kept;
    kept.resize(at(element_count(mesh)), false);
    if (!settings.kept.empty() && settings.kept.size() != kept.size())
        throw InputError("there are " + std::to_string(settings.kept.size()) +
                         " marks of elements to keep, but the mesh has " + std::to_string(kept.size()) +
                         " elements");
    for (Index f = 0; f < element_count(mesh); ++f)
        if (element_corners(mesh, f)[3] >= 0)
            kept[at(f)] = true;
    return kept;
}

void require_positive(const Remaking& made, const Mesh& mesh, const std::vector<bool>& kept)
{
    Index t = 0;
    for (Index f = 0; f < element_count(mesh); ++f) {
        if (kept[at(f)])
            continue;
        if (!(triangle_quality(made, t) > 0))
            throw InputError("element " + std::to_string(mesh.numbering.element[at(f)]) +
                             (made.planar ? " is inverted or has no area; untangle the mesh first"
                                          : " has no area; remove it first"));
        ++t;
    }
}

/// Renumber along a space-filling curve, so that what is near is near in memory.
void renumber(Remaking& made)
{
    Points positions(static_cast<Eigen::Index>(made.net.vertices.size()), 3);
    for (std::size_t v = 0; v < made.net.vertices.size(); ++v)
        positions.row(static_cast<Eigen::Index>(v)) = made.net.vertices[v].point;
    made.net.renumber(hilbert_order(positions, made.planar ? 2 : 3));
}

double longest_edge(const TriangleNet& net)
{
    double longest = 0;
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h)
        longest = std::max(longest, relative_length(net, net.from[at(h)], net.to(h)));
    return longest;
}

/// Longest edges first, with flips between: else what refines a large triangle much makes fans of hundreds.
void refine_in_steps(Remaking& made)
{
    constexpr double kStep = 1.5;
    for (double longest = longest_edge(made.net) / kStep; longest > kLongEdge; longest /= kStep) {
        split_long_edges(made, longest);
        flip_edges(made);
    }
}

void remake(Remaking& made, int iterations)
{
    constexpr double kMend = 0.7; // quality below which triangles are looked at one by one
    constexpr int kLastSweeps = 5;
    for (int i = 0; i < iterations; ++i) {
        report_progress(kStage, static_cast<double>(i) / iterations);
        if (i == 0)
            refine_in_steps(made);
        split_long_edges(made);
        collapse_short_edges(made);
        if (i == 0)
            renumber(made);
        flip_edges(made);
        relax_vertices(made, 2);
    }
    flip_edges(made);
    relax_vertices(made, kLastSweeps);
    flip_edges(made);
    relax_vertices(made, kLastSweeps);
    mend_worst(made, kMend);
    renumber(made);
}

} // namespace

RemadeMesh remesh(const Mesh& mesh, const Eigen::VectorXd& sizes, const RemeshSettings& settings)
{
    require_sizes(mesh, sizes);
    const std::vector<bool> kept = kept_elements(mesh, settings);
    TriangleNet net = net_of(mesh, kept);
    for (NetVertex& vertex : net.vertices)
        vertex.size = sizes[vertex.origin];
    const bool planar = mesh.dimension == 2;
    Underlay underlay(net, planar);
    Remaking made{std::move(net), {}, std::move(underlay), planar};
    require_positive(made, mesh, kept);
    find_features(made, mesh, settings.features);
    limit_by_curves(made);
    if (!planar)
        made.underlay.find_normals(made.net.tag);
    const TriangleNet before = made.net;
    remake(made, settings.iterations);
    RemadeMesh remade = mesh_of(made, before, mesh, kept, settings.numbering);
    remade.sizes = sizes;
    for (const NetVertex& vertex : before.vertices)
        remade.sizes[vertex.origin] = vertex.size;
    return remade;
}

} // namespace morph
