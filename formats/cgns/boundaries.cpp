#include "formats/cgns/point_sets.h"

#include <algorithm>
#include <optional>

namespace morph {

namespace {

/// Edges of one face only, in the direction of the face.
std::vector<std::array<Index, 2>> boundary_edges(const std::vector<Element>& faces)
{
    struct Side {
        std::array<Index, 2> sorted, edge;
        std::size_t place;
    };
    std::vector<Side> sides;
    for (const Element& face : faces)
        for (int k = 0, n = corner_count(face); k < n; ++k) {
            const Index a = face[static_cast<std::size_t>(k)];
            const Index b = face[static_cast<std::size_t>((k + 1) % n)];
            sides.push_back({{std::min(a, b), std::max(a, b)}, {a, b}, sides.size()});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.sorted < b.sorted; });
    std::vector<Side> single;
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && sides[end].sorted == sides[begin].sorted)
            ++end;
        if (end - begin == 1)
            single.push_back(sides[begin]);
    }
    std::sort(single.begin(), single.end(), [](const Side& a, const Side& b) { return a.place < b.place; });
    std::vector<std::array<Index, 2>> edges;
    edges.reserve(single.size());
    for (const Side& side : single)
        edges.push_back(side.edge);
    return edges;
}

class BoundaryReader {
public:
    BoundaryReader(const CgnsFile& file, CgnsZone& zone)
        : file_(file), zone_(zone), edge_used_(zone.edges.size(), false)
    {
    }

    void read()
    {
        for (const CgnsPointSet& set : read_cgns_point_sets(file_, zone_))
            if (zone_.structured() && (set.range || set.place != CgnsPlace::vertex))
                add_cgns_grid_set(file_, zone_, set);
            else if (set.place == CgnsPlace::vertex)
                add_within(set, vertices_of(set));
            else
                add_elements(set);
        add_sections();
    }

private:
    void leave_out(const CgnsPointSet& set, const std::string& why) const
    {
        leave_out_cgns_set(file_, zone_, set, why);
    }
    [[noreturn]] void fail(const CgnsPointSet& set, const std::string& what) const
    {
        fail_of_cgns_set(file_, zone_, set, what);
    }
    void add_edges(const std::string& name, const std::vector<std::array<Index, 2>>& edges)
    {
        zone_.mesh.markers.push_back({name, edges});
    }
    void add_faces(const std::string& name, std::vector<Index> faces)
    {
        zone_.mesh.groups.push_back({name, std::move(faces)});
    }

    /// Calls visit(number) for each point of an unstructured zone; @p largest is the last there is.
    template <class Visit>
    void for_each_number(const CgnsPointSet& set, std::int64_t largest, const Visit& visit) const
    {
        for (const std::int64_t point : set.points)
            if (point < 1 || point > largest)
                fail(set, "names " + std::to_string(point) + ", but the numbers end at " +
                              std::to_string(largest));
        if (set.range)
            for (std::int64_t number = set.points[0]; number <= set.points[1]; ++number)
                visit(number);
        else
            for (const std::int64_t point : set.points)
                visit(point);
    }

    const CgnsItem* item(std::int64_t number) const
    {
        const auto behind = std::upper_bound(
            zone_.sections.begin(), zone_.sections.end(), number,
            [](std::int64_t wanted, const CgnsSection& section) { return wanted < section.first; });
        if (behind == zone_.sections.begin())
            return nullptr;
        const CgnsSection& section = *(behind - 1);
        const auto place = static_cast<std::size_t>(number - section.first);
        return place < section.items.size() ? &section.items[place] : nullptr;
    }

    void add_elements(const CgnsPointSet& set)
    {
        std::vector<std::array<Index, 2>> edges;
        std::vector<Index> faces;
        std::size_t others = 0;
        const CgnsSection* last = zone_.sections.empty() ? nullptr : &zone_.sections.back();
        const std::int64_t largest =
            last ? last->first + static_cast<std::int64_t>(last->items.size()) - 1 : 0;
        for_each_number(set, largest, [&](std::int64_t number) {
            const CgnsItem* found = item(number);
            if (found && found->kind == CgnsKind::edge) {
                edge_used_[static_cast<std::size_t>(found->index)] = true;
                edges.push_back(zone_.edges[static_cast<std::size_t>(found->index)]);
            } else if (found && found->kind == CgnsKind::face) {
                faces.push_back(found->index);
            } else {
                ++others;
            }
        });
        if (others > 0)
            leave_out(set, std::to_string(others) + " of its elements are neither edges nor faces that the "
                                                    "file lists");
        if (!edges.empty() || (faces.empty() && others == 0))
            add_edges(set.name, edges);
        if (!faces.empty())
            add_faces(set.name, each_once(std::move(faces), zone_.mesh.elements.size()));
    }

    std::vector<bool> vertices_of(const CgnsPointSet& set)
    {
        std::vector<bool> chosen(static_cast<std::size_t>(zone_.vertex_count()), false);
        if (zone_.structured()) {
            for (const Index v : cgns_grid_vertices(file_, zone_, set))
                chosen[static_cast<std::size_t>(v)] = true;
            return chosen;
        }
        for_each_number(set, zone_.vertex_count(),
                        [&](std::int64_t number) { chosen[static_cast<std::size_t>(number - 1)] = true; });
        return chosen;
    }

    /// The boundary is given by vertices: of a volume mesh the listed faces between them, otherwise the
    /// edges, those listed or else those of one face only.
    void add_within(const CgnsPointSet& set, const std::vector<bool>& chosen)
    {
        const auto within = [&](Index v) { return v < 0 || chosen[static_cast<std::size_t>(v)]; };
        if (!zone_.cells.empty()) {
            std::vector<Index> faces;
            for (std::size_t f = 0; f < zone_.mesh.elements.size(); ++f)
                if (std::all_of(zone_.mesh.elements[f].begin(), zone_.mesh.elements[f].end(), within))
                    faces.push_back(static_cast<Index>(f));
            if (faces.empty())
                return leave_out(set, "the file lists no faces between its vertices");
            return add_faces(set.name, std::move(faces));
        }
        std::vector<std::array<Index, 2>> edges;
        for (std::size_t e = 0; e < zone_.edges.size(); ++e)
            if (within(zone_.edges[e][0]) && within(zone_.edges[e][1])) {
                edges.push_back(zone_.edges[e]);
                edge_used_[e] = true;
            }
        if (edges.empty() && !boundary_)
            boundary_ = boundary_edges(zone_.mesh.elements);
        if (edges.empty())
            for (const auto& edge : *boundary_)
                if (within(edge[0]) && within(edge[1]))
                    edges.push_back(edge);
        add_edges(set.name, edges);
    }

    /// Listed edges of no boundary condition are a marker by the name of their section; so are faces a
    /// group, where they come in several sections.
    void add_sections()
    {
        std::vector<ElementGroup> groups;
        for (const CgnsSection& section : zone_.sections) {
            std::vector<std::array<Index, 2>> edges;
            std::vector<Index> faces;
            for (const CgnsItem& item : section.items)
                if (item.kind == CgnsKind::edge && !edge_used_[static_cast<std::size_t>(item.index)])
                    edges.push_back(zone_.edges[static_cast<std::size_t>(item.index)]);
                else if (item.kind == CgnsKind::face)
                    faces.push_back(item.index);
            if (!edges.empty())
                add_edges(section.name, edges);
            if (!faces.empty())
                groups.push_back({section.name, std::move(faces)});
        }
        std::erase_if(groups, [&](const ElementGroup& group) {
            return std::any_of(zone_.mesh.groups.begin(), zone_.mesh.groups.end(),
                               [&](const ElementGroup& known) { return known.elements == group.elements; });
        });
        if (groups.size() > 1)
            zone_.mesh.groups.insert(zone_.mesh.groups.end(), groups.begin(), groups.end());
    }

    const CgnsFile& file_;
    CgnsZone& zone_;
    std::vector<bool> edge_used_; ///< by a boundary condition
    std::optional<std::vector<std::array<Index, 2>>>
        boundary_; ///< edges of one face, once they are asked for
};

} // namespace

void read_cgns_boundaries(const CgnsFile& file, CgnsZone& zone)
{
    BoundaryReader(file, zone).read();
}

} // namespace morph
