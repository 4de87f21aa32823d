#include "libmorph/pipeline/remesh_job.h"

#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/folds.h"
#include "libmorph/remesh/target_size.h"

#include <numeric>

namespace morph {

namespace {

bool is_held(const Mesh& mesh, Index vertex)
{
    const VertexHandle v(vertex);
    if (mesh.kernel.is_boundary(v))
        return true;
    for (auto face = mesh.kernel.cvf_begin(v); face.is_valid(); ++face)
        if (element_corners(mesh, face->idx())[3] >= 0)
            return true;
    return false;
}

void find_cause(const Mesh& mesh, const RemeshTargets& targets, SizeCheck& check)
{
    constexpr double kShort = 0.7;
    const auto [a, b] = check.worst;
    const double part = (targets.possible[a] + targets.possible[b]) / (targets.sizes[a] + targets.sizes[b]);
    if (check.relative_length > kShort)
        return;
    if (part < kShort) {
        check.cause = ShortEdgeCause::limited;
        check.possible_part = part;
    } else if (is_held(mesh, a) && is_held(mesh, b)) {
        check.cause = ShortEdgeCause::held;
    }
}

SizeCheck check_sizes(const Mesh& mesh, const RemeshTargets& targets)
{
    const SizeConformity found = edge_conformity(mesh, targets.sizes);
    SizeCheck check;
    check.share = found.share;
    check.possible_share = size_conformity(mesh, targets.possible);
    check.worst = found.worst;
    check.relative_length = found.relative_length;
    if (found.worst[0] < 0)
        return check;
    const auto place = points(mesh);
    check.middle = (place.row(found.worst[0]) + place.row(found.worst[1])) / 2;
    find_cause(mesh, targets, check);
    return check;
}

Index isolated_vertices(const Mesh& mesh)
{
    Index count = 0;
    for (const auto vertex : mesh.kernel.vertices())
        count += mesh.kernel.is_isolated(vertex) ? 1 : 0;
    return count;
}

} // namespace

std::optional<TriangleSummary> triangle_summary(const Mesh& mesh)
{
    const std::vector<double> quality = triangle_qualities(mesh);
    std::vector<double> of_triangles;
    Index worst = -1;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const auto place = static_cast<std::size_t>(f);
        if (element_corners(mesh, f)[3] >= 0)
            continue;
        of_triangles.push_back(quality[place]);
        if (worst < 0 || quality[place] < quality[static_cast<std::size_t>(worst)])
            worst = f;
    }
    if (worst < 0)
        return std::nullopt;
    const double sum = std::accumulate(of_triangles.begin(), of_triangles.end(), 0.0);
    return TriangleSummary{quality[static_cast<std::size_t>(worst)],
                           sum / static_cast<double>(of_triangles.size()), worst};
}

RemeshCheck check_remeshing(const Mesh& old, const Mesh& mesh, const RemeshTargets& targets)
{
    RemeshCheck check;
    check.before = quality_report(old);
    check.after = quality_report(mesh);
    check.triangles_before = triangle_summary(old);
    check.triangles_after = triangle_summary(mesh);
    check.isolated_left_out = isolated_vertices(old) - isolated_vertices(mesh);
    if (check.after.triangles > 0)
        check.sizes = check_sizes(mesh, targets);
    check.distance = hausdorff_distance(old, mesh);
    if (mesh.dimension == 3)
        check.folded = folded_triangles(old, mesh);
    return check;
}

bool is_valid(const RemeshCheck& check)
{
    return check.after.inverted == 0 && check.folded.empty();
}

} // namespace morph
