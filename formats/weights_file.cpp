#include "tools/deform/case_weights.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/weights/weight_fields.h"
#include "tools/deform/boundary_carry.h"
#include "tools/deform/extension_methods.h"

#include <memory>

namespace morph::tools {

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

void set_boundary_rows(const DirichletSet& held, Matrix& values)
{
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        values.row(held.vertices[i]) = held.values.row(static_cast<Eigen::Index>(i));
}

} // namespace

Weights solve_weights(const Mesh& mesh, const PlacedBoundaries& placed, const CaseFile& file)
{
    const DirichletBoundary held = dirichlet_boundary(placed.conditions);
    const Matrix& values = placed.conditions.held.values;
    const AnyExtension made = extension_method(file.deform).make({mesh, held, file.deform, values});
    return {placed.conditions.columns, std::get<std::unique_ptr<BoundaryExtension>>(made)->extend(values)};
}

Weights load_weights(const std::string& path, const Mesh& mesh, const PlacedBoundaries& placed)
{
    const MeshData data = read_mesh_data(path);
    require_same_points(path, data, mesh);
    Weights saved;
    try {
        saved = weights_from_fields(data.fields, placed.conditions.columns);
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.what());
    }
    Weights weights{saved.columns, Matrix(vertex_count(mesh), saved.values.cols())};
    for (Index v = 0; v < vertex_count(mesh); ++v)
        weights.values.row(v) = saved.values.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    set_boundary_rows(placed.conditions.held, weights.values);
    return weights;
}

} // namespace morph::tools
