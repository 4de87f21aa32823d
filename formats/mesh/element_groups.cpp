#include "formats/mesh/element_groups.h"

#include <algorithm>

namespace morph {

std::vector<std::vector<Index>> group_columns(const MeshData& mesh)
{
    std::vector<std::vector<Index>> columns;
    std::vector<std::size_t> used(mesh.elements.size(), 0);
    for (std::size_t g = 0; g < mesh.groups.size(); ++g)
        for (const Index element : mesh.groups[g].elements) {
            const auto e = static_cast<std::size_t>(element);
            if (used[e] == columns.size())
                columns.emplace_back(mesh.elements.size(), 0);
            columns[used[e]++][e] = static_cast<Index>(g + 1);
        }
    return columns;
}

std::vector<std::string> overlap_losses(const MeshData& mesh)
{
    std::vector<std::string> losses;
    std::vector<bool> taken(mesh.elements.size(), false);
    for (const ElementGroup& group : mesh.groups) {
        std::size_t shared = 0;
        for (const Index element : group.elements) {
            shared += taken[static_cast<std::size_t>(element)] ? 1 : 0;
            taken[static_cast<std::size_t>(element)] = true;
        }
        if (shared > 0)
            losses.push_back(std::to_string(shared) + " element(s) of group '" + group.name +
                             "', which are in another group too");
    }
    return losses;
}

} // namespace morph
