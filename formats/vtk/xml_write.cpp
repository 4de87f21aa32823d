#include "formats/binary/compression.h"
#include "formats/text/xml.h"
#include "formats/vtk/output.h"
#include "formats/vtk/xml.h"
#include "libmorph/core/parallel.h"

#include <bit>
#include <cstdint>
#include <numeric>

namespace morph {

namespace {

/// Writes the XML, and behind it the bytes that it refers to.
class XmlWriter {
public:
    XmlWriter(const MeshData& mesh, VtkXmlKind kind, const WriteOptions& options, OutputFile& file)
        : kind_(kind), output_(vtk_output(mesh, kind == VtkXmlKind::poly_data ? VtkOrder::lines_first
                                                                              : VtkOrder::elements_first)),
          binary_(options.binary), compress_(options.binary && options.compress), file_(file)
    {
    }

    void write()
    {
        constexpr bool little = std::endian::native == std::endian::little;
        const std::string kind(name_of(kind_));
        line("<?xml version=\"1.0\"?>");
        line("<VTKFile type=\"" + kind + "\" version=\"1.0\" byte_order=\"" + (little ? "Little" : "Big") +
             "Endian\" header_type=\"UInt64\"" +
             (compress_ ? " compressor=\"vtkZLibDataCompressor\">" : ">"));
        line("<" + kind + ">");
        names();
        piece();
        line("</" + kind + ">");
        if (binary_)
            appended_data();
        line("</VTKFile>");
    }

private:
    /// Bytes of an array before compression that are compressed together.
    static constexpr std::size_t kBlock = std::size_t{1} << 16;

    void line(const std::string& text) { file_.append(text + "\n"); }

    /// ASCII in both modes: what can be read with the eye stays so.
    void names()
    {
        if (output_.names.empty())
            return;
        line("<FieldData>");
        for (const VtkNames& named : output_.names) {
            line("<Array type=\"String\" Name=\"" + names_array(named.array) + "\" NumberOfTuples=\"" +
                 std::to_string(named.names.size()) + "\" format=\"ascii\">");
            for (const std::string& name : named.names) {
                for (const char c : with_escapes(name))
                    file_.append(std::to_string(static_cast<int>(c)) + " ");
                line("0");
            }
            line("</Array>");
        }
        line("</FieldData>");
    }

    void piece()
    {
        const auto counted = [](const char* what, const VtkCellList& cells) {
            return " NumberOf" + std::string(what) + "=\"" + std::to_string(cells.ends.rows) + "\"";
        };
        const bool poly = kind_ == VtkXmlKind::poly_data;
        line("<Piece NumberOfPoints=\"" + std::to_string(output_.points.rows) + "\"" +
             (poly ? " NumberOfVerts=\"0\"" + counted("Lines", output_.lines) + " NumberOfStrips=\"0\"" +
                         counted("Polys", output_.elements)
                   : counted("Cells", output_.cells)) +
             ">");
        section("PointData", output_.point_data);
        section("CellData", output_.cell_data);
        section("Points", {output_.points});
        if (poly) {
            section("Lines", {output_.lines.corners, output_.lines.ends});
            section("Polys", {output_.elements.corners, output_.elements.ends});
        } else {
            section("Cells", {output_.cells.corners, output_.cells.ends, output_.types});
        }
        line("</Piece>");
    }

    void section(const std::string& name, const std::vector<VtkArray>& arrays)
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
        if (!binary_) {
            line(start + "ascii\">");
            array.numbers([&](const NumberArray& numbers) { ascii(numbers, array.components); });
            line("</DataArray>");
            return;
        }
        line(start + "appended\" offset=\"" + std::to_string(offset_) + "\"/>");
        if (compress_) {
            compressed_.push_back(compressed(array));
            offset_ += compressed_.back().size();
        } else {
            offset_ += sizeof(std::uint64_t) + bytes_of(array);
            appended_.push_back(array);
        }
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

    /// Count of blocks, bytes of a block, of the last one if shorter, compressed bytes of each; the blocks.
    static std::string compressed(const VtkArray& array)
    {
        std::string plain;
        plain.reserve(bytes_of(array));
        array.numbers([&](const NumberArray& numbers) { plain += numbers.bytes; });
        std::vector<std::string> blocks((plain.size() + kBlock - 1) / kBlock);
        parallel_for(blocks.size(), 1, [&](std::size_t begin, std::size_t) {
            blocks[begin] = zlib_compressed(std::string_view(plain).substr(begin * kBlock, kBlock));
        });
        std::vector<std::uint64_t> words{blocks.size(), kBlock, plain.size() % kBlock};
        for (const std::string& block : blocks)
            words.push_back(block.size());
        std::string bytes(view_of(NumberType::uint64, words.data(), words.size()).bytes);
        bytes.reserve(std::accumulate(words.begin() + 3, words.end(), bytes.size()));
        for (const std::string& block : blocks)
            bytes += block;
        return bytes;
    }

    void appended_data()
    {
        line("<AppendedData encoding=\"raw\">");
        file_.append("_");
        for (const std::string& bytes : compressed_)
            file_.append(bytes);
        for (const VtkArray& array : appended_) {
            const std::uint64_t length = bytes_of(array);
            file_.append({reinterpret_cast<const char*>(&length), sizeof length});
            array.numbers([&](const NumberArray& numbers) { file_.append(numbers.bytes); });
        }
        line("\n</AppendedData>");
    }

    VtkXmlKind kind_;
    VtkOutput output_;
    bool binary_, compress_;
    OutputFile& file_;
    std::uint64_t offset_ = 0;
    std::vector<VtkArray> appended_;
    std::vector<std::string> compressed_; ///< instead
};

} // namespace

std::string_view name_of(VtkXmlKind kind)
{
    return kind == VtkXmlKind::poly_data ? "PolyData" : "UnstructuredGrid";
}

void write_vtk_xml(const MeshData& mesh, VtkXmlKind kind, const WriteOptions& options, OutputFile& file)
{
    XmlWriter(mesh, kind, options, file).write();
}

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

} // namespace morph
