#include "formats/gmsh/surfaces.h"

#include <map>

namespace morph {

GmshSurfaces gmsh_surfaces(const MeshData& mesh)
{
    // Sets of groups as chains, so that they take no memory for each element: 0 is the empty set.
    struct Link {
        Index rest;
        Index group;
    };
    std::vector<Link> links{{0, -1}};
    std::map<std::pair<Index, Index>, Index> known;
    std::vector<Index> set_of(mesh.elements.size(), 0);
    for (std::size_t g = 0; g < mesh.groups.size(); ++g)
        for (const Index element : mesh.groups[g].elements) {
            Index& set = set_of[static_cast<std::size_t>(element)];
            const auto [entry, is_new] =
                known.try_emplace({set, static_cast<Index>(g)}, static_cast<Index>(links.size()));
            if (is_new)
                links.push_back({set, static_cast<Index>(g)});
            set = entry->second;
        }

    const auto first_group = static_cast<Index>(mesh.markers.size()) + 1;
    const auto no_group = first_group + static_cast<Index>(mesh.groups.size());
    GmshSurfaces surfaces;
    std::vector<Index> surface_of(links.size(), -1);
    for (Index& set : set_of) {
        Index& surface = surface_of[static_cast<std::size_t>(set)];
        if (surface < 0) {
            surface = static_cast<Index>(surfaces.tags.size());
            std::vector<Index>& tags = surfaces.tags.emplace_back();
            for (Index link = set; link != 0; link = links[static_cast<std::size_t>(link)].rest)
                tags.insert(tags.begin(), first_group + links[static_cast<std::size_t>(link)].group);
            if (tags.empty() && no_group > 1)
                tags = {surfaces.no_group = no_group};
        }
        set = surface;
    }
    surfaces.of_element = std::move(set_of);
    return surfaces;
}

} // namespace morph
