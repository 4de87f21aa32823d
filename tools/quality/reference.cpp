#include "tools/quality/reference.h"

#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"

#include <algorithm>

namespace morph::tools {

namespace {

std::string counts(const MeshData& data)
{
    return std::to_string(data.points.rows()) + " vertices and " + std::to_string(data.elements.size()) +
           " elements";
}

void require_same_mesh(const std::string& reference_path, const MeshData& reference, const std::string& path,
                       const MeshData& data)
{
    if (data.points.rows() != reference.points.rows() || data.elements.size() != reference.elements.size())
        throw InputError(reference_path + " has " + counts(reference) + ", but " + path + " has " +
                         counts(data) + "; the reference must be the same mesh before it was moved");
    if (data.dimension != reference.dimension)
        throw InputError(reference_path + " and " + path +
                         " are not the same mesh: one is planar, the other a surface in space");
    const auto other =
        std::mismatch(data.elements.begin(), data.elements.end(), reference.elements.begin()).first;
    if (other != data.elements.end())
        throw InputError(reference_path + " and " + path + " are not the same mesh: element " +
                         std::to_string(other - data.elements.begin()) + " has other vertices");
}

} // namespace

Points reference_points(const std::string& reference, const std::string& from, const Mesh& mesh,
                        const std::string& path)
{
    const MeshData data = read_mesh_data(reference, from);
    require_same_mesh(reference, data, path, to_mesh_data(mesh));
    Points ordered(vertex_count(mesh), 3);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        ordered.row(v) = data.points.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    return ordered;
}

} // namespace morph::tools
