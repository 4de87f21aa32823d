#include "libmorph/mesh/mesh.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <unordered_set>

namespace morph {

Element element_corners(const Mesh& mesh, Index face)
{
    Element corners{-1, -1, -1, -1};
    std::size_t count = 0;
    for (const VertexHandle v : mesh.kernel.fv_range(FaceHandle(face)))
        corners[count++] = v.idx();
    return corners;
}

std::vector<Element> element_table(const Mesh& mesh)
{
    std::vector<Element> table(static_cast<std::size_t>(element_count(mesh)));
    for (std::size_t f = 0; f < table.size(); ++f)
        table[f] = element_corners(mesh, static_cast<Index>(f));
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
    throw InputError("marker '" + name + "' is not in the mesh, which has " + has + did_you_mean(name, names));
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

} // namespace morph
