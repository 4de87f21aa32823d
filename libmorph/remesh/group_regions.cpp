#include "libmorph/remesh/group_regions.h"

#include "libmorph/remap/remap.h"

#include <array>
#include <cmath>
#include <map>

namespace morph {

namespace {

Index region_of(const GroupRegions& regions, Index element)
{
    return static_cast<Index>(std::lround(regions.region.values(element, 0)));
}

Marker region_borders(const Mesh& mesh, const GroupRegions& regions, const std::string& name)
{
    Marker borders{name, {}};
    for (const auto halfedge : mesh.kernel.halfedges()) {
        const auto left = mesh.kernel.face_handle(halfedge);
        const auto right = mesh.kernel.face_handle(mesh.kernel.opposite_halfedge_handle(halfedge));
        if (left.is_valid() && right.is_valid() &&
            region_of(regions, left.idx()) < region_of(regions, right.idx()))
            borders.edges.push_back({mesh.kernel.from_vertex_handle(halfedge).idx(),
                                     mesh.kernel.to_vertex_handle(halfedge).idx()});
    }
    return borders;
}

} // namespace

GroupRegions group_regions(const Mesh& mesh)
{
    std::vector<std::vector<Index>> groups_of(static_cast<std::size_t>(element_count(mesh)));
    for (std::size_t g = 0; g < mesh.groups.size(); ++g)
        for (const Index element : mesh.groups[g].elements)
            groups_of[static_cast<std::size_t>(element)].push_back(static_cast<Index>(g));
    GroupRegions regions{{"region", FieldLocation::element, Matrix(element_count(mesh), 1)}, {}};
    std::map<std::vector<Index>, Index> numbers;
    for (Index e = 0; e < element_count(mesh); ++e) {
        const auto& groups = groups_of[static_cast<std::size_t>(e)];
        const auto [entry, is_new] = numbers.try_emplace(groups, static_cast<Index>(regions.groups.size()));
        if (is_new)
            regions.groups.push_back(groups);
        regions.region.values(e, 0) = entry->second;
    }
    return regions;
}

RegionBorders::RegionBorders(Mesh& mesh, const GroupRegions& regions) : mesh_(mesh)
{
    if (regions.groups.size() < 2)
        return;
    name_ = "borders of groups";
    while (find_marker(mesh.markers, name_))
        name_ += '_';
    mesh.markers.push_back(region_borders(mesh, regions, name_));
}

RegionBorders::~RegionBorders()
{
    remove_from(mesh_);
}

void RegionBorders::remove_from(Mesh& remeshed) const
{
    if (!name_.empty())
        std::erase_if(remeshed.markers, [&](const Marker& marker) { return marker.name == name_; });
}

std::vector<ElementGroup> transferred_groups(const Locator& old, const GroupRegions& regions,
                                             const Mesh& mesh)
{
    RemapSettings settings;
    settings.outside = Outside::project;
    settings.conserve_elements = false; // the region at the centre, not a mean
    const std::array<const Field*, 1> fields{&regions.region};
    const GroupRegions carried{Remapper(old, mesh, settings).transfer(fields).front(), regions.groups};
    std::vector<ElementGroup> groups;
    for (const ElementGroup& group : old.source().groups)
        groups.push_back({group.name, {}});
    for (Index e = 0; e < element_count(mesh); ++e)
        for (const Index group : carried.groups[static_cast<std::size_t>(region_of(carried, e))])
            groups[static_cast<std::size_t>(group)].elements.push_back(e);
    return groups;
}

} // namespace morph
