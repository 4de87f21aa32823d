// Legacy VTK files. Written as an unstructured grid of version 3.0, which every VTK reads.
#include "formats/vtk/read.h"

#include "formats/text/names_in_text.h"
#include "formats/vtk/output.h"

#include <algorithm>
#include <bit>

namespace morph {

namespace {

class VtkWriter {
public:
    VtkWriter(const MeshData& mesh, bool binary, OutputFile& file)
        : mesh_(mesh), output_(vtk_output(mesh, VtkOrder::elements_first)), binary_(binary), file_(file)
    {
    }

    void write()
    {
        line("# vtk DataFile Version 3.0");
        line("mesh");
        line(binary_ ? "BINARY" : "ASCII");
        line("DATASET UNSTRUCTURED_GRID");
        names();
        line("POINTS " + std::to_string(output_.points.rows) + " double");
        numbers(output_.points);
        cells();
        data("POINT_DATA", output_.points.rows, output_.point_data);
        data("CELL_DATA", output_.types.rows, output_.cell_data);
    }

private:
    void line(const std::string& text) { file_.append(text + "\n"); }

    void names()
    {
        if (output_.names.empty())
            return;
        line("FIELD FieldData " + std::to_string(output_.names.size()));
        for (const VtkNames& named : output_.names) {
            line(names_array(named.array) + " 1 " + std::to_string(named.names.size()) + " string");
            for (const std::string& name : named.names)
                if (binary_)
                    file_.append(with_length(name));
                else
                    line(percent_encoded(name));
            if (binary_)
                line("");
        }
    }

    /// The length as a number of 8 bytes of which the two highest bits are 0, and the text.
    static std::string with_length(const std::string& name)
    {
        std::string bytes;
        for (int shift = 56; shift >= 0; shift -= 8)
            bytes += static_cast<char>(std::uint64_t{name.size()} >> shift & 0xff);
        return bytes + name;
    }

    void cells()
    {
        const std::vector<std::int32_t> corners = counted_corners(mesh_);
        line("CELLS " + std::to_string(output_.types.rows) + " " + std::to_string(corners.size()));
        numbers(view_of(NumberType::int32, corners.data(), corners.size()), 12);
        end_numbers();
        line("CELL_TYPES " + std::to_string(output_.types.rows));
        output_.types.numbers([&](const NumberArray& types) {
            const std::vector<std::int32_t> wide = whole_numbers<std::int32_t>(types);
            numbers(view_of(NumberType::int32, wide.data(), wide.size()), 12);
        });
        end_numbers();
    }

    void data(const std::string& keyword, std::size_t rows, const std::vector<VtkArray>& arrays)
    {
        if (arrays.empty())
            return;
        line(keyword + " " + std::to_string(rows));
        line("FIELD FieldData " + std::to_string(arrays.size()));
        for (const VtkArray& array : arrays) {
            line((array.name.empty() ? "unnamed" : percent_encoded(array.name)) + " " +
                 std::to_string(array.components) + " " + std::to_string(rows) + legacy_name(array.type));
            numbers(array);
        }
    }

    static const char* legacy_name(NumberType type)
    {
        return type == NumberType::int32 ? " int" : type == NumberType::uint8 ? " unsigned_char" : " double";
    }

    void numbers(const VtkArray& array)
    {
        const std::size_t per_line = array.components == 1 ? 12 : array.components;
        array.numbers([&](const NumberArray& part) { numbers(part, per_line); });
        end_numbers();
    }

    /// As text or as big-endian bytes, a piece at a time.
    void numbers(const NumberArray& array, std::size_t per_line)
    {
        const std::size_t piece = per_line * 4096 * size_of(array.type);
        for (std::size_t at = 0; at < array.bytes.size(); at += piece) {
            const NumberArray part{array.type, array.bytes.substr(at, piece), false};
            std::string text;
            if (!binary_)
                append_text(text, part, per_line);
            else
                text = std::endian::native == std::endian::little ? swapped_bytes(part)
                                                                  : std::string(part.bytes);
            file_.append(binary_ ? text : text + "\n");
        }
    }

    void end_numbers()
    {
        if (binary_)
            line("");
    }

    const MeshData& mesh_;
    VtkOutput output_;
    bool binary_;
    OutputFile& file_;
};

void write_vtk(const MeshData& mesh, const WriteOptions& options, OutputFile& file)
{
    VtkWriter(mesh, options.binary, file).write();
}

} // namespace

extern const Format vtk_format;
const Format vtk_format{"vtk",
                        {".vtk"},
                        "legacy VTK",
                        {.surface = true,
                         .markers = true,
                         .groups = true,
                         .vertex_fields = true,
                         .element_fields = true,
                         .binary = true,
                         .volume = true},
                        read_vtk,
                        write_vtk};

} // namespace morph
