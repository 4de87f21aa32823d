#include "formats/mesh/merge_parts.h"
#include "formats/vtk/cells.h"
#include "formats/vtk/vtu_array.h"
#include "formats/vtk/xml.h"
#include "libmorph/core/error.h"

#include <array>
#include <charconv>
#include <limits>

namespace morph {

namespace {

/// The four lists of cells of poly data in the order in which its fields have their rows.
struct PolyList {
    const char* name;
    const char* count;
    std::uint8_t type;
};
constexpr std::array<PolyList, 4> kPolyLists{{{"Verts", "NumberOfVerts", 2},
                                              {"Lines", "NumberOfLines", 4},
                                              {"Polys", "NumberOfPolys", 7},
                                              {"Strips", "NumberOfStrips", 6}}};

/// Reads the pieces of one file.
class XmlReader {
public:
    XmlReader(const InputBytes& file, VtkXmlKind kind)
        : file_(file), kind_(kind), document_(read_xml(file, "AppendedData")), arrays_(file, document_)
    {
    }

    MeshData read()
    {
        require_kind();
        const XmlElement& grid = child(document_.root, name_of(kind_));
        std::vector<const XmlElement*> pieces;
        std::vector<std::string> names;
        for (const XmlElement& candidate : grid.children)
            if (candidate.name == "Piece") {
                pieces.push_back(&candidate);
                names.push_back("piece " + std::to_string(pieces.size()));
            }
        if (pieces.empty())
            child(grid, "Piece"); // says that there is none
        set_version(*pieces[0]);
        const std::size_t picked = picked_part(names, "piece", file_);
        if (picked < pieces.size() || pieces.size() == 1)
            return read_piece(grid, *pieces[pieces.size() == 1 ? 0 : picked]);
        std::vector<MeshPart> parts;
        for (std::size_t i = 0; i < pieces.size(); ++i)
            parts.push_back({names[i], read_piece(grid, *pieces[i])});
        file_.warn("its " + std::to_string(pieces.size()) +
                   " pieces were joined; vertices that they share stay double");
        return merge_parts(std::move(parts), file_);
    }

private:
    void require_kind() const
    {
        const XmlElement& root = document_.root;
        const std::string* type = root.attribute("type");
        if (root.name == "VTKFile" && type && *type == name_of(kind_))
            return;
        arrays_.fail(root, "expected <VTKFile type=\"" + std::string(name_of(kind_)) + "\">, found <" +
                               root.name + (type ? " type=\"" + *type + "\"" : "") + ">");
    }

    /// As VTK has it, with how the first array is written: "1.0, appended raw, zlib".
    void set_version(const XmlElement& piece) const
    {
        const std::string* version = document_.root.attribute("version");
        const XmlElement* points = piece.child("Points");
        const XmlElement* array = points ? points->child("DataArray") : nullptr;
        file_.set_version((version ? *version : "no version") + (array ? ", " + arrays_.coding(*array) : ""));
    }

    MeshData read_piece(const XmlElement& grid, const XmlElement& piece)
    {
        grid_ = {};
        points_ = count(piece, "NumberOfPoints");
        read_points(piece);
        if (kind_ == VtkXmlKind::unstructured_grid)
            read_cells(piece);
        else
            read_poly_lists(piece);
        read_fields(piece.child("PointData"), FieldLocation::vertex, points_);
        read_fields(piece.child("CellData"), FieldLocation::element, cells_);
        read_names(grid.child("FieldData"));
        return mesh_from_vtk(std::move(grid_), file_);
    }

    const XmlElement& child(const XmlElement& parent, std::string_view name) const
    {
        const XmlElement* found = parent.child(name);
        if (!found)
            arrays_.fail(parent, "<" + parent.name + "> has no <" + std::string(name) + ">");
        return *found;
    }

    std::size_t count(const XmlElement& element, std::string_view name) const
    {
        const std::string* text = element.attribute(name);
        if (!text)
            arrays_.fail(element, "<" + element.name + "> has no " + std::string(name));
        Index value = 0;
        const auto [stop, error] = std::from_chars(text->data(), text->data() + text->size(), value);
        if (error != std::errc() || stop != text->data() + text->size() || value < 0)
            arrays_.fail(element, std::string(name) + " is '" + *text + "', expected a number from 0 to " +
                                      std::to_string(std::numeric_limits<Index>::max()));
        return static_cast<std::size_t>(value);
    }

    const XmlElement& array_called(const XmlElement& parent, std::string_view name) const
    {
        for (const XmlElement& candidate : parent.children) {
            const std::string* candidate_name = candidate.attribute("Name");
            if (candidate.name == "DataArray" && candidate_name && *candidate_name == name)
                return candidate;
        }
        arrays_.fail(parent, "<" + parent.name + "> has no array '" + std::string(name) + "'");
    }

    std::size_t components(const XmlElement& array) const
    {
        const std::string* text = array.attribute("NumberOfComponents");
        return text && *text != "0" ? count(array, "NumberOfComponents") : 1;
    }

    void read_points(const XmlElement& piece)
    {
        const XmlElement& array = child(child(piece, "Points"), "DataArray");
        if (components(array) != 3)
            arrays_.fail(array,
                         "points have " + std::to_string(components(array)) + " components, expected 3");
        const NumberArray numbers = arrays_.numbers(array, 3 * points_);
        grid_.points.resize(static_cast<Index>(points_), 3);
        copy_numbers(numbers, grid_.points.data());
    }

    void read_cells(const XmlElement& piece)
    {
        cells_ = count(piece, "NumberOfCells");
        const XmlElement& cells = child(piece, "Cells");
        grid_.ends = ends(cells, cells_);
        grid_.types = whole_numbers<std::uint8_t>(arrays_.numbers(array_called(cells, "types"), cells_));
        grid_.corners = corners(cells, grid_.ends);
    }

    void read_poly_lists(const XmlElement& piece)
    {
        cells_ = 0;
        for (const PolyList& list : kPolyLists) {
            const std::size_t cells = piece.attribute(list.count) ? count(piece, list.count) : 0;
            if (cells == 0)
                continue;
            const XmlElement& element = child(piece, list.name);
            std::vector<std::int64_t> list_ends = ends(element, cells);
            const std::vector<Index> list_corners = corners(element, list_ends);
            const auto first = static_cast<std::int64_t>(grid_.corners.size());
            for (std::int64_t& end : list_ends)
                end = end < 0 ? -1 : first + end;
            grid_.types.insert(grid_.types.end(), cells, list.type);
            grid_.ends.insert(grid_.ends.end(), list_ends.begin(), list_ends.end());
            grid_.corners.insert(grid_.corners.end(), list_corners.begin(), list_corners.end());
            cells_ += cells;
        }
    }

    std::vector<std::int64_t> ends(const XmlElement& cells, std::size_t cell_count)
    {
        return whole_numbers<std::int64_t>(arrays_.numbers(array_called(cells, "offsets"), cell_count));
    }

    /// As many as the last cell says.
    std::vector<Index> corners(const XmlElement& cells, const std::vector<std::int64_t>& ends)
    {
        const XmlElement& connectivity = array_called(cells, "connectivity");
        const std::int64_t total = ends.empty() ? 0 : ends.back();
        if (total < 0)
            arrays_.fail(connectivity,
                         "the last number of the array 'offsets' is negative or no whole number");
        return whole_numbers<Index>(arrays_.numbers(connectivity, static_cast<std::size_t>(total)));
    }

    void read_fields(const XmlElement* data, FieldLocation location, std::size_t rows)
    {
        if (!data)
            return;
        for (const XmlElement& array : data->children) {
            if (array.name != "DataArray")
                continue;
            const std::string* name = array.attribute("Name");
            const std::size_t columns = components(array);
            if (columns > 9)
                arrays_.fail(array, "array '" + (name ? *name : "") + "' has " + std::to_string(columns) +
                                        " components, but 1 to 9 are supported");
            const NumberArray numbers = arrays_.numbers(array, rows * columns);
            Field& field = grid_.fields.emplace_back();
            field.name = name ? *name : "";
            field.location = location;
            field.values.resize(static_cast<Index>(rows), static_cast<Index>(columns));
            copy_numbers(numbers, field.values.data());
        }
    }

    /// What the field data call the markers and groups.
    void read_names(const XmlElement* field_data)
    {
        if (!field_data)
            return;
        for (const XmlElement& array : field_data->children) {
            const std::string* type = array.attribute("type");
            const std::string* name = array.attribute("Name");
            if (!type || *type != "String" || !name)
                continue;
            if (numbered_array(*name, VtkNamed::marker).empty() &&
                numbered_array(*name, VtkNamed::group).empty())
                continue;
            std::vector<std::string> names = arrays_.strings(array);
            for (std::string& text : names)
                text = without_escapes(text);
            use_names(grid_, *name, std::move(names));
        }
    }

    InputBytes file_;
    VtkXmlKind kind_;
    XmlDocument document_;
    VtuArrays arrays_;
    std::size_t points_ = 0;
    std::size_t cells_ = 0;
    VtkGrid grid_;
};

} // namespace

MeshData read_vtk_xml(const InputBytes& file, VtkXmlKind kind)
{
    return XmlReader(file, kind).read();
}

} // namespace morph
