#include "libmorph/pipeline/detail/pull_setup.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/pull.h"
#include "libmorph/geometry/nearest_points.h"

namespace morph {

std::vector<Index> named_vertices(const Mesh& mesh, const std::vector<Index>& file_numbers,
                                  const Matrix& points, const std::string& what)
{
    std::vector<Index> vertex_of(static_cast<std::size_t>(mesh.numbering.file_vertices));
    for (Index v = mesh.numbering.file_vertices; v-- > 0;) // of the copies of a split vertex the first
        vertex_of[static_cast<std::size_t>(mesh.numbering.vertex[static_cast<std::size_t>(v)])] = v;
    std::vector<Index> vertices;
    for (const Index number : file_numbers) {
        if (number < 0 || number >= mesh.numbering.file_vertices)
            throw InputError(what + " names vertex " + std::to_string(number) + ", but the mesh has " +
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

PullOutcome pull(const Mesh& mesh, const std::vector<PullSettings>& pulls, const PreparedMotion& motion,
                 Matrix& displacements)
{
    std::vector<Index> pulled_vertices;
    Matrix target(0, displacements.cols());
    for (const PullSettings& entry : pulls) {
        const std::vector<Index> vertices =
            named_vertices(mesh, entry.vertices, entry.points, entry.where + "[[pull]]");
        pulled_vertices.insert(pulled_vertices.end(), vertices.begin(), vertices.end());
        if (entry.displacements.cols() < target.cols())
            throw InputError(entry.where + "[[pull]] displacements need z for a surface in space");
        target.conservativeResize(target.rows() + entry.displacements.rows(), Eigen::NoChange);
        target.bottomRows(entry.displacements.rows()) = entry.displacements.leftCols(target.cols());
    }
    const Pulled pulled = pull_points(controlled_vertices(motion.rows(), points(mesh), pulled_vertices),
                                      target, displacements, motion.held());
    displacements = pulled.displacements;
    PullOutcome outcome;
    for (const Index v : pulled_vertices)
        outcome.vertices.push_back(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    outcome.residual = pulled.residual;
    outcome.rank = pulled.rank;
    return outcome;
}

} // namespace morph
