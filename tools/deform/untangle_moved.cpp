#include "tools/deform/untangle_moved.h"

namespace morph::tools {

namespace {

std::vector<Index> held_vertices(const Mesh& mesh)
{
    std::vector<bool> held(static_cast<std::size_t>(vertex_count(mesh)), false);
    for (const auto vertex : mesh.kernel.vertices())
        held[static_cast<std::size_t>(vertex.idx())] = mesh.kernel.is_boundary(vertex);
    for (const Marker& marker : mesh.markers)
        for (const Index v : marker_vertices(marker))
            held[static_cast<std::size_t>(v)] = true;
    std::vector<Index> vertices;
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (held[static_cast<std::size_t>(v)])
            vertices.push_back(v);
    return vertices;
}

} // namespace

UntangleResult untangle_moved(Mesh& mesh, const PositionsView& before)
{
    return untangle(mesh, before, held_vertices(mesh), points(mesh));
}

} // namespace morph::tools
