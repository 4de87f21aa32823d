#include "formats/element_groups.h"
#include "formats/names_in_text.h"
#include "formats/om_files.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace morph {

namespace {

constexpr std::uint8_t kVersion = 1U << 5 | 2U; ///< 1.2
constexpr std::size_t kLongestName = 255;

/// The bytes of a number, little-endian as OpenMesh writes them on every machine.
template <class T>
void append_number_bytes(OutputFile& out, T number)
{
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
    if (std::endian::native != std::endian::little)
        std::reverse(raw.begin(), raw.end());
    out.advance_to(std::copy(raw.begin(), raw.end(), out.room(raw.size())));
}

void append_chunk(OutputFile& out, const OmChunk& chunk)
{
    const unsigned value = (chunk.named ? 2U : 0U) | static_cast<unsigned>(chunk.entity) << 2 |
                           static_cast<unsigned>(chunk.type) << 5 | (chunk.real ? 3U << 9 : 0U) |
                           (chunk.dimension - 1) << 11 | chunk.bits << 14;
    append_number_bytes(out, static_cast<std::uint16_t>(value));
}

void append_custom(OutputFile& out, OmEntity entity, std::string_view name, std::size_t bytes)
{
    append_chunk(out, {.entity = entity, .type = OmType::custom, .named = true});
    append_number_bytes(out, static_cast<std::uint8_t>(name.size()));
    out.append(name);
    append_number_bytes(out, static_cast<std::uint32_t>(bytes));
}

/// 'T' or 'Q' when all elements are alike, else 'P', which gives each its number of corners.
char mesh_type(const MeshData& mesh)
{
    const auto triangles = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                         [](const Element& element) { return corner_count(element) == 3; });
    const auto all = static_cast<std::ptrdiff_t>(mesh.elements.size());
    return triangles == all ? 'T' : triangles == 0 ? 'Q' : 'P';
}

void append_header(const MeshData& mesh, OutputFile& out)
{
    out.append("OM");
    append_number_bytes(out, mesh_type(mesh));
    append_number_bytes(out, kVersion);
    append_number_bytes(out, static_cast<std::uint32_t>(mesh.points.rows()));
    append_number_bytes(out, static_cast<std::uint32_t>(mesh.elements.size()));
    append_number_bytes(out, std::uint32_t{0}); // edges, which readers of this version count themselves
}

void append_points(const MeshData& mesh, OutputFile& out)
{
    if (mesh.points.rows() == 0)
        return;
    append_chunk(out, {.type = OmType::position, .real = true, .dimension = 3, .bits = 1});
    for (Eigen::Index i = 0; i < mesh.points.size(); ++i)
        append_number_bytes(out, mesh.points.data()[i]);
}

void append_faces(const MeshData& mesh, OutputFile& out)
{
    if (mesh.elements.empty())
        return;
    append_chunk(out, {.entity = OmEntity::face, .type = OmType::topology, .bits = 2});
    const bool counted = mesh_type(mesh) == 'P';
    for (const Element& element : mesh.elements) {
        if (counted)
            append_number_bytes(out, static_cast<std::uint16_t>(corner_count(element)));
        for (int k = 0; k < corner_count(element); ++k)
            append_number_bytes(out, element[static_cast<std::size_t>(k)]);
    }
}

/// Names of properties: no two alike for one entity, short, and not like "v:points", which OpenMesh keeps
/// for itself.
std::string property_name(const std::string& wanted, std::vector<std::string>& taken)
{
    std::string name = wanted.substr(0, kLongestName - 20);
    std::replace(name.begin(), name.end(), '\0', '_');
    if (name.empty() || name.starts_with("libmorph ") || (name.size() > 1 && name[1] == ':'))
        name.insert(0, "field ");
    std::string unused = name;
    for (int i = 1; std::find(taken.begin(), taken.end(), unused) != taken.end(); ++i)
        unused = name + "_" + std::to_string(i);
    taken.push_back(unused);
    return unused;
}

std::string numbered_names(const std::string& kind, const auto& named)
{
    std::string lines;
    for (std::size_t i = 0; i < named.size(); ++i)
        lines += kind + " " + std::to_string(i + 1) + " " + line_name(named[i].name) + "\n";
    return lines;
}

/// Append the fields as properties; returns the lines that say what they are.
std::string append_fields(const MeshData& mesh, OutputFile& out)
{
    std::string lines;
    std::vector<std::string> vertex_names;
    std::vector<std::string> face_names;
    for (const Field& field : mesh.fields) {
        const bool nodal = field.location == FieldLocation::vertex;
        const std::string name = property_name(field.name, nodal ? vertex_names : face_names);
        append_custom(out, nodal ? OmEntity::vertex : OmEntity::face, name,
                      static_cast<std::size_t>(field.values.size()) * sizeof(double));
        for (Eigen::Index i = 0; i < field.values.size(); ++i)
            append_number_bytes(out, field.values.data()[i]);
        lines += std::string(nodal ? "vertex" : "face") + "_field " + line_name(name, " ") + " " +
                 std::to_string(field.values.cols()) + " " + line_name(field.name) + "\n";
    }
    return lines;
}

void append_groups(const MeshData& mesh, OutputFile& out)
{
    const std::vector<std::vector<Index>> columns = group_columns(mesh);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        append_custom(out, OmEntity::face, "libmorph group " + std::to_string(k),
                      columns[k].size() * sizeof(Index));
        for (const Index number : columns[k])
            append_number_bytes(out, number);
    }
}

void append_markers(const MeshData& mesh, OutputFile& out)
{
    std::size_t edges = 0;
    for (const Marker& marker : mesh.markers)
        edges += marker.edges.size();
    append_custom(out, OmEntity::mesh, kOmMarkers, 3 * sizeof(Index) * edges);
    for (std::size_t m = 0; m < mesh.markers.size(); ++m)
        for (const auto& [from, to] : mesh.markers[m].edges)
            for (const Index number : {from, to, static_cast<Index>(m + 1)})
                append_number_bytes(out, number);
}

} // namespace

void write_om(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    append_header(mesh, out);
    append_points(mesh, out);
    append_faces(mesh, out);
    const std::string lines = append_fields(mesh, out) + numbered_names("group", mesh.groups) +
                              numbered_names("marker", mesh.markers);
    append_groups(mesh, out);
    if (!mesh.markers.empty())
        append_markers(mesh, out);
    if (lines.empty())
        return;
    append_custom(out, OmEntity::mesh, kOmNames, lines.size());
    out.append(lines);
}

} // namespace morph
