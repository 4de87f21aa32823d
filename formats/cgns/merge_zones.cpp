#include "formats/cgns/merge_zones.h"

#include "formats/text/message_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <limits>

namespace morph {

namespace {

/// Where the numbers of a zone begin in the whole.
struct Offsets {
    Index vertex = 0, element = 0;
};

/// The set of that name, which is added when there is none.
template <class Set>
Set& set_named(std::vector<Set>& sets, const std::string& name)
{
    const auto found =
        std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == name; });
    return found != sets.end() ? *found : sets.emplace_back(Set{name, {}});
}

/// Those of families first, in their order, by the names that families have.
template <class Set>
void order_by_families(std::vector<Set>& sets, const std::vector<CgnsFamily>& families)
{
    std::vector<Set> ordered;
    for (const CgnsFamily& family : families) {
        const auto found =
            std::find_if(sets.begin(), sets.end(), [&](const Set& set) { return set.name == family.node; });
        if (found == sets.end())
            continue;
        found->name = family.name;
        ordered.push_back(std::move(*found));
        sets.erase(found);
    }
    std::move(sets.begin(), sets.end(), std::back_inserter(ordered));
    sets = std::move(ordered);
}

class ZoneMerger {
public:
    ZoneMerger(std::vector<CgnsZone> zones, const InputBytes& input) : zones_(std::move(zones)), input_(input)
    {
    }

    VolumeFile merge(const std::vector<CgnsFamily>& families)
    {
        set_offsets();
        for (std::size_t z = 0; z < zones_.size(); ++z)
            add_sets(z);
        for (const CgnsFamily& family : families)
            if (family.no_edges)
                set_named(whole_.mesh.markers, family.node);
        order_by_families(whole_.mesh.markers, families);
        order_by_families(whole_.mesh.groups, families);
        if (zones_.size() == 1)
            take_only_zone();
        else
            add_zones();
        whole_.mesh.dimension = dimension_of(whole_.mesh.points);
        return std::move(whole_);
    }

private:
    void set_offsets()
    {
        std::int64_t vertices = 0;
        std::int64_t elements = 0;
        for (const CgnsZone& zone : zones_) {
            offsets_.push_back({static_cast<Index>(vertices), static_cast<Index>(elements)});
            vertices += zone.mesh.points.rows();
            elements += static_cast<std::int64_t>(zone.mesh.elements.size());
            if (std::max(vertices, elements) > std::numeric_limits<Index>::max())
                throw InputError(input_.path + ": its zones have more than " +
                                 std::to_string(std::numeric_limits<Index>::max()) + " vertices or elements");
        }
    }

    void add_sets(std::size_t z)
    {
        for (const Marker& marker : zones_[z].mesh.markers) {
            auto& edges = set_named(whole_.mesh.markers, marker.name).edges;
            for (const auto& [a, b] : marker.edges)
                edges.push_back({a + offsets_[z].vertex, b + offsets_[z].vertex});
        }
        for (const ElementGroup& group : zones_[z].mesh.groups)
            add_to_group(group.name, group.elements, offsets_[z].element);
    }

    /// Elements that are in the group already (several subregions of one family may share them) are not
    /// added again.
    void add_to_group(const std::string& name, const std::vector<Index>& elements, Index offset)
    {
        auto& all = set_named(whole_.mesh.groups, name).elements;
        std::vector<Index> known = all;
        std::sort(known.begin(), known.end());
        for (const Index e : elements)
            if (!std::binary_search(known.begin(), known.end(), e + offset))
                all.push_back(e + offset);
    }

    void take_only_zone()
    {
        MeshData& from = zones_[0].mesh;
        whole_.mesh.points = std::move(from.points);
        whole_.mesh.elements = std::move(from.elements);
        whole_.mesh.fields = std::move(from.fields);
        whole_.cells = std::move(zones_[0].cells);
    }

    void add_zones()
    {
        Eigen::Index vertices = 0;
        for (const CgnsZone& zone : zones_)
            vertices += zone.mesh.points.rows();
        whole_.mesh.points.resize(vertices, 3);
        for (std::size_t z = 0; z < zones_.size(); ++z)
            add_zone(z);
        for (const CgnsZone& zone : zones_)
            for (const Field& field : zone.mesh.fields)
                if (!find_field(whole_.mesh.fields, field.name, field.location))
                    add_field(field);
    }

    void add_zone(std::size_t z)
    {
        CgnsZone& zone = zones_[z];
        const Index offset = offsets_[z].vertex;
        whole_.mesh.points.middleRows(offset, zone.mesh.points.rows()) = zone.mesh.points;
        std::vector<Index> numbers;
        for (Element element : zone.mesh.elements) {
            numbers.push_back(static_cast<Index>(numbers.size()));
            for (Index& v : element)
                v = v < 0 ? v : v + offset;
            whole_.mesh.elements.push_back(element);
        }
        for (VolumeCell cell : zone.cells) {
            for (Index& v : cell.corners)
                v += offset;
            whole_.cells.push_back(cell);
        }
        if (!numbers.empty())
            add_to_group(zone.name, numbers, offsets_[z].element);
    }

    void add_field(const Field& like)
    {
        const bool nodal = like.location == FieldLocation::vertex;
        Field whole{
            like.name, like.location,
            Matrix(nodal ? whole_.mesh.points.rows() : static_cast<Eigen::Index>(whole_.mesh.elements.size()),
                   like.values.cols())};
        for (std::size_t z = 0; z < zones_.size(); ++z) {
            const MeshData& mesh = zones_[z].mesh;
            const Field* part = find_field(mesh.fields, like.name, like.location);
            const bool needed = nodal || !mesh.elements.empty();
            if (needed && (!part || part->values.cols() != whole.values.cols()))
                return warn_once("field " + quoted_text(like.name) + " was left out: " + zones_[z].title() +
                                 " does not have it");
            if (needed)
                whole.values.middleRows(nodal ? offsets_[z].vertex : offsets_[z].element,
                                        part->values.rows()) = part->values;
        }
        whole_.mesh.fields.push_back(std::move(whole));
    }

    void warn_once(const std::string& what)
    {
        if (std::find(warned_.begin(), warned_.end(), what) == warned_.end())
            input_.warn(what);
        warned_.push_back(what);
    }

    std::vector<CgnsZone> zones_;
    const InputBytes& input_;
    std::vector<Offsets> offsets_;
    std::vector<std::string> warned_;
    VolumeFile whole_;
};

} // namespace

VolumeFile merge_cgns_zones(std::vector<CgnsZone> zones, const std::vector<CgnsFamily>& families,
                            const InputBytes& input)
{
    return ZoneMerger(std::move(zones), input).merge(families);
}

} // namespace morph
