#include "formats/mesh/volume_cells.h"

#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <string>

namespace morph {

namespace {

/// Local corners of the faces of each shape, counter-clockwise seen from outside; -1 ends a triangle.
const std::vector<Element>& faces_of(VolumeShape shape)
{
    static const std::array<std::vector<Element>, 4> faces{{
        {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}},
        {{0, 3, 2, 1}, {0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}},
        {{0, 2, 1, -1}, {3, 4, 5, -1}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}},
    }};
    return faces.at(static_cast<std::size_t>(shape));
}

/// A face by its sorted corners, with who has it.
struct FaceKey {
    Element corners;
    Index owner; ///< face of a cell, in the order of the cells; or ~f for the listed face f
};

Element sorted(Element face)
{
    std::sort(face.begin(), face.end());
    return face;
}

/// Makes the boundary of one volume mesh.
class Boundary {
public:
    Boundary(VolumeFile& volume, const InputBytes& file) : volume_(volume), file_(file) {}

    MeshData mesh()
    {
        list_faces();
        find_boundary();
        const MeshData& from = volume_.mesh;
        MeshData to;
        to.elements = faces_;
        to.groups = groups();
        compact(to);
        keep_markers(to);
        for (const Field& field : from.fields)
            add_field(to, field);
        to.dimension = dimension_of(to.points);
        to.sections = from.sections;
        return to;
    }

private:
    Index vertices() const { return static_cast<Index>(volume_.mesh.points.rows()); }

    void require_corners(const VolumeCell& cell, std::size_t number) const
    {
        for (int k = 0; k < corner_count(cell.shape); ++k) {
            const Index v = cell.corners[static_cast<std::size_t>(k)];
            if (v < 0 || v >= vertices())
                throw InputError(file_.path + ": cell " + std::to_string(number) + " names vertex " +
                                 std::to_string(v) + ", but the mesh has " + std::to_string(vertices()));
        }
    }

    void list_faces()
    {
        for (std::size_t c = 0; c < volume_.cells.size(); ++c) {
            const VolumeCell& cell = volume_.cells[c];
            require_corners(cell, c);
            for (const Element& local : faces_of(cell.shape)) {
                Element face{-1, -1, -1, -1};
                for (std::size_t k = 0; k < 4 && local[k] >= 0; ++k)
                    face[k] = cell.corners[static_cast<std::size_t>(local[k])];
                keys_.push_back({sorted(face), static_cast<Index>(cell_faces_.size())});
                cell_faces_.push_back(face);
            }
        }
        for (std::size_t f = 0; f < volume_.mesh.elements.size(); ++f)
            keys_.push_back({sorted(volume_.mesh.elements[f]), ~static_cast<Index>(f)});
    }

    /// Faces of one cell only, each with the listed faces of the same corners.
    void find_boundary()
    {
        std::sort(keys_.begin(), keys_.end(), [](const FaceKey& a, const FaceKey& b) {
            return a.corners != b.corners ? a.corners < b.corners : a.owner < b.owner;
        });
        std::vector<std::array<Index, 2>> boundary; // face of a cell, listed face or -1
        std::size_t inner = 0;
        for (std::size_t begin = 0, end = 0; begin < keys_.size(); begin = end) {
            while (end < keys_.size() && keys_[end].corners == keys_[begin].corners)
                ++end;
            const auto owned = std::find_if(keys_.begin() + static_cast<std::ptrdiff_t>(begin),
                                            keys_.begin() + static_cast<std::ptrdiff_t>(end),
                                            [](const FaceKey& key) { return key.owner >= 0; });
            const std::ptrdiff_t cells = keys_.begin() + static_cast<std::ptrdiff_t>(end) - owned;
            if (cells > 2)
                throw InputError(file_.path + ": the face of vertices " + text(keys_[begin].corners) +
                                 " belongs to " + std::to_string(cells) + " cells, expected at most 2");
            const bool listed = keys_[begin].owner < 0;
            if (cells == 1)
                boundary.push_back({owned->owner, listed ? ~keys_[begin].owner : -1});
            else
                inner += listed ? 1 : 0;
        }
        if (inner > 0)
            file_.warn(std::to_string(inner) + " listed face(s) inside the volume were left out");
        std::sort(boundary.begin(), boundary.end());
        for (const auto& [face, listed] : boundary) {
            faces_.push_back(cell_faces_[static_cast<std::size_t>(face)]);
            listed_.push_back(listed);
        }
    }

    static std::string text(const Element& corners)
    {
        std::string names;
        for (const Index v : corners)
            if (v >= 0)
                names += (names.empty() ? "" : ", ") + std::to_string(v);
        return names;
    }

    std::vector<ElementGroup> groups() const
    {
        std::vector<Index> place(volume_.mesh.elements.size(), -1);
        for (std::size_t f = 0; f < listed_.size(); ++f)
            if (listed_[f] >= 0)
                place[static_cast<std::size_t>(listed_[f])] = static_cast<Index>(f);
        std::vector<ElementGroup> groups;
        for (const ElementGroup& from : volume_.mesh.groups) {
            ElementGroup to{from.name, {}};
            for (const Index face : from.elements)
                if (place[static_cast<std::size_t>(face)] >= 0)
                    to.elements.push_back(place[static_cast<std::size_t>(face)]);
            if (!to.elements.empty())
                groups.push_back(std::move(to));
        }
        return groups;
    }

    /// Points of the boundary alone, in their old order.
    void compact(MeshData& to)
    {
        new_vertex_.assign(static_cast<std::size_t>(vertices()), -1);
        for (const Element& face : to.elements)
            for (const Index v : face)
                if (v >= 0)
                    new_vertex_[static_cast<std::size_t>(v)] = 0;
        for (Index v = 0; v < vertices(); ++v)
            if (new_vertex_[static_cast<std::size_t>(v)] == 0) {
                new_vertex_[static_cast<std::size_t>(v)] = static_cast<Index>(kept_.size());
                kept_.push_back(v);
            }
        for (Element& face : to.elements)
            for (Index& v : face)
                v = v < 0 ? v : new_vertex_[static_cast<std::size_t>(v)];
        to.points = volume_.mesh.points(kept_, Eigen::all);
    }

    void keep_markers(MeshData& to) const
    {
        for (const Marker& from : volume_.mesh.markers) {
            Marker marker{from.name, {}};
            for (const auto& [a, b] : from.edges) {
                const Index from_vertex = new_vertex_[static_cast<std::size_t>(a)];
                const Index to_vertex = new_vertex_[static_cast<std::size_t>(b)];
                if (from_vertex >= 0 && to_vertex >= 0)
                    marker.edges.push_back({from_vertex, to_vertex});
            }
            if (marker.edges.size() < from.edges.size())
                file_.warn("edges of marker '" + from.name + "' inside the volume were left out");
            to.markers.push_back(std::move(marker));
        }
    }

    void add_field(MeshData& to, const Field& field) const
    {
        const bool nodal = field.location == FieldLocation::vertex;
        if (!nodal && std::find(listed_.begin(), listed_.end(), -1) != listed_.end())
            return file_.warn("element field '" + field.name +
                              "' was left out: it has no values for some boundary faces");
        to.fields.push_back(
            {field.name, field.location,
             nodal ? Matrix(field.values(kept_, Eigen::all)) : Matrix(field.values(listed_, Eigen::all))});
    }

    VolumeFile& volume_;
    const InputBytes& file_;
    std::vector<Element> cell_faces_;
    std::vector<FaceKey> keys_;
    std::vector<Element> faces_; ///< of the boundary
    std::vector<Index> listed_;  ///< for each, the listed face or -1
    std::vector<Index> new_vertex_, kept_;
};

} // namespace

int corner_count(VolumeShape shape)
{
    constexpr std::array<int, 4> counts{4, 5, 6, 8};
    return counts.at(static_cast<std::size_t>(shape));
}

MeshData surface_of(VolumeFile volume, const InputBytes& file)
{
    if (volume.cells.empty())
        return std::move(volume.mesh);
    if (!file.options.surface)
        throw InputError(file.path + ": holds a volume mesh of " + std::to_string(volume.cells.size()) +
                         " cells; --surface takes its boundary");
    return Boundary(volume, file).mesh();
}

} // namespace morph
