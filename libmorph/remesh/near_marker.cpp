#include "libmorph/remesh/near_marker.h"

#include "libmorph/core/parallel.h"
#include "libmorph/geometry/segment_tree.h"

#include <algorithm>

namespace morph {

namespace {

/// n marks: the vertex is within a distance of the edges.
std::vector<char> near_vertices(const Mesh& mesh, const Marker& marker, double distance)
{
    constexpr std::size_t kBlock = 4096;
    const auto place = points(mesh);
    const SegmentTree edges(place, marker.edges);
    std::vector<char> near(static_cast<std::size_t>(vertex_count(mesh)), 0);
    parallel_for(near.size(), kBlock, [&](std::size_t begin, std::size_t end) {
        SegmentTree::Nearest found;
        for (std::size_t v = begin; v < end; ++v) {
            found = edges.nearest(place.row(static_cast<Index>(v)), found.segment);
            near[v] = found.distance <= distance ? 1 : 0;
        }
    });
    return near;
}

} // namespace

std::vector<bool> elements_near(const Mesh& mesh, const Marker& marker, double distance)
{
    std::vector<bool> found(static_cast<std::size_t>(element_count(mesh)), false);
    if (marker.edges.empty())
        return found;
    const std::vector<char> near = near_vertices(mesh, marker, distance);
    const std::vector<Element> elements = element_table(mesh);
    for (std::size_t f = 0; f < elements.size(); ++f)
        found[f] = std::any_of(elements[f].begin(), elements[f].end(),
                               [&](Index v) { return v >= 0 && near[static_cast<std::size_t>(v)] != 0; });
    return found;
}

void keep_zones(const Mesh& mesh, const std::vector<KeptZone>& zones, std::vector<bool>& kept)
{
    for (const KeptZone& zone : zones) {
        const std::vector<bool> near = elements_near(mesh, marker(mesh, zone.marker), zone.distance);
        kept.resize(near.size(), false);
        for (std::size_t f = 0; f < near.size(); ++f)
            kept[f] = kept[f] || near[f];
    }
}

} // namespace morph
