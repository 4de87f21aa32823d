#include "formats/weights_file.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/weights/weight_fields.h"

namespace morph {

namespace {

void require_same_points(const std::string& path, const MeshData& data, const Mesh& mesh)
{
    if (data.points.rows() != mesh.numbering.file_vertices)
        throw InputError(path + ": has weights for " + std::to_string(data.points.rows()) +
                         " vertices, but the mesh has " + std::to_string(mesh.numbering.file_vertices));
    // Formats that keep fewer digits than a double still name the same mesh.
    const auto positions = points(mesh);
    const double tolerance = 1e-6 * (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).norm();
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const Index row = mesh.numbering.vertex[static_cast<std::size_t>(v)];
        if (!((data.points.row(row) - positions.row(v)).norm() <= tolerance))
            throw InputError(path + ": is for another mesh: its vertex " + std::to_string(row) +
                             " lies elsewhere; morph-remap carries weights from one mesh to another");
    }
}

} // namespace

Weights read_weights(const std::string& path, const Mesh& mesh,
                     const std::vector<ControlPoint>& control_points)
{
    const MeshData data = read_mesh_data(path);
    require_same_points(path, data, mesh);
    Weights saved;
    try {
        saved = weights_from_fields(data.fields, control_points);
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.what());
    }
    Weights weights{saved.columns, Matrix(vertex_count(mesh), saved.values.cols())};
    for (Index v = 0; v < vertex_count(mesh); ++v)
        weights.values.row(v) = saved.values.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    return weights;
}

} // namespace morph
