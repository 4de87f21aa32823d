#include "formats/mesh/element_groups.h"
#include "formats/ply/files.h"
#include "formats/ply/names.h"
#include "formats/text/names_in_text.h"
#include "formats/text/number_text.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

namespace morph {

namespace {

/// Makes the names of properties: one word each, none twice in an element.
class PropertyNames {
public:
    explicit PropertyNames(std::vector<std::string> taken) : taken_(std::move(taken)) {}

    std::string unused(const std::string& wanted)
    {
        std::string name;
        for (const char c : wanted)
            name += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.'
                        ? c
                        : '_';
        if (name.empty())
            name = "field";
        while (is_ply_group(name) || std::find(taken_.begin(), taken_.end(), name) != taken_.end())
            name += '_';
        taken_.push_back(name);
        return name;
    }

private:
    std::vector<std::string> taken_;
};

/// The lines of the header that fields of one place make.
struct FieldLines {
    std::string comments;
    std::string properties;
    std::vector<const Field*> fields;
    std::size_t columns = 0; ///< of all of them
};

FieldLines field_lines(const MeshData& mesh, FieldLocation location, PropertyNames names)
{
    FieldLines lines;
    const std::string kind =
        location == FieldLocation::vertex ? "comment vertex_field " : "comment face_field ";
    for (const Field& field : mesh.fields) {
        if (field.location != location)
            continue;
        lines.fields.push_back(&field);
        lines.columns += static_cast<std::size_t>(field.values.cols());
        for (Eigen::Index c = 0; c < field.values.cols(); ++c) {
            const std::string property =
                names.unused(field.values.cols() == 1 ? field.name : field.name + "_" + std::to_string(c));
            lines.properties += "property double " + property + "\n";
            if (c == 0 && property != field.name)
                lines.comments.append(kind)
                    .append(property)
                    .append(" " + std::to_string(field.values.cols()) + " ")
                    .append(line_name(field.name) + "\n");
        }
    }
    return lines;
}

std::string numbered_names(const std::string& kind, const auto& named)
{
    std::string lines;
    for (std::size_t i = 0; i < named.size(); ++i)
        lines += "comment " + kind + " " + std::to_string(i + 1) + " " + line_name(named[i].name) + "\n";
    return lines;
}

/// Puts the numbers of rows, as text or as they are in memory.
class RowWriter {
public:
    RowWriter(OutputFile& out, bool binary) : out_(out), binary_(binary) {}

    void begin(std::size_t numbers) { to_ = out_.room((numbers + 1) * kLongestNumber); }

    void put(auto number)
    {
        if (!binary_) {
            to_ = number_text(to_, number, ' ');
            return;
        }
        std::memcpy(to_, &number, sizeof number);
        to_ += sizeof number;
    }

    void put_fields(const FieldLines& lines, Eigen::Index row)
    {
        for (const Field* field : lines.fields)
            for (Eigen::Index c = 0; c < field->values.cols(); ++c)
                put(field->values(row, c));
    }

    void end()
    {
        if (!binary_)
            to_[-1] = '\n';
        out_.advance_to(to_);
    }

private:
    OutputFile& out_;
    bool binary_;
    char* to_ = nullptr;
};

void append_vertices(const MeshData& mesh, const FieldLines& fields, RowWriter rows)
{
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        rows.begin(3 + fields.columns);
        for (int k = 0; k < 3; ++k)
            rows.put(mesh.points(v, k));
        rows.put_fields(fields, v);
        rows.end();
    }
}

void append_faces(const MeshData& mesh, const std::vector<std::vector<Index>>& groups,
                  const FieldLines& fields, RowWriter rows)
{
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        rows.begin(5 + groups.size() + fields.columns);
        const int corners = corner_count(mesh.elements[e]);
        rows.put(static_cast<std::uint8_t>(corners));
        for (int k = 0; k < corners; ++k)
            rows.put(mesh.elements[e][static_cast<std::size_t>(k)]);
        for (const std::vector<Index>& column : groups)
            rows.put(column[e]);
        rows.put_fields(fields, static_cast<Eigen::Index>(e));
        rows.end();
    }
}

void append_edges(const MeshData& mesh, RowWriter rows)
{
    for (std::size_t m = 0; m < mesh.markers.size(); ++m)
        for (const auto& [from, to] : mesh.markers[m].edges) {
            rows.begin(3);
            rows.put(from);
            rows.put(to);
            rows.put(static_cast<Index>(m + 1));
            rows.end();
        }
}

std::string group_properties(std::size_t columns)
{
    std::string lines;
    for (std::size_t k = 0; k < columns; ++k)
        lines += "property int group" + (k == 0 ? "" : "_" + std::to_string(k)) + "\n";
    return lines;
}

std::string edge_lines(const MeshData& mesh)
{
    std::size_t edges = 0;
    for (const Marker& marker : mesh.markers)
        edges += marker.edges.size();
    return mesh.markers.empty() ? ""
                                : "element edge " + std::to_string(edges) +
                                      "\nproperty int vertex1\nproperty int vertex2\nproperty int marker\n";
}

} // namespace

void write_ply(const MeshData& mesh, const WriteOptions& options, OutputFile& out)
{
    const std::string order = std::endian::native == std::endian::little ? "little" : "big";
    const FieldLines vertex = field_lines(mesh, FieldLocation::vertex, PropertyNames({"x", "y", "z"}));
    const FieldLines face =
        field_lines(mesh, FieldLocation::element, PropertyNames({"vertex_indices", "vertex_index"}));
    const std::vector<std::vector<Index>> groups = group_columns(mesh);
    out.append("ply\nformat " + (options.binary ? "binary_" + order + "_endian" : std::string("ascii")) +
               " 1.0\n" + numbered_names("group", mesh.groups) + numbered_names("marker", mesh.markers) +
               vertex.comments + face.comments + "element vertex " + std::to_string(mesh.points.rows()) +
               "\nproperty double x\nproperty double y\nproperty double z\n" + vertex.properties +
               "element face " + std::to_string(mesh.elements.size()) +
               "\nproperty list uchar int vertex_indices\n" + group_properties(groups.size()) +
               face.properties + edge_lines(mesh) + "end_header\n");
    const RowWriter rows(out, options.binary);
    append_vertices(mesh, vertex, rows);
    append_faces(mesh, groups, face, rows);
    append_edges(mesh, rows);
}

} // namespace morph
