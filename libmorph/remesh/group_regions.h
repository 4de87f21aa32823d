#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remap/locate.h"

#include <functional>
#include <vector>

namespace morph::tools {

/// The elements of a mesh by the combination of groups they are in.
struct GroupRegions {
    Field region;                           ///< of elements: number of its combination
    std::vector<std::vector<Index>> groups; ///< of each combination, ascending; the first that occurs is 0
};

GroupRegions group_regions(const Mesh& mesh);

/// The edges between elements of different regions, each with the region of the lower number on its left: a
/// marker of them makes remeshing keep these lines.
Marker region_borders(const Mesh& mesh, const GroupRegions& regions, const std::string& name);

/// What @p remake makes of a mesh, with edges along every border between its groups: while it works they are
/// a marker.
Mesh remesh_with_region_borders(Mesh& mesh, const GroupRegions& regions,
                                const std::function<Mesh(const Mesh&)>& remake);

/// The groups of a remade mesh, with the names of the old ones: each element is in those of the old element
/// at its centre.
std::vector<ElementGroup> transferred_groups(const Locator& old, const GroupRegions& regions,
                                             const Mesh& mesh);

} // namespace morph::tools
