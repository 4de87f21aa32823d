#include "tools/deform/case_control.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/pull.h"
#include "libmorph/geometry/nearest_points.h"

namespace morph::tools {

std::vector<Index> named_vertices(const Mesh& mesh, const std::vector<Index>& file_numbers,
                                  const Matrix& points, const std::string& place)
{
    std::vector<Index> vertex_of(static_cast<std::size_t>(mesh.numbering.file_vertices));
    for (Index v = mesh.numbering.file_vertices; v-- > 0;) // of the copies of a split vertex the first
        vertex_of[static_cast<std::size_t>(mesh.numbering.vertex[static_cast<std::size_t>(v)])] = v;
    std::vector<Index> vertices;
    for (const Index number : file_numbers) {
        if (number >= mesh.numbering.file_vertices)
            throw InputError(place + " names vertex " + std::to_string(number) + ", but the mesh has " +
                             std::to_string(mesh.numbering.file_vertices));
        vertices.push_back(vertex_of[static_cast<std::size_t>(number)]);
    }
    if (points.rows() == 0)
        return vertices;
    const std::size_t first = vertices.size();
    vertices.resize(first + static_cast<std::size_t>(points.rows()));
    const NearestPoints nearest(morph::points(mesh));
    nearest.nearest(points, 1, [&](Index i, std::span<const NearestPoints::Neighbor> found) {
        vertices[first + static_cast<std::size_t>(i)] = found.front().point;
    });
    return vertices;
}

PullOutcome pull(const Mesh& mesh, const CaseFile& file, WeightsView weights, const std::vector<Index>& held,
                 Matrix& displacements)
{
    std::vector<Index> pulled_vertices;
    Matrix wanted(0, displacements.cols());
    for (const PullEntry& entry : file.pulls) {
        const std::string place = file.path + ":" + std::to_string(entry.line) + ": [[pull]]";
        const std::vector<Index> vertices = named_vertices(mesh, entry.vertices, entry.points, place);
        pulled_vertices.insert(pulled_vertices.end(), vertices.begin(), vertices.end());
        wanted.conservativeResize(wanted.rows() + entry.displacements.rows(), Eigen::NoChange);
        wanted.bottomRows(entry.displacements.rows()) = entry.displacements.leftCols(displacements.cols());
    }
    const Pulled pulled =
        pull_points(controlled_vertices(weights, points(mesh), pulled_vertices), wanted, displacements, held);
    displacements = pulled.displacements;
    PullOutcome outcome;
    for (const Index v : pulled_vertices)
        outcome.vertices.push_back(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    outcome.residual = pulled.residual;
    outcome.rank = pulled.rank;
    return outcome;
}

} // namespace morph::tools
