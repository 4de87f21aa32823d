#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remap/locate.h"

#include <string>
#include <vector>

namespace morph {

/// The elements of a mesh by the combination of groups they are in.
struct GroupRegions {
    Field region;                           ///< of elements: number of its combination
    std::vector<std::vector<Index>> groups; ///< of each combination, ascending; the first that occurs is 0
};

GroupRegions group_regions(const Mesh& mesh);

/// While it exists, a mesh has a marker of the edges between elements of different regions, each with the region
/// of the lower number on its left: so remeshing keeps edges along every border between groups.
class RegionBorders {
public:
    /// @param mesh  gets the marker, where there are two regions or more; it must outlive this
    RegionBorders(Mesh& mesh, const GroupRegions& regions);
    ~RegionBorders();
    RegionBorders(const RegionBorders&) = delete;
    RegionBorders& operator=(const RegionBorders&) = delete;

    /// Take the marker off a mesh that the first one was remeshed to.
    void remove_from(Mesh& remeshed) const;

private:
    Mesh& mesh_;
    std::string name_; ///< of the marker; empty without one
};

/// The groups of a remeshed mesh, with the names of the old ones: each element is in those of the old element
/// at its centre.
std::vector<ElementGroup> transferred_groups(const Locator& old, const GroupRegions& regions,
                                             const Mesh& mesh);

} // namespace morph
