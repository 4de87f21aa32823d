#include "libmorph/remesh/remesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/progress.h"
#include "libmorph/core/space_curve.h"
#include "libmorph/remesh/curvature_limit.h"
#include "libmorph/remesh/local_operations.h"
#include "libmorph/remesh/smoothing.h"
#include "libmorph/remesh/start_from_boundary.h"

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
        if (!mesh.kernel.is_isolated(VertexHandle(v)) && (!(sizes[v] > 0) || !std::isfinite(sizes[v])))
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

void require_positive(const RemeshState& made, const Mesh& mesh, const std::vector<bool>& kept)
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
void renumber(RemeshState& made)
{
    Points positions(static_cast<Eigen::Index>(made.net.vertices.size()), 3);
    for (std::size_t v = 0; v < made.net.vertices.size(); ++v)
        positions.row(static_cast<Eigen::Index>(v)) = made.net.vertices[v].point;
    made.net.renumber(hilbert_order(positions, made.planar ? 2 : 3));
}

/// The longest of the edges that may be split.
double longest_edge(const CornerTable& net)
{
    double longest = 0;
    for (Index h = 0; h < static_cast<Index>(net.from.size()); ++h)
        if (net.from[at(h)] >= 0 && net.tag[at(h)] != kKeptTag)
            longest = std::max(longest, relative_length(net, net.from[at(h)], net.to(h)));
    return longest;
}

/// Longest edges first, with flips between: else what refines a large triangle much makes fans of hundreds.
/// Looks for the longest anew each time, as the middle of an edge may be where much shorter ones are wanted.
void refine_in_steps(RemeshState& made)
{
    constexpr double kStep = 1.5;
    constexpr int kMostSteps = 200;
    double limit = longest_edge(made.net);
    for (int step = 0; step < kMostSteps && limit > kLongEdge; ++step) {
        limit = std::max(limit / kStep, kLongEdge);
        if (split_long_edges(made, limit) == 0)
            continue;
        flip_edges(made);
        limit = longest_edge(made.net);
    }
}

void remake(RemeshState& made, int iterations)
{
    constexpr double kMend = 0.7; // quality below which triangles are looked at one by one
    constexpr int kLastSweeps = 5;
    for (int i = 0; i < iterations; ++i) {
        report_progress(kStage, static_cast<double>(i) / iterations);
        refine_in_steps(made);
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

/// Features as if they were sides of kept elements.
void hold_features(CornerTable& net)
{
    for (Index& tag : net.tag)
        if (tag != kNoTag)
            tag = kKeptTag;
    for (TableVertex& vertex : net.vertices)
        if (vertex.curve != kFreeVertex)
            vertex.curve = kFixedVertex;
}

void mark_features(RemeshState& made, const Mesh& mesh, const RemeshSettings& settings)
{
    find_features(made, mesh, settings.features);
    if (settings.hold_features)
        hold_features(made.net);
}

RemeshResult remade(RemeshState& made, const Mesh& mesh, const std::vector<bool>& kept,
                    const RemeshSettings& settings)
{
    const CornerTable before = made.net;
    remake(made, settings.iterations);
    return mesh_of(made, before, mesh, kept, settings.numbering);
}

RemeshResult made_anew(RemeshState& made, const Mesh& mesh, const std::vector<bool>& kept,
                       const RemeshSettings& settings)
{
    const Outline outline = start_from_outline(made, mesh, kept);
    mark_features(made, outline.mesh, settings);
    return remade(made, outline.mesh, outline.kept, settings);
}

} // namespace

RemeshResult remesh(const Mesh& mesh, const Eigen::VectorXd& sizes, const RemeshSettings& settings)
{
    require_sizes(mesh, sizes);
    const std::vector<bool> kept = kept_elements(mesh, settings);
    CornerTable net = net_of(mesh, kept);
    for (TableVertex& vertex : net.vertices)
        vertex.size = sizes[vertex.origin];
    const bool planar = mesh.dimension == 2;
    BackgroundMesh underlay(net, planar);
    RemeshState made{std::move(net), {}, std::move(underlay), planar};
    require_positive(made, mesh, kept);
    mark_features(made, mesh, settings);
    limit_by_curves(made);
    if (!planar)
        made.underlay.find_normals(made.net.tag);
    Eigen::VectorXd limited = sizes;
    for (const TableVertex& vertex : made.net.vertices)
        limited[vertex.origin] = vertex.size;
    RemeshResult result =
        settings.fresh ? made_anew(made, mesh, kept, settings) : remade(made, mesh, kept, settings);
    result.sizes = limited;
    return result;
}

} // namespace morph
