#include "libmorph/pipeline/move_result.h"

#include "libmorph/mesh/builder.h"

namespace morph {

MeshData to_mesh_data(const Mesh& mesh, const MoveResult& result)
{
    if (result.mesh)
        return to_mesh_data(*result.mesh);
    MeshData data = to_mesh_data(mesh);
    for (Index v = 0; v < mesh.numbering.file_vertices; ++v) // copies of split vertices come after these
        data.points.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]) = result.positions.row(v);
    return data;
}

bool is_valid(const MoveResult& result)
{
    return result.crossings.empty() && !(result.after && result.after->inverted > 0);
}

} // namespace morph
