#include "formats/cgns/grid.h"
#include "formats/cgns/point_sets.h"

#include <algorithm>

namespace morph {

namespace {

using Place = std::array<Index, 3>;

class GridSet {
public:
    GridSet(const CgnsFile& file, CgnsZone& zone, const CgnsPointSet& set)
        : file_(file), zone_(zone), set_(set), axes_(long_axes(whole_grid(zone)))
    {
    }

    void add()
    {
        if (set_.place == CgnsPlace::vertex)
            add_range(range());
        else if (axes_.size() != 2)
            leave_out_cgns_set(file_, zone_, set_,
                               "of a structured volume only ranges of vertices are supported");
        else if (set_.place == CgnsPlace::element || set_.place == face_place())
            add_cells();
        else
            add_edges();
    }

    std::vector<Index> vertices() const
    {
        std::vector<Index> vertices;
        for (const Place& at : places())
            vertices.push_back(grid_vertex(zone_, at));
        return vertices;
    }

private:
    [[noreturn]] void fail(const std::string& what) const { fail_of_cgns_set(file_, zone_, set_, what); }
    std::size_t dimensions() const { return static_cast<std::size_t>(zone_.index_dimension); }

    Place place(std::size_t point) const
    {
        Place at{0, 0, 0};
        for (std::size_t axis = 0; axis < dimensions(); ++axis) {
            const std::int64_t index = set_.points[point * dimensions() + axis];
            if (index < 1 || index > zone_.size[axis])
                fail("names index " + std::to_string(index) + ", but the zone has " +
                     std::to_string(zone_.size[axis]) + " vertices along it");
            at[axis] = static_cast<Index>(index - 1);
        }
        return at;
    }

    CgnsBox range() const
    {
        CgnsBox box{place(0), place(1)};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (box.low[axis] > box.high[axis])
                std::swap(box.low[axis], box.high[axis]);
        return box;
    }

    std::vector<Place> places() const
    {
        std::vector<Place> places;
        if (set_.range)
            for_each_point(range(), [&](const Place& at) { places.push_back(at); });
        else
            for (std::size_t p = 0; p < set_.points.size() / dimensions(); ++p)
                places.push_back(place(p));
        return places;
    }

    void add_range(const CgnsBox& box)
    {
        const std::vector<int> axes = long_axes(box);
        if (axes.size() == 2)
            return add_quads(box, axes);
        if (axes.size() != 1)
            return leave_out_cgns_set(file_, zone_, set_, "it is neither a line nor a plane of the grid");
        std::vector<std::array<Index, 2>> edges;
        for_each_cell_of(box, [&](const Place& at) {
            const Index v = grid_vertex(zone_, at);
            edges.push_back({v, v + grid_stride(zone_, axes[0])});
        });
        zone_.mesh.markers.push_back({set_.name, edges});
    }

    /// Of a volume they are listed now; otherwise they are there.
    void add_quads(const CgnsBox& box, const std::vector<int>& axes)
    {
        std::vector<Index> faces;
        for_each_cell_of(box, [&](const Place& at) {
            faces.push_back(axes_.size() == 2 ? quad(at) : static_cast<Index>(zone_.mesh.elements.size()));
            if (axes_.size() == 3)
                zone_.mesh.elements.push_back(grid_quad(zone_, at, axes[0], axes[1]));
        });
        zone_.mesh.groups.push_back({set_.name, std::move(faces)});
    }

    std::size_t axis(std::size_t i) const { return static_cast<std::size_t>(axes_[i]); }

    /// Number of the quad that begins at a vertex.
    Index quad(const Place& at) const { return at[axis(0)] + (zone_.size[axis(0)] - 1) * at[axis(1)]; }

    void require_not_last(const Place& at, std::size_t axis, const char* what) const
    {
        if (at[axis] > zone_.size[axis] - 2)
            fail(std::string("names ") + what + " behind the last");
    }

    /// What the quads of a plane are to a grid of three dimensions.
    CgnsPlace face_place() const
    {
        constexpr std::array<CgnsPlace, 3> places{CgnsPlace::i_face, CgnsPlace::j_face, CgnsPlace::k_face};
        return places[3 - axis(0) - axis(1)];
    }

    void add_cells()
    {
        std::vector<Index> faces;
        for (const Place& at : places()) {
            require_not_last(at, axis(0), "a cell");
            require_not_last(at, axis(1), "a cell");
            faces.push_back(quad(at));
        }
        zone_.mesh.groups.push_back({set_.name, each_once(std::move(faces), zone_.mesh.elements.size())});
    }

    /// Edges are named by the vertex of least indices.
    void add_edges()
    {
        const std::vector<Place> at = places();
        const std::size_t along = across(at) == axis(0) ? axis(1) : axis(0);
        std::vector<std::array<Index, 2>> edges;
        for (const Place& place : at) {
            require_not_last(place, along, "an edge");
            const Index v = grid_vertex(zone_, place);
            edges.push_back({v, v + grid_stride(zone_, static_cast<int>(along))});
        }
        zone_.mesh.markers.push_back({set_.name, edges});
    }

    /// The index that is constant along each edge: by the location, or because it is so in all.
    std::size_t across(const std::vector<Place>& places) const
    {
        if (set_.place == CgnsPlace::i_face)
            return 0;
        if (set_.place == CgnsPlace::j_face)
            return 1;
        if (set_.place == CgnsPlace::k_face)
            return 2;
        const bool constant = std::all_of(places.begin(), places.end(),
                                          [&](const Place& at) { return at[axis(0)] == places[0][axis(0)]; });
        return constant ? axis(0) : axis(1);
    }

    const CgnsFile& file_;
    CgnsZone& zone_;
    const CgnsPointSet& set_;
    std::vector<int> axes_; ///< along which the grid extends
};

} // namespace

void add_cgns_grid_set(const CgnsFile& file, CgnsZone& zone, const CgnsPointSet& set)
{
    GridSet(file, zone, set).add();
}

std::vector<Index> cgns_grid_vertices(const CgnsFile& file, CgnsZone& zone, const CgnsPointSet& set)
{
    return GridSet(file, zone, set).vertices();
}

} // namespace morph
