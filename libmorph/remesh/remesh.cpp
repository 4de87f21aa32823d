#include "libmorph/remesh/remesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/progress.h"
#include "libmorph/core/space_curve.h"
#include "libmorph/remesh/curvature_limit.h"
#include "libmorph/remesh/local_operations.h"
#include "libmorph/remesh/smoothing.h"
#include "libmorph/remesh/start_from_boundary.h"
#include "libmorph/remesh/worst_triangles.h"

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
        throw InputError("there are " + std::to_string(sizes.size()) + " target sizes, but the mesh has " +
                         std::to_string(vertex_count(mesh)) + " vertices");
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (!mesh.kernel.is_isolated(VertexHandle(v)) && (!(sizes[v] > 0) || !std::isfinite(sizes[v])))
            throw InputError("vertex " + std::to_string(mesh.numbering.vertex[at(v)]) +
                             " has the target size " + number_text(sizes[v]) + ", but it has to be positive");
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

void require_positive(const RemeshState& state, const Mesh& mesh, const std::vector<bool>& kept)
{
    Index t = 0;
    for (Index f = 0; f < element_count(mesh); ++f) {
        if (kept[at(f)])
            continue;
        if (!(triangle_quality(state, t) > 0))
            throw InputError("element " + std::to_string(mesh.numbering.element[at(f)]) +
                             (state.planar ? " is inverted or has no area; untangle the mesh first"
                                           : " has no area; remove it first"));
        ++t;
    }
}

/// Renumber along a space-filling curve, so that what is near is near in memory.
void renumber(RemeshState& state)
{
    Points positions(static_cast<Eigen::Index>(state.table.vertices.size()), 3);
    for (std::size_t v = 0; v < state.table.vertices.size(); ++v)
        positions.row(static_cast<Eigen::Index>(v)) = state.table.vertices[v].point;
    state.table.renumber(hilbert_order(positions, state.planar ? 2 : 3));
}

/// The longest of the edges that may be split.
double longest_edge(const CornerTable& table)
{
    double longest = 0;
    for (Index h = 0; h < static_cast<Index>(table.from.size()); ++h)
        if (table.from[at(h)] >= 0 && table.tag[at(h)] != kKeptTag)
            longest = std::max(longest, relative_length(table, table.from[at(h)], table.to(h)));
    return longest;
}

/// Longest edges first, with flips between: else what refines a large triangle much makes fans of hundreds.
/// Looks for the longest again each time, as target lengths in the middle of an edge may be much shorter.
void refine_in_steps(RemeshState& state)
{
    constexpr double kStep = 1.5;
    constexpr int kMostSteps = 200;
    double limit = longest_edge(state.table);
    for (int step = 0; step < kMostSteps && limit > kLongEdge; ++step) {
        limit = std::max(limit / kStep, kLongEdge);
        if (split_long_edges(state, limit) == 0)
            continue;
        flip_edges(state);
        limit = longest_edge(state.table);
    }
}

void improve_mesh(RemeshState& state, int iterations)
{
    constexpr double kPoorQuality = 0.7; // quality below which triangles are looked at one by one
    constexpr int kLastSweeps = 5;
    for (int i = 0; i < iterations; ++i) {
        report_progress(kStage, static_cast<double>(i) / iterations);
        refine_in_steps(state);
        collapse_short_edges(state);
        if (i == 0)
            renumber(state);
        flip_edges(state);
        smooth_vertices(state, 2);
    }
    flip_edges(state);
    smooth_vertices(state, kLastSweeps);
    flip_edges(state);
    smooth_vertices(state, kLastSweeps);
    improve_worst(state, kPoorQuality);
    renumber(state);
}

/// Features as if they were sides of kept elements.
void hold_features(CornerTable& table)
{
    for (Index& tag : table.tag)
        if (tag != kNoTag)
            tag = kKeptTag;
    for (TableVertex& vertex : table.vertices)
        if (vertex.curve != kFreeVertex)
            vertex.curve = kFixedVertex;
}

void mark_features(RemeshState& state, const Mesh& mesh, const RemeshSettings& settings)
{
    find_features(state, mesh, settings.features);
    if (settings.hold_features)
        hold_features(state.table);
}

RemeshResult remeshed(RemeshState& state, const Mesh& mesh, const std::vector<bool>& kept,
                      const RemeshSettings& settings)
{
    const CornerTable before = state.table;
    improve_mesh(state, settings.iterations);
    return mesh_of(state, before, mesh, kept, settings.numbering);
}

RemeshResult remeshed_from_boundary(RemeshState& state, const Mesh& mesh, const std::vector<bool>& kept,
                                    const RemeshSettings& settings)
{
    const Outline outline = start_from_boundary(state, mesh, kept);
    mark_features(state, outline.mesh, settings);
    return remeshed(state, outline.mesh, outline.kept, settings);
}

} // namespace

RemeshResult remesh(const Mesh& mesh, const Eigen::VectorXd& sizes, const RemeshSettings& settings)
{
    require_sizes(mesh, sizes);
    const std::vector<bool> kept = kept_elements(mesh, settings);
    CornerTable table = corner_table_of(mesh, kept);
    for (TableVertex& vertex : table.vertices)
        vertex.size = sizes[vertex.origin];
    const bool planar = mesh.dimension == 2;
    BackgroundMesh background(table, planar);
    RemeshState state{std::move(table), {}, std::move(background), planar};
    require_positive(state, mesh, kept);
    mark_features(state, mesh, settings);
    limit_by_curves(state);
    if (!planar)
        state.background.find_normals(state.table.tag);
    Eigen::VectorXd limited = sizes;
    for (const TableVertex& vertex : state.table.vertices)
        limited[vertex.origin] = vertex.size;
    RemeshResult result = settings.fresh ? remeshed_from_boundary(state, mesh, kept, settings)
                                         : remeshed(state, mesh, kept, settings);
    result.sizes = limited;
    return result;
}

} // namespace morph
