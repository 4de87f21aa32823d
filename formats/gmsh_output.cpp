#include "formats/gmsh_output.h"

#include "formats/gmsh_names.h"
#include "formats/vtk_legacy.h"

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
        if (!fits_gmsh_quotes(name))
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

void write_field(GmshOutput& out, const Field& field, std::int64_t first_tag)
{
    const std::string name = field.location == FieldLocation::vertex ? "NodeData" : "ElementData";
    const auto components = static_cast<Index>(field.values.cols());
    out.line("$" + name + "\n1\n\"" + gmsh_quotable(field.name) + "\"\n1\n0\n3\n0\n" +
             std::to_string(padded(components)) + "\n" + std::to_string(field.values.rows()));
    for (Eigen::Index row = 0; row < field.values.rows(); ++row) {
        out.begin_record();
        out.integer(first_tag + row);
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
        out.integer(1); // tells the byte order
        out.end_record();
        out.end_numbers();
    }
    out.line("$EndMeshFormat");
}

void write_gmsh_names(GmshOutput& out, const MeshData& mesh)
{
    if (const std::string text = comments(mesh); !text.empty())
        out.line("$Comments\n" + std::string(kGmshNamesTitle) + "\n" + text + "$EndComments");
    if (mesh.markers.empty() && mesh.groups.empty())
        return;
    out.line("$PhysicalNames");
    out.line(std::to_string(mesh.markers.size() + mesh.groups.size()));
    std::size_t tag = 0;
    for (const Marker& marker : mesh.markers)
        out.line("1 " + std::to_string(++tag) + " \"" + gmsh_quotable(marker.name) + "\"");
    for (const ElementGroup& group : mesh.groups)
        out.line("2 " + std::to_string(++tag) + " \"" + gmsh_quotable(group.name) + "\"");
    out.line("$EndPhysicalNames");
}

void write_gmsh_fields(GmshOutput& out, const MeshData& mesh, std::int64_t first_element)
{
    for (const Field& field : mesh.fields)
        write_field(out, field, field.location == FieldLocation::vertex ? 1 : first_element);
}

} // namespace morph
