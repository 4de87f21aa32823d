#include "libmorph/mesh/mesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/parallel.h"

#include <unordered_set>

namespace morph {

Mesh::Mesh() = default;
Mesh::Mesh(const Mesh& other) = default;
Mesh::Mesh(Mesh&& other) noexcept(false) = default;
Mesh& Mesh::operator=(const Mesh& other) = default;
Mesh& Mesh::operator=(Mesh&& other) noexcept(false) = default;
Mesh::~Mesh() = default;

Element element_corners(const Mesh& mesh, Index face)
{
    Element corners{-1, -1, -1, -1};
    const HalfedgeHandle first = mesh.kernel.halfedge_handle(FaceHandle(face));
    HalfedgeHandle side = first;
    for (std::size_t k = 0; k == 0 || side != first; ++k) {
        corners[k] = mesh.kernel.to_vertex_handle(side).idx();
        side = mesh.kernel.next_halfedge_handle(side);
    }
    return corners;
}

std::vector<Element> element_table(const Mesh& mesh)
{
    constexpr std::size_t kRowsPerBlock = 32768;
    std::vector<Element> table(static_cast<std::size_t>(element_count(mesh)));
    parallel_for(table.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            table[f] = element_corners(mesh, static_cast<Index>(f));
    });
    return table;
}

const Marker& marker(const Mesh& mesh, const std::string& name)
{
    if (const Marker* found = find_marker(mesh.markers, name))
        return *found;
    std::vector<std::string> names;
    for (const Marker& m : mesh.markers)
        names.push_back(m.name);
    const std::string has = names.empty() ? "no markers" : joined(names);
    throw InputError("marker '" + name + "' is not in the mesh, which has " + has +
                     did_you_mean(name, names));
}

std::vector<Index> marker_vertices(const Marker& marker)
{
    std::vector<Index> vertices;
    std::unordered_set<Index> seen;
    for (const auto& edge : marker.edges)
        for (const Index v : edge)
            if (seen.insert(v).second)
                vertices.push_back(v);
    return vertices;
}

std::vector<Index> representatives(const Numbering& numbering)
{
    std::vector<Index> of_file(static_cast<std::size_t>(numbering.file_vertices), -1);
    std::vector<Index> first(numbering.vertex.size());
    for (std::size_t v = 0; v < first.size(); ++v) {
        Index& known = of_file[static_cast<std::size_t>(numbering.vertex[v])];
        if (known < 0)
            known = static_cast<Index>(v);
        first[v] = known;
    }
    return first;
}

} // namespace morph
