#include "formats/mesh/marker_elements.h"

namespace morph {

std::vector<Index> elements_at_markers(const MeshData& mesh)
{
    std::vector<Index> element_at(static_cast<std::size_t>(mesh.points.rows()), 0);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (int i = 0; i < corner_count(mesh.elements[e]); ++i)
            element_at[static_cast<std::size_t>(mesh.elements[e][static_cast<std::size_t>(i)])] =
                static_cast<Index>(e);
    std::vector<Index> found;
    for (const Marker& marker : mesh.markers)
        for (const auto& edge : marker.edges)
            found.push_back(element_at[static_cast<std::size_t>(edge[0])]);
    return found;
}

} // namespace morph
