#include "formats/vtk/cells.h"

#include "formats/mesh/cell_types.h"
#include "formats/mesh/volume_cells.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <optional>

#include <Eigen/Geometry>

namespace morph {

namespace {

constexpr std::uint8_t kPolyVertex = 2;
constexpr std::uint8_t kPolyLine = 4;
constexpr std::uint8_t kStrip = 6;
constexpr std::uint8_t kPolygon = 7;
constexpr std::uint8_t kPixel = 8;
constexpr std::uint8_t kVoxel = 11;

/// Cells of a volume by the numbers of VTK.
std::optional<VolumeShape> volume_shape(std::uint8_t type)
{
    switch (type) {
    case 10:
        return VolumeShape::tetrahedron;
    case 11: // a voxel, whose corners are in another order
    case 12:
        return VolumeShape::hexahedron;
    case 13:
        return VolumeShape::prism;
    case 14:
        return VolumeShape::pyramid;
    default:
        return std::nullopt;
    }
}

/// Turns the cells of one grid into elements and markers, and those of a volume.
class CellReader {
public:
    CellReader(VtkGrid& grid, const InputBytes& file) : grid_(grid), file_(file) {}

    MeshData mesh()
    {
        require_sizes();
        MeshData& mesh = volume_.mesh;
        mesh.elements.reserve(grid_.types.size());
        element_cells_.reserve(grid_.types.size());
        for (std::size_t cell = 0; cell < grid_.types.size(); ++cell)
            add_cell(cell);
        mesh.markers = take_markers(grid_, lines_, file_.path);
        mesh.groups = take_groups(grid_, element_cells_, file_.path);
        add_fields();
        mesh.dimension = dimension_of(grid_.points);
        mesh.points = std::move(grid_.points);
        return surface_of(std::move(volume_), file_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw InputError(file_.path + ": " + what); }

    static std::string cell_text(std::size_t cell) { return "cell " + std::to_string(cell); }

    void require_sizes() const
    {
        if (grid_.ends.size() != grid_.types.size())
            fail("there are " + std::to_string(grid_.types.size()) + " cell types, but " +
                 std::to_string(grid_.ends.size()) + " cells");
        for (std::size_t cell = 0; cell < grid_.ends.size(); ++cell)
            if (grid_.ends[cell] < grid_.begin_of(cell) ||
                grid_.ends[cell] > static_cast<std::int64_t>(grid_.corners.size()))
                fail(cell_text(cell) + " has corners " + std::to_string(grid_.begin_of(cell)) + " to " +
                     std::to_string(grid_.ends[cell]) + " of the connectivity, which has " +
                     std::to_string(grid_.corners.size()));
        for (Index v = 0; v < grid_.points.rows(); ++v)
            if (!grid_.points.row(v).allFinite())
                fail("point " + std::to_string(v) + " has a coordinate that is not finite");
    }

    /// Every corner of the cell is a point.
    void require_corners(std::size_t cell) const
    {
        for (std::int64_t i = grid_.begin_of(cell); i < grid_.ends[cell]; ++i) {
            const Index corner = grid_.corner(i);
            if (corner < 0 || corner >= grid_.points.rows())
                fail(cell_text(cell) + " names point " +
                     (corner < 0 ? "that is no index" : std::to_string(corner)) + ", but the mesh has " +
                     std::to_string(grid_.points.rows()));
        }
    }

    std::int64_t count_of(std::size_t cell) const { return grid_.ends[cell] - grid_.begin_of(cell); }

    void require_count(std::size_t cell, std::int64_t fewest, std::int64_t most) const
    {
        const std::int64_t count = count_of(cell);
        if (count < fewest || count > most)
            fail(cell_text(cell) + " of VTK type " + std::to_string(grid_.types[cell]) + " has " +
                 std::to_string(count) + " corners, expected " + std::to_string(fewest) +
                 (most == fewest ? "" : " or more"));
    }

    void add_cell(std::size_t cell)
    {
        require_corners(cell);
        const std::uint8_t type = grid_.types[cell];
        if (type == kTriangleCell || type == kQuadCell || type == kPixel || type == kPolygon)
            return add_element(cell);
        if (type == kStrip)
            return add_strip(cell);
        if (const auto shape = volume_shape(type))
            return add_volume(cell, *shape);
        if (type == kEdgeCell || type == kPolyLine) {
            require_count(cell, 2, type == kEdgeCell ? 2 : INT64_MAX);
            lines_.push_back(cell);
        } else if (type != kVertexCell && type != kPolyVertex) {
            fail(cell_text(cell) + " is " + cell_type_name(type) +
                 ", but only meshes of triangles and quads, planar or surface, and volumes of linear cells "
                 "are supported");
        }
    }

    void push_element(std::size_t cell, const Element& element)
    {
        volume_.mesh.elements.push_back(element);
        element_cells_.push_back(static_cast<Index>(cell));
    }

    void add_element(std::size_t cell)
    {
        const std::uint8_t type = grid_.types[cell];
        const std::int64_t begin = grid_.begin_of(cell);
        const std::int64_t count = count_of(cell);
        if (type == kPolygon && count != 3 && count != 4)
            fail(cell_text(cell) + " is a polygon of " + std::to_string(count) +
                 " corners, but only triangles and quads are supported");
        if (type != kPolygon)
            require_count(cell, type == kTriangleCell ? 3 : 4, type == kTriangleCell ? 3 : 4);
        Element element{grid_.corner(begin), grid_.corner(begin + 1), grid_.corner(begin + 2), -1};
        if (count == 4)
            element[3] = grid_.corner(begin + 3);
        if (type == kPixel) // numbered row by row, not around
            std::swap(element[2], element[3]);
        push_element(cell, element);
    }

    /// Each corner from the third on makes a triangle with the two before it; every other one is turned over.
    void add_strip(std::size_t cell)
    {
        require_count(cell, 3, INT64_MAX);
        for (std::int64_t i = 0; i + 2 < count_of(cell); ++i) {
            const std::int64_t at = grid_.begin_of(cell) + i;
            push_element(cell,
                         {grid_.corner(at + i % 2), grid_.corner(at + 1 - i % 2), grid_.corner(at + 2), -1});
        }
    }

    void add_volume(std::size_t cell, VolumeShape shape)
    {
        require_count(cell, corner_count(shape), corner_count(shape));
        VolumeCell& to = volume_.cells.emplace_back(VolumeCell{shape, {}});
        std::copy_n(grid_.corners.begin() + grid_.begin_of(cell), corner_count(shape), to.corners.begin());
        if (grid_.types[cell] == kVoxel) {
            std::swap(to.corners[2], to.corners[3]);
            std::swap(to.corners[6], to.corners[7]);
        }
        if (shape == VolumeShape::prism && points_outwards(to.corners))
            std::rotate(to.corners.begin(), to.corners.begin() + 3, to.corners.begin() + 6);
    }

    /// VTK's manual has the base of a wedge point outwards, most programs write it the other way.
    bool points_outwards(const std::array<Index, 8>& corners) const
    {
        const auto point = [&](std::size_t i) { return grid_.points.row(corners[i]); };
        const Eigen::RowVector3d normal = (point(1) - point(0)).cross(point(2) - point(0));
        const Eigen::RowVector3d across = point(3) + point(4) + point(5) - point(0) - point(1) - point(2);
        return normal.dot(across) < 0;
    }

    /// Fields of the vertices as they are, those of the cells without the rows of other cells.
    void add_fields()
    {
        bool same = element_cells_.size() == grid_.types.size();
        for (std::size_t e = 0; same && e < element_cells_.size(); ++e)
            same = element_cells_[e] == static_cast<Index>(e);
        for (Field& field : grid_.fields) {
            if (field.location == FieldLocation::element && !same)
                field.values = Matrix(field.values(element_cells_, Eigen::all));
            volume_.mesh.fields.push_back(std::move(field));
        }
    }

    VtkGrid& grid_;
    const InputBytes& file_;
    VolumeFile volume_;
    std::vector<Index> element_cells_; ///< cell of each element
    std::vector<std::size_t> lines_;
};

} // namespace

MeshData mesh_from_vtk(VtkGrid grid, const InputBytes& file)
{
    return CellReader(grid, file).mesh();
}

} // namespace morph
