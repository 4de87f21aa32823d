#include "formats/vtk/read.h"
#include "formats/vtk/cells.h"
#include "formats/vtk/legacy.h"
#include "formats/vtk/structured.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <utility>

namespace morph {

namespace {

/// The corners of cells, one after another, and where each cell ends.
struct CellList {
    std::vector<std::int64_t> ends;
    std::vector<Index> corners;
};

/// The four lists of a POLYDATA set, in the order in which its fields have their rows.
struct PolyList {
    const char* keyword;
    std::uint8_t type;
};
constexpr std::array<PolyList, 4> kPolyLists{
    {{"VERTICES", 2}, {"LINES", 4}, {"POLYGONS", 7}, {"TRIANGLE_STRIPS", 6}}};

class VtkReader {
public:
    explicit VtkReader(const InputBytes& file) : file_(file), in_(file.path, file.bytes) {}

    MeshData read()
    {
        const std::string kind = in_.header();
        file_.set_version(in_.version() + (in_.binary() ? ", binary" : ", ascii"));
        if (kind != "UNSTRUCTURED_GRID" && kind != "POLYDATA" && kind != "STRUCTURED_GRID" &&
            kind != "RECTILINEAR_GRID")
            in_.fail("only data sets of the kinds UNSTRUCTURED_GRID, POLYDATA, STRUCTURED_GRID and "
                     "RECTILINEAR_GRID are supported");
        for (std::string word = in_.keyword(); !word.empty(); word = in_.keyword())
            block(word);
        join_poly_lists();
        if (kind == "STRUCTURED_GRID" || kind == "RECTILINEAR_GRID")
            finish_structured(kind == "RECTILINEAR_GRID");
        if (rows_[0] > 0 && rows_[0] != static_cast<std::size_t>(grid_.points.rows()))
            in_.fail("POINT_DATA is for " + std::to_string(rows_[0]) + " points, but the mesh has " +
                     std::to_string(grid_.points.rows()));
        if (rows_[1] > 0 && rows_[1] != grid_.types.size())
            in_.fail("CELL_DATA is for " + std::to_string(rows_[1]) + " cells, but the mesh has " +
                     std::to_string(grid_.types.size()));
        return mesh_from_vtk(std::move(grid_), file_);
    }

private:
    void block(const std::string& word)
    {
        if (word == "METADATA")
            in_.skip_metadata();
        else if (word == "POINTS")
            read_points();
        else if (word == "CELLS")
            use_cells(read_cells());
        else if (word == "CELL_TYPES")
            read_types();
        else if (word == "POINT_DATA")
            begin_data(FieldLocation::vertex);
        else if (word == "CELL_DATA")
            begin_data(FieldLocation::element);
        else if (word == "DIMENSIONS")
            for (std::size_t& along_axis : grid_size_)
                along_axis = in_.count("the number of points along an axis");
        else if (!poly_list(word) && !axis(word) && !attribute(word))
            in_.fail_expected("a keyword of a legacy VTK file (is a count above it wrong?)");
    }

    void use_cells(CellList list)
    {
        grid_.ends = std::move(list.ends);
        grid_.corners = std::move(list.corners);
    }

    void read_points()
    {
        const std::size_t count = in_.count("the number of points");
        const NumberArray numbers = in_.numbers(in_.type_word(), 3 * count);
        grid_.points.resize(static_cast<Index>(count), 3);
        copy_numbers(numbers, grid_.points.data());
    }

    CellList read_cells()
    {
        const std::size_t cells = in_.count("the number of cells");
        const std::size_t size = in_.count("the size of the list of cells");
        return in_.major_version() >= 5 ? cells_by_offset(cells, size) : counted_cells(cells, size);
    }

    /// Since version 5.1: OFFSETS with a leading 0, CONNECTIVITY.
    CellList cells_by_offset(std::size_t offsets, std::size_t size)
    {
        CellList list;
        if (offsets == 0)
            return list;
        list.ends = whole_numbers<std::int64_t>(array_after("OFFSETS", offsets));
        if (list.ends[0] != 0)
            in_.fail("the first of the OFFSETS is not 0");
        list.ends.erase(list.ends.begin());
        list.corners = whole_numbers<Index>(array_after("CONNECTIVITY", size));
        return list;
    }

    NumberArray array_after(const std::string& wanted, std::size_t count)
    {
        if (in_.keyword() != wanted)
            in_.fail_expected(wanted);
        return in_.numbers(in_.type_word(), count);
    }

    /// Before that: for each cell the number of its corners, then these.
    CellList counted_cells(std::size_t cells, std::size_t size)
    {
        const std::vector<Index> numbers = whole_numbers<Index>(in_.numbers("INT", size));
        CellList list;
        list.ends.reserve(std::min(cells, size));
        list.corners.reserve(size);
        std::size_t at = 0;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const Index corners = at < size ? numbers[at] : -1;
            if (corners < 0 || static_cast<std::size_t>(corners) >= size - at)
                in_.fail("the list of " + std::to_string(size) + " numbers ends within cell " +
                         std::to_string(cell) + " of " + std::to_string(cells));
            const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(at) + 1;
            list.corners.insert(list.corners.end(), first, first + corners);
            list.ends.push_back(static_cast<std::int64_t>(list.corners.size()));
            at += 1 + static_cast<std::size_t>(corners);
        }
        if (at != size)
            in_.fail("the " + std::to_string(cells) + " cells take " + std::to_string(at) +
                     " numbers, but the list has " + std::to_string(size));
        return list;
    }

    void read_types()
    {
        grid_.types = whole_numbers<std::uint8_t>(in_.numbers("INT", in_.count("the number of cell types")));
    }

    bool poly_list(const std::string& word)
    {
        for (std::size_t i = 0; i < kPolyLists.size(); ++i)
            if (word == kPolyLists[i].keyword) {
                poly_lists_[i] = read_cells();
                return true;
            }
        return false;
    }

    void join_poly_lists()
    {
        for (std::size_t i = 0; i < kPolyLists.size(); ++i) {
            const auto begin = static_cast<std::int64_t>(grid_.corners.size());
            for (const std::int64_t end : poly_lists_[i].ends)
                grid_.ends.push_back(end < 0 ? -1 : begin + end);
            grid_.types.insert(grid_.types.end(), poly_lists_[i].ends.size(), kPolyLists[i].type);
            grid_.corners.insert(grid_.corners.end(), poly_lists_[i].corners.begin(),
                                 poly_lists_[i].corners.end());
        }
    }

    /// Coordinates along one axis of a rectilinear grid.
    bool axis(const std::string& word)
    {
        constexpr std::array<std::string_view, 3> keywords{"X_COORDINATES", "Y_COORDINATES", "Z_COORDINATES"};
        const auto found = std::find(keywords.begin(), keywords.end(), word);
        if (found == keywords.end())
            return false;
        const std::size_t count = in_.count("the number of coordinates");
        const NumberArray numbers = in_.numbers(in_.type_word(), count);
        std::vector<double>& axis = axes_.at(static_cast<std::size_t>(found - keywords.begin()));
        axis.resize(count);
        copy_numbers(numbers, axis.data());
        return true;
    }

    void finish_structured(bool rectilinear)
    {
        if (rectilinear && grid_size_ != GridSize{axes_[0].size(), axes_[1].size(), axes_[2].size()})
            in_.fail("the axes have " + size_text({axes_[0].size(), axes_[1].size(), axes_[2].size()}) +
                     " coordinates, but DIMENSIONS are " + size_text(grid_size_));
        const std::size_t points = point_count(grid_size_, file_.path);
        if (rectilinear)
            grid_.points = rectilinear_points(axes_);
        if (points != static_cast<std::size_t>(grid_.points.rows()))
            in_.fail("DIMENSIONS are " + size_text(grid_size_) + ", but there are " +
                     std::to_string(grid_.points.rows()) + " points");
        add_structured_cells(grid_, grid_size_);
    }

    static std::string size_text(const GridSize& size)
    {
        return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
    }

    void begin_data(FieldLocation location)
    {
        location_ = location;
        in_data_ = true;
        rows_[location == FieldLocation::vertex ? 0 : 1] = row_count_ =
            in_.count("the number of rows of the fields");
    }

    /// One of the older kinds of field, which the first word names.
    bool attribute(const std::string& word)
    {
        if (word == "FIELD") {
            read_field_arrays();
            return true;
        }
        if (word == "LOOKUP_TABLE") {
            in_.name("the name of a colour table");
            in_.numbers(in_.binary() ? "UNSIGNED_CHAR" : "FLOAT",
                        4 * in_.count("the size of a colour table"));
            return true;
        }
        constexpr std::array<std::pair<std::string_view, std::size_t>, 7> columns_of{{{"VECTORS", 3},
                                                                                      {"NORMALS", 3},
                                                                                      {"TENSORS", 9},
                                                                                      {"TENSORS6", 6},
                                                                                      {"GLOBAL_IDS", 1},
                                                                                      {"PEDIGREE_IDS", 1},
                                                                                      {"EDGE_FLAGS", 1}}};
        for (const auto& [keyword, columns] : columns_of)
            if (word == keyword) {
                const std::string name = in_.name("the name of a field");
                read_field(name, in_.type_word(), columns);
                return true;
            }
        return scalars(word);
    }

    /// The kinds with a number of components of their own.
    bool scalars(const std::string& word)
    {
        if (word != "SCALARS" && word != "COLOR_SCALARS" && word != "TEXTURE_COORDINATES")
            return false;
        const std::string name = in_.name("the name of a field");
        if (word == "COLOR_SCALARS") {
            const std::size_t columns = in_.count("the number of components");
            read_field(name, in_.binary() ? "UNSIGNED_CHAR" : "FLOAT", columns);
        } else if (word == "TEXTURE_COORDINATES") {
            const std::size_t columns = in_.count("the number of components");
            read_field(name, in_.type_word(), columns);
        } else {
            const std::string type = in_.type_word();
            const std::size_t columns = in_.count_or(1);
            in_.skip_lookup_table_line();
            read_field(name, type, columns);
        }
        return true;
    }

    void read_field_arrays()
    {
        in_.name("the name of the field data");
        const std::size_t arrays = in_.count("the number of arrays");
        for (std::size_t i = 0; i < arrays; ++i) {
            while (in_.keyword() == "METADATA")
                in_.skip_metadata();
            in_.put_back();
            const std::string name = in_.name("the name of an array");
            const std::size_t columns = in_.count("the number of components");
            const std::size_t rows = in_.count("the number of rows");
            const std::string type = in_.type_word();
            if (type == "STRING")
                use_strings(name, in_.strings(rows * columns));
            else if (in_data_ && rows != row_count_)
                in_.fail("array '" + name + "' has " + std::to_string(rows) + " rows, expected " +
                         std::to_string(row_count_));
            else if (in_data_)
                read_field(name, type, columns);
            else
                in_.numbers(type, rows * columns);
        }
    }

    void use_strings(const std::string& name, std::vector<std::string> strings)
    {
        if (!in_data_)
            use_names(grid_, name, std::move(strings));
    }

    void read_field(const std::string& name, const std::string& type, std::size_t columns)
    {
        if (!in_data_)
            in_.fail("a field before POINT_DATA and CELL_DATA");
        if (columns < 1 || columns > 9)
            in_.fail("field '" + name + "' has " + std::to_string(columns) +
                     " components, but 1 to 9 are supported");
        const NumberArray numbers = in_.numbers(type, row_count_ * columns);
        Field& field = grid_.fields.emplace_back();
        field.name = name;
        field.location = location_;
        field.values.resize(static_cast<Index>(row_count_), static_cast<Index>(columns));
        copy_numbers(numbers, field.values.data());
    }

    const InputBytes& file_;
    LegacyVtkScanner in_;
    VtkGrid grid_;
    std::array<CellList, 4> poly_lists_;
    GridSize grid_size_{};                    ///< of a structured or rectilinear grid
    std::array<std::vector<double>, 3> axes_; ///< of a rectilinear grid
    std::array<std::size_t, 2> rows_{};       ///< of the fields of points and cells, as the file says
    bool in_data_ = false;                    ///< behind POINT_DATA or CELL_DATA
    FieldLocation location_ = FieldLocation::vertex;
    std::size_t row_count_ = 0;
};

} // namespace

MeshData read_vtk(const InputBytes& file)
{
    return VtkReader(file).read();
}

} // namespace morph
