#include "formats/vtk_cells.h"

#include "formats/cell_types.h"
#include "formats/surface.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace morph {

namespace {

constexpr std::uint8_t kPolyVertex = 2;
constexpr std::uint8_t kPolyLine = 4;
constexpr std::uint8_t kPolygon = 7;
constexpr std::uint8_t kPixel = 8;

/// Turns the cells of one grid into elements and markers.
class CellReader {
public:
    CellReader(VtkGrid& grid, const std::string& path) : grid_(grid), path_(path) {}

    MeshData mesh()
    {
        require_sizes();
        MeshData mesh;
        mesh.elements.reserve(grid_.types.size());
        for (std::size_t cell = 0; cell < grid_.types.size(); ++cell)
            add_cell(mesh, cell);
        add_markers(mesh);
        add_fields(mesh);
        mesh.dimension = dimension_of(grid_.points);
        mesh.points = std::move(grid_.points);
        return mesh;
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw InputError(path_ + ": " + what); }

    static std::string cell_text(std::size_t cell) { return "cell " + std::to_string(cell); }

    std::int64_t begin_of(std::size_t cell) const { return cell == 0 ? 0 : grid_.ends[cell - 1]; }

    Index corner(std::int64_t position) const { return grid_.corners[static_cast<std::size_t>(position)]; }

    void require_sizes() const
    {
        if (grid_.ends.size() != grid_.types.size())
            fail("there are " + std::to_string(grid_.types.size()) + " cell types, but " +
                 std::to_string(grid_.ends.size()) + " cells");
        for (std::size_t cell = 0; cell < grid_.ends.size(); ++cell)
            if (grid_.ends[cell] < begin_of(cell) ||
                grid_.ends[cell] > static_cast<std::int64_t>(grid_.corners.size()))
                fail(cell_text(cell) + " has corners " + std::to_string(begin_of(cell)) + " to " +
                     std::to_string(grid_.ends[cell]) + " of the connectivity, which has " +
                     std::to_string(grid_.corners.size()));
        for (Index v = 0; v < grid_.points.rows(); ++v)
            if (!grid_.points.row(v).allFinite())
                fail("point " + std::to_string(v) + " has a coordinate that is not finite");
    }

    /// Every corner of the cell is a point.
    void require_corners(std::size_t cell) const
    {
        for (std::int64_t i = begin_of(cell); i < grid_.ends[cell]; ++i)
            if (corner(i) < 0 || corner(i) >= grid_.points.rows())
                fail(cell_text(cell) + " names point " +
                     (corner(i) < 0 ? "that is no index" : std::to_string(corner(i))) +
                     ", but the mesh has " + std::to_string(grid_.points.rows()));
    }

    void require_count(std::size_t cell, std::int64_t fewest, std::int64_t most) const
    {
        const std::int64_t count = grid_.ends[cell] - begin_of(cell);
        if (count < fewest || count > most)
            fail(cell_text(cell) + " of VTK type " + std::to_string(grid_.types[cell]) + " has " +
                 std::to_string(count) + " corners, expected " + std::to_string(fewest) +
                 (most == fewest ? "" : " or more"));
    }

    void add_cell(MeshData& mesh, std::size_t cell)
    {
        require_corners(cell);
        const std::uint8_t type = grid_.types[cell];
        if (type == kTriangleCell || type == kQuadCell || type == kPixel || type == kPolygon)
            return add_element(mesh, cell);
        if (type == kEdgeCell || type == kPolyLine) {
            require_count(cell, 2, type == kEdgeCell ? 2 : INT64_MAX);
            lines_.push_back(cell);
        } else if (type != kVertexCell && type != kPolyVertex) {
            fail(cell_text(cell) + " is " + cell_type_name(type) +
                 ", but only meshes of triangles and quads, planar or surface, are supported");
        }
    }

    void add_element(MeshData& mesh, std::size_t cell)
    {
        const std::uint8_t type = grid_.types[cell];
        const std::int64_t begin = begin_of(cell);
        const std::int64_t count = grid_.ends[cell] - begin;
        if (type == kPolygon && count != 3 && count != 4)
            fail(cell_text(cell) + " is a polygon of " + std::to_string(count) +
                 " corners, but only triangles and quads are supported");
        if (type != kPolygon)
            require_count(cell, type == kTriangleCell ? 3 : 4, type == kTriangleCell ? 3 : 4);
        Element element{corner(begin), corner(begin + 1), corner(begin + 2), -1};
        if (count == 4)
            element[3] = corner(begin + 3);
        if (type == kPixel) // numbered row by row, not around
            std::swap(element[2], element[3]);
        mesh.elements.push_back(element);
        element_cells_.push_back(static_cast<Index>(cell));
    }

    void append_edges(Marker& marker, std::size_t cell) const
    {
        for (std::int64_t i = begin_of(cell); i + 1 < grid_.ends[cell]; ++i)
            marker.edges.push_back({corner(i), corner(i + 1)});
    }

    void add_markers(MeshData& mesh)
    {
        if (!grid_.marker_array.empty())
            return add_named_markers(mesh);
        if (lines_.empty())
            return;
        const Field* numbers = grouping_field();
        std::map<double, std::size_t> marker_of;
        for (const std::size_t cell : lines_) {
            const double number = numbers ? numbers->values(static_cast<Index>(cell), 0) : 0;
            const auto [entry, is_new] = marker_of.try_emplace(number, mesh.markers.size());
            if (is_new)
                mesh.markers.push_back(
                    {numbers ? std::to_string(static_cast<std::int64_t>(number)) : std::string("lines"), {}});
            append_edges(mesh.markers[entry->second], cell);
        }
    }

    void add_named_markers(MeshData& mesh)
    {
        for (const std::string& name : grid_.marker_names)
            mesh.markers.push_back({name, {}});
        const Field* numbers = find_field(grid_.fields, grid_.marker_array, FieldLocation::element);
        if (!numbers && !lines_.empty())
            fail("markers are named, but there is no cell array '" + grid_.marker_array +
                 "' that numbers them");
        for (const std::size_t cell : lines_) {
            const double number = numbers->values(static_cast<Index>(cell), 0);
            if (!(number >= 1 && number <= static_cast<double>(mesh.markers.size()) &&
                  std::floor(number) == number))
                fail("line " + cell_text(cell) + " is of marker number " + std::to_string(number) + ", but " +
                     std::to_string(mesh.markers.size()) + " are named");
            append_edges(mesh.markers[static_cast<std::size_t>(number) - 1], cell);
        }
        if (numbers)
            grid_.fields.erase(grid_.fields.begin() + (numbers - grid_.fields.data()));
    }

    /// The cell array with one whole number for every line, by the names that generators and
    /// converters use, or null.
    const Field* grouping_field() const
    {
        constexpr std::array<const char*, 8> names{"marker",     "CellEntityIds",   "gmsh:physical",
                                                   "cell_tags",  "medit:ref",       "PhysicalIds",
                                                   "ElementTag", "gmsh:geometrical"};
        const auto whole = [](double number) {
            return std::abs(number) < 1e15 && std::floor(number) == number;
        };
        for (const char* name : names) {
            const Field* field = find_field(grid_.fields, name, FieldLocation::element);
            if (field && field->values.cols() == 1 &&
                std::all_of(lines_.begin(), lines_.end(), [&](std::size_t cell) {
                    return whole(field->values(static_cast<Index>(cell), 0));
                }))
                return field;
        }
        return nullptr;
    }

    /// Fields of the vertices as they are, those of the cells without the rows of other cells.
    void add_fields(MeshData& mesh)
    {
        const bool all = element_cells_.size() == grid_.types.size();
        for (Field& field : grid_.fields) {
            if (field.location == FieldLocation::element && !all)
                field.values = Matrix(field.values(element_cells_, Eigen::all));
            mesh.fields.push_back(std::move(field));
        }
    }

    VtkGrid& grid_;
    const std::string& path_;
    std::vector<Index> element_cells_; ///< cell of each element
    std::vector<std::size_t> lines_;
};

} // namespace

MeshData mesh_from_vtk(VtkGrid grid, const std::string& path)
{
    return CellReader(grid, path).mesh();
}

std::string marker_names_array(const std::string& marker_array)
{
    return marker_array + "_names";
}

std::string marker_array_of(const std::string& names_array)
{
    std::string array = "marker";
    while (names_array.starts_with(array)) {
        if (names_array == marker_names_array(array))
            return array;
        array += '_';
    }
    return {};
}

} // namespace morph
