#include "formats/tecplot/mesh.h"

#include "formats/mesh/volume_cells.h"
#include "formats/tecplot/nodes.h"
#include "formats/tecplot/variables.h"
#include "formats/text/message_text.h"
#include "formats/text/surface_text.h"
#include "formats/text/text_scanner.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <set>

namespace morph {

namespace {

class MeshMaker {
public:
    MeshMaker(TecplotFile file, const InputBytes& input)
        : file_(std::move(file)), input_(input), xyz_(tecplot_coordinates(file_.variables))
    {
    }

    MeshData make()
    {
        require_nodal_coordinates();
        choose_zones();
        number_nodes();
        for (const std::size_t z : chosen_)
            add_elements(file_.zones[z], z);
        volume_.mesh.fields = tecplot_fields(file_, chosen_, nodes_, xyz_, input_);
        add_markers();
        add_groups();
        volume_.mesh.points = nodes_.take_points();
        volume_.mesh.dimension = dimension_of(volume_.mesh.points);
        return surface_of(std::move(volume_), input_);
    }

private:
    static bool is_line(const TecplotZone& zone) { return zone.cells == TecplotCells::lines; }
    static bool is_volume(const TecplotZone& zone)
    {
        return zone.cells == TecplotCells::tetrahedra || zone.cells == TecplotCells::bricks;
    }

    std::string called(std::size_t z) const
    {
        const std::string& name = file_.zones[z].name;
        return std::to_string(z + 1) + (name.empty() ? "" : " " + quoted_text(name));
    }

    void require_nodal_coordinates() const
    {
        for (std::size_t z = 0; z < file_.zones.size(); ++z)
            for (const std::size_t v : xyz_)
                if (v < file_.variables.size() && file_.zones[z].variables[v].centred)
                    throw InputError(input_.path + ": the coordinate " + quoted_text(file_.variables[v]) +
                                     " is at cells in zone " + called(z) + ", but must be at nodes");
    }

    void choose_zones()
    {
        std::vector<std::size_t> all;
        for (std::size_t z = 0; z < file_.zones.size(); ++z)
            if (!is_line(file_.zones[z]))
                all.push_back(z);
        if (all.empty())
            throw InputError(input_.path +
                             ": has zones of lines only; a mesh needs a zone of triangles or quads");
        for (const std::size_t z : all)
            if (input_.options.zone.empty() ? !is_further_state(z) : is_asked_for(z))
                chosen_.push_back(z);
        if (chosen_.empty())
            fail_no_zone(all);
    }

    bool is_asked_for(std::size_t z) const
    {
        const std::string& wanted = input_.options.zone;
        return wanted == std::to_string(z + 1) || wanted == file_.zones[z].name;
    }

    /// Of a zone that was chosen already.
    bool is_further_state(std::size_t z) const
    {
        const TecplotZone& zone = file_.zones[z];
        for (const std::size_t before : chosen_) {
            const TecplotZone& other = file_.zones[before];
            const bool same_place = zone.variables[xyz_[0]].values == other.variables[xyz_[0]].values &&
                                    zone.variables[xyz_[1]].values == other.variables[xyz_[1]].values;
            const bool same_cells = zone.connectivity_of == static_cast<int>(before);
            const bool later = zone.strand > 0 && zone.strand == other.strand && zone.time != other.time;
            if (!later && !(same_place && same_cells))
                continue;
            input_.warn("zone " + called(z) + " is a further state of zone " + called(before) +
                        " and was left out");
            return true;
        }
        return false;
    }

    [[noreturn]] void fail_no_zone(const std::vector<std::size_t>& all) const
    {
        std::string names;
        for (const std::size_t z : all)
            names += (names.empty() ? "" : ", ") + called(z);
        throw InputError(input_.path + ": has no zone " + quoted_text(input_.options.zone) +
                         " of elements, but " + names);
    }

    void number_nodes()
    {
        for (const std::size_t z : chosen_)
            nodes_.add_zone(z, file_.zones[z], xyz_);
        if (nodes_.joined() > 0)
            input_.warn(std::to_string(nodes_.joined()) +
                        " node(s) of several zones at the same place were joined; their values are those of "
                        "the first zone");
    }

    const std::vector<Index>& corners_of(const TecplotZone& zone) const
    {
        return zone.connectivity_of < 0 ? zone.corners
                                        : file_.zones[static_cast<std::size_t>(zone.connectivity_of)].corners;
    }

    void add_elements(const TecplotZone& zone, std::size_t z)
    {
        const std::vector<Index>& corners = corners_of(zone);
        const TecplotNumbering& numbering = nodes_.numbering(z);
        const auto count = static_cast<std::size_t>(corner_count(zone.cells));
        for (std::size_t e = 0; e < static_cast<std::size_t>(zone.elements); ++e) {
            std::array<Index, 8> cell{};
            for (std::size_t k = 0; k < count; ++k)
                cell[k] = numbering.vertex(corners[e * count + k]);
            if (is_volume(zone))
                volume_.cells.push_back(volume_cell(cell, z, e));
            else
                volume_.mesh.elements.push_back(element(cell, z, e));
        }
        if (chosen_.size() > 1 && !is_volume(zone))
            add_zone_group(zone);
    }

    void add_zone_group(const TecplotZone& zone)
    {
        const auto end = static_cast<Index>(volume_.mesh.elements.size());
        ElementGroup group{zone.name, {}};
        for (Index e = end - zone.elements; e < end; ++e)
            group.elements.push_back(e);
        volume_.mesh.groups.push_back(std::move(group));
    }

    Element element(std::array<Index, 8>& cell, std::size_t z, std::size_t e) const
    {
        if (file_.zones[z].cells == TecplotCells::triangles)
            return {cell[0], cell[1], cell[2], -1};
        auto* end = std::unique(cell.begin(), cell.begin() + 4);
        if (cell.front() == *(end - 1))
            --end;
        if (end - cell.begin() < 3)
            fail_degenerate(z, e);
        return {cell[0], cell[1], cell[2], end - cell.begin() == 4 ? cell[3] : -1};
    }

    /// A brick with corners named twice, as Tecplot stores prisms (3, 3 and 7, 7) and pyramids (5 to 8).
    VolumeCell volume_cell(const std::array<Index, 8>& c, std::size_t z, std::size_t e) const
    {
        if (file_.zones[z].cells == TecplotCells::tetrahedra)
            return {VolumeShape::tetrahedron, {c[0], c[1], c[2], c[3]}};
        const bool apex = c[4] == c[5] && c[5] == c[6] && c[6] == c[7];
        if (apex && c[2] == c[3])
            return {VolumeShape::tetrahedron, {c[0], c[1], c[2], c[4]}};
        if (apex)
            return {VolumeShape::pyramid, {c[0], c[1], c[2], c[3], c[4]}};
        if (c[2] == c[3] && c[6] == c[7])
            return {VolumeShape::prism, {c[0], c[1], c[2], c[4], c[5], c[6]}};
        const std::set<Index> distinct(c.begin(), c.end());
        if (distinct.size() < 8)
            fail_degenerate(z, e);
        return {VolumeShape::hexahedron, c};
    }

    [[noreturn]] void fail_degenerate(std::size_t z, std::size_t e) const
    {
        TextScanner(input_.path, input_.bytes)
            .fail_at(file_.zones[z].position, "element " + std::to_string(e + 1) + " of zone " + called(z) +
                                                  " repeats nodes so that no supported cell is left");
    }

    void add_markers()
    {
        for (std::size_t z = 0; z < file_.zones.size(); ++z)
            if (is_line(file_.zones[z]))
                add_marker(z);
    }

    void add_marker(std::size_t z)
    {
        const TecplotZone& zone = file_.zones[z];
        const std::vector<Index>& corners = corners_of(zone);
        const std::vector<Index> vertices = nodes_.vertices_at(zone, xyz_);
        Marker marker{zone.name, {}};
        for (std::size_t e = 0; e < static_cast<std::size_t>(zone.elements); ++e) {
            const Index from = vertices[static_cast<std::size_t>(corners[2 * e])];
            const Index to = vertices[static_cast<std::size_t>(corners[2 * e + 1])];
            if (from >= 0 && to >= 0)
                marker.edges.push_back({from, to});
        }
        const std::size_t lost = static_cast<std::size_t>(zone.elements) - marker.edges.size();
        const bool elsewhere = marker.edges.empty() && lost > 0;
        if (lost > 0 && input_.options.zone.empty())
            input_.warn(std::to_string(lost) + " line(s) of zone " + called(z) +
                        " do not end at vertices of elements and were left out");
        if (!elsewhere)
            volume_.mesh.markers.push_back(std::move(marker));
    }

    void add_groups()
    {
        const auto elements = static_cast<Index>(volume_.mesh.elements.size());
        if (!input_.options.zone.empty())
            return;
        for (ElementGroup& group : file_.groups) {
            for (const Index e : group.elements)
                if (e >= elements)
                    throw InputError(input_.path + ": group " + quoted_text(group.name) + " names element " +
                                     std::to_string(e + 1) + ", but the mesh has " +
                                     std::to_string(elements));
            volume_.mesh.groups.push_back(std::move(group));
        }
    }

    TecplotFile file_;
    const InputBytes& input_;
    TecplotCoordinates xyz_;
    std::vector<std::size_t> chosen_; ///< zones of elements
    TecplotNodes nodes_;
    VolumeFile volume_;
};

} // namespace

MeshData tecplot_mesh(TecplotFile file, const InputBytes& input)
{
    return MeshMaker(std::move(file), input).make();
}

} // namespace morph
