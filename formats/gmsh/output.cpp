#include "formats/gmsh/output.h"

#include "formats/gmsh/names.h"
#include "formats/mesh/marker_elements.h"
#include "formats/text/names_in_text.h"

#include <numeric>

namespace morph {

namespace {

/// Components that Gmsh gives to a field: scalar, vector or tensor.
Index padded(Index components)
{
    return components == 1 ? 1 : components <= 3 ? 3 : 9;
}

std::string comments(const MeshData& mesh)
{
    std::string text;
    std::size_t tag = 0;
    const auto physical = [&](int dimension, const std::string& name) {
        ++tag;
        if (!fits_gmsh_quotes(name) || (dimension == 2 && name == kGmshNoGroup))
            text += "physical " + std::to_string(dimension) + " " + std::to_string(tag) + " " +
                    percent_encoded(name) + "\n";
    };
    for (const Marker& marker : mesh.markers)
        physical(1, marker.name);
    for (const ElementGroup& group : mesh.groups)
        physical(2, group.name);
    for (std::size_t f = 0; f < mesh.fields.size(); ++f) {
        const auto components = static_cast<Index>(mesh.fields[f].values.cols());
        if (!fits_gmsh_quotes(mesh.fields[f].name) || padded(components) != components)
            text += "field " + std::to_string(f + 1) + " " + std::to_string(components) + " " +
                    percent_encoded(mesh.fields[f].name) + "\n";
    }
    return text;
}

/// @param rows  of the field, those of tags 1, 2, …
void write_field(GmshOutput& out, const Field& field, const std::vector<Index>& rows)
{
    const std::string name = field.location == FieldLocation::vertex ? "NodeData" : "ElementData";
    const auto components = static_cast<Index>(field.values.cols());
    out.line("$" + name + "\n1\n\"" + gmsh_quotable(field.name) + "\"\n1\n0\n3\n0\n" +
             std::to_string(padded(components)) + "\n" + std::to_string(rows.size()));
    std::int64_t tag = 0;
    for (const Index row : rows) {
        out.begin_record();
        out.integer(++tag);
        for (Index k = 0; k < padded(components); ++k)
            out.real(k < components ? field.values(row, k) : 0);
        out.end_record();
    }
    out.end_numbers();
    out.line("$End" + name);
}

} // namespace

void write_gmsh_header(GmshOutput& out, std::string_view version)
{
    out.line("$MeshFormat");
    out.line(std::string(version) + (out.binary() ? " 1 8" : " 0 8"));
    if (out.binary()) {
        out.begin_record();
        out.integer(1); // marks the byte order
        out.end_record();
        out.end_numbers();
    }
    out.line("$EndMeshFormat");
}

void write_gmsh_names(GmshOutput& out, const MeshData& mesh, Index no_group)
{
    if (const std::string text = comments(mesh); !text.empty())
        out.line("$Comments\n" + std::string(kGmshNamesTitle) + "\n" + text + "$EndComments");
    if (mesh.markers.empty() && mesh.groups.empty())
        return;
    out.line("$PhysicalNames");
    out.line(std::to_string(mesh.markers.size() + mesh.groups.size() + (no_group > 0 ? 1 : 0)));
    std::size_t tag = 0;
    for (const Marker& marker : mesh.markers)
        out.line("1 " + std::to_string(++tag) + " \"" + gmsh_quotable(marker.name) + "\"");
    for (const ElementGroup& group : mesh.groups)
        out.line("2 " + std::to_string(++tag) + " \"" + gmsh_quotable(group.name) + "\"");
    if (no_group > 0)
        out.line("2 " + std::to_string(no_group) + " \"" + std::string(kGmshNoGroup) + "\"");
    out.line("$EndPhysicalNames");
}

void write_gmsh_fields(GmshOutput& out, const MeshData& mesh, const std::vector<Index>& faces)
{
    if (mesh.fields.empty())
        return;
    std::vector<Index> vertices(static_cast<std::size_t>(mesh.points.rows()));
    std::iota(vertices.begin(), vertices.end(), 0);
    std::vector<Index> elements;
    if (!mesh.elements.empty())
        elements = elements_at_markers(mesh);
    elements.insert(elements.end(), faces.begin(), faces.end());
    for (const Field& field : mesh.fields)
        write_field(out, field, field.location == FieldLocation::vertex ? vertices : elements);
}

} // namespace morph
