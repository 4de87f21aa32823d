// VTK XML unstructured grids. Written plain: raw appended data, or ASCII.
#include "formats/vtu.h"

#include "formats/vtk_cells.h"
#include "formats/xml.h"

#include <bit>
#include <cstdint>

namespace morph {

std::string with_escapes(std::string_view name)
{
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const std::string_view next = name.substr(i + 1, 2);
        if (name[i] == '\0')
            text += "%00";
        else if (name[i] == '%' && (next == "00" || next == "25"))
            text += "%25";
        else
            text += name[i];
    }
    return text;
}

std::string without_escapes(std::string_view text)
{
    std::string name;
    while (!text.empty()) {
        const std::string_view front = text.substr(0, 3);
        const bool escape = front == "%00" || front == "%25";
        name += front == "%00" ? '\0' : front[0];
        text.remove_prefix(escape ? 3 : 1);
    }
    return name;
}

namespace {

/// Writes the XML, and behind it the bytes that it refers to.
class VtuWriter {
public:
    VtuWriter(const MeshData& mesh, bool binary, OutputFile& file)
        : mesh_(mesh), output_(vtk_output(mesh)), binary_(binary), file_(file)
    {
    }

    void write()
    {
        constexpr bool little = std::endian::native == std::endian::little;
        line("<?xml version=\"1.0\"?>");
        line(std::string("<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"") +
             (little ? "Little" : "Big") + "Endian\" header_type=\"UInt64\">");
        line("<UnstructuredGrid>");
        marker_names();
        line("<Piece NumberOfPoints=\"" + std::to_string(mesh_.points.rows()) + "\" NumberOfCells=\"" +
             std::to_string(output_.types.rows) + "\">");
        group("PointData", output_.point_data);
        group("CellData", output_.cell_data);
        group("Points", {output_.points});
        group("Cells", {output_.corners, output_.ends, output_.types});
        line("</Piece>");
        line("</UnstructuredGrid>");
        if (binary_)
            appended_data();
        line("</VTKFile>");
    }

private:
    void line(const std::string& text) { file_.append(text + "\n"); }

    /// ASCII in both modes: what can be read with the eye stays so.
    void marker_names()
    {
        if (output_.marker_array.empty())
            return;
        std::string codes;
        for (const Marker& marker : mesh_.markers) {
            for (const char c : with_escapes(marker.name))
                codes += std::to_string(static_cast<int>(c)) + " ";
            codes += "0\n";
        }
        line("<FieldData>");
        line("<Array type=\"String\" Name=\"" + marker_names_array(output_.marker_array) +
             "\" NumberOfTuples=\"" + std::to_string(mesh_.markers.size()) + "\" format=\"ascii\">");
        line(codes + "</Array>");
        line("</FieldData>");
    }

    void group(const std::string& name, const std::vector<VtkArray>& arrays)
    {
        line("<" + name + ">");
        for (const VtkArray& array : arrays)
            data_array(array);
        line("</" + name + ">");
    }

    void data_array(const VtkArray& array)
    {
        const std::string start = "<DataArray type=\"" + std::string(name_of(array.type)) + "\" Name=\"" +
                                  xml_escaped(array.name) + "\" NumberOfComponents=\"" +
                                  std::to_string(array.components) + "\" format=\"";
        if (binary_) {
            line(start + "appended\" offset=\"" + std::to_string(offset_) + "\"/>");
            offset_ += sizeof(std::uint64_t) + bytes_of(array);
            appended_.push_back(array);
            return;
        }
        line(start + "ascii\">");
        array.numbers([&](const NumberArray& numbers) { ascii(numbers, array.components); });
        line("</DataArray>");
    }

    static std::uint64_t bytes_of(const VtkArray& array)
    {
        return array.rows * array.components * size_of(array.type);
    }

    void ascii(const NumberArray& numbers, std::size_t components)
    {
        const std::size_t per_line = components == 1 ? 12 : components;
        const std::size_t piece = per_line * 4096 * size_of(numbers.type);
        for (std::size_t at = 0; at < numbers.bytes.size(); at += piece) {
            std::string text;
            append_text(text, {numbers.type, numbers.bytes.substr(at, piece), false}, per_line);
            line(text);
        }
    }

    void appended_data()
    {
        line("<AppendedData encoding=\"raw\">");
        file_.append("_");
        for (const VtkArray& array : appended_) {
            const std::uint64_t length = bytes_of(array);
            file_.append({reinterpret_cast<const char*>(&length), sizeof length});
            array.numbers([&](const NumberArray& numbers) { file_.append(numbers.bytes); });
        }
        line("\n</AppendedData>");
    }

    const MeshData& mesh_;
    VtkOutput output_;
    bool binary_;
    OutputFile& file_;
    std::uint64_t offset_ = 0;
    std::vector<VtkArray> appended_;
};

void write_vtu(const MeshData& mesh, const WriteOptions& options, OutputFile& file)
{
    VtuWriter(mesh, options.binary, file).write();
}

} // namespace

extern const Format vtu_format;
const Format vtu_format{"vtu",
                        {".vtu"},
                        "VTK XML unstructured grid",
                        {.surface = true, .markers = true, .vertex_fields = true, .element_fields = true},
                        read_vtu,
                        write_vtu};

} // namespace morph
