#include "libmorph/mesh/builder.h"

#include "libmorph/core/error.h"

#include <numeric>

namespace morph {

Mesh build_mesh(MeshData data)
{
    Mesh mesh;
    mesh.dimension = data.dimension;
    const Index n = static_cast<Index>(data.points.rows());
    for (Index i = 0; i < n; ++i)
        mesh.kernel.add_vertex({data.points(i, 0), data.points(i, 1), data.points(i, 2)});
    for (const Element& e : data.elements) {
        std::vector<VertexHandle> corners;
        for (int k = 0; k < corner_count(e); ++k)
            corners.emplace_back(e[static_cast<std::size_t>(k)]);
        if (!mesh.kernel.add_face(corners).is_valid())
            throw InputError("an element cannot be joined to its neighbours");
    }
    mesh.numbering.vertex.resize(static_cast<std::size_t>(n));
    std::iota(mesh.numbering.vertex.begin(), mesh.numbering.vertex.end(), 0);
    mesh.numbering.element.resize(data.elements.size());
    std::iota(mesh.numbering.element.begin(), mesh.numbering.element.end(), 0);
    mesh.numbering.turned.assign(data.elements.size(), false);
    mesh.numbering.file_vertices = n;
    mesh.markers = std::move(data.markers);
    mesh.fields = std::move(data.fields);
    mesh.carried = std::move(data.carried);
    return mesh;
}

MeshData to_data(const Mesh& mesh)
{
    MeshData data;
    data.dimension = mesh.dimension;
    data.points = points(mesh);
    data.elements = element_table(mesh);
    data.markers = mesh.markers;
    data.fields = mesh.fields;
    data.carried = mesh.carried;
    return data;
}

} // namespace morph
