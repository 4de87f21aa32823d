#include "formats/vtu.h"

#include "formats/vtk_cells.h"
#include "formats/vtu_array.h"
#include "libmorph/core/error.h"

#include <charconv>
#include <limits>

namespace morph {

namespace {

/// Reads the one piece of an unstructured grid.
class VtuReader {
public:
    explicit VtuReader(const InputBytes& file)
        : file_(file), document_(read_xml(file, "AppendedData")), arrays_(file, document_)
    {
    }

    MeshData read()
    {
        const XmlElement& root = document_.root;
        const std::string* type = root.attribute("type");
        if (root.name != "VTKFile" || !type || *type != "UnstructuredGrid")
            arrays_.fail(root, "expected <VTKFile type=\"UnstructuredGrid\">, found <" + root.name +
                                   (type ? " type=\"" + *type + "\"" : "") + ">");
        const XmlElement& grid = child(root, "UnstructuredGrid");
        const XmlElement& piece = only_piece(grid);
        points_ = count(piece, "NumberOfPoints");
        cells_ = count(piece, "NumberOfCells");
        read_points(piece);
        read_cells(child(piece, "Cells"));
        read_fields(piece.child("PointData"), FieldLocation::vertex, points_);
        read_fields(piece.child("CellData"), FieldLocation::element, cells_);
        read_marker_names(grid.child("FieldData"));
        return mesh_from_vtk(std::move(grid_), file_.path);
    }

private:
    const XmlElement& child(const XmlElement& parent, std::string_view name) const
    {
        const XmlElement* found = parent.child(name);
        if (!found)
            arrays_.fail(parent, "<" + parent.name + "> has no <" + std::string(name) + ">");
        return *found;
    }

    const XmlElement& only_piece(const XmlElement& grid) const
    {
        int pieces = 0;
        for (const XmlElement& candidate : grid.children)
            pieces += candidate.name == "Piece" ? 1 : 0;
        if (pieces > 1)
            arrays_.fail(grid, "the grid comes in " + std::to_string(pieces) +
                                   " pieces, but only one is supported; merge them first");
        return child(grid, "Piece");
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

    void read_cells(const XmlElement& cells)
    {
        grid_.ends = whole_numbers<std::int64_t>(arrays_.numbers(array_called(cells, "offsets"), cells_));
        grid_.types = whole_numbers<std::uint8_t>(arrays_.numbers(array_called(cells, "types"), cells_));
        const XmlElement& connectivity = array_called(cells, "connectivity");
        const std::int64_t corners = cells_ == 0 ? 0 : grid_.ends.back();
        if (corners < 0)
            arrays_.fail(connectivity,
                         "the last number of the array 'offsets' is negative or no whole number");
        grid_.corners =
            whole_numbers<Index>(arrays_.numbers(connectivity, static_cast<std::size_t>(corners)));
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

    void read_marker_names(const XmlElement* field_data)
    {
        if (!field_data)
            return;
        for (const XmlElement& array : field_data->children) {
            const std::string* type = array.attribute("type");
            const std::string* name = array.attribute("Name");
            if (!type || *type != "String" || !name || marker_array_of(*name).empty())
                continue;
            grid_.marker_array = marker_array_of(*name);
            for (const std::string& text : arrays_.strings(array))
                grid_.marker_names.push_back(without_escapes(text));
            return;
        }
    }

    InputBytes file_;
    XmlDocument document_;
    VtuArrays arrays_;
    std::size_t points_ = 0;
    std::size_t cells_ = 0;
    VtkGrid grid_;
};

} // namespace

MeshData read_vtu(const InputBytes& file)
{
    return VtuReader(file).read();
}

} // namespace morph
