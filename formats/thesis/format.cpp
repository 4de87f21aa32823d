// The text files of the thesis; see files.h.
#include "formats/formats.h"
#include "formats/thesis/files.h"

namespace morph {

namespace {

std::string component_name(const Field& field, Eigen::Index component)
{
    return field.values.cols() == 1 ? field.name : field.name + "_" + std::to_string(component);
}

/// The name of a field as a part of a file's name.
std::string file_name_part(std::string name)
{
    for (char& c : name)
        if (c == '/' || c == '\0' || c == '\n' || c == '\r')
            c = '_';
    return name;
}

std::vector<Companion> companions(const MeshData& mesh)
{
    std::vector<Companion> files;
    if (mesh.elements.empty())
        return files;
    files.push_back({".neighbours.txt", [](const MeshData& data, OutputFile& out) {
                         write_thesis_neighbors(build_mesh_of(data, out.path()), out);
                     }});
    for (std::size_t f = 0; f < mesh.fields.size(); ++f)
        for (Eigen::Index c = 0; c < mesh.fields[f].values.cols(); ++c)
            if (mesh.fields[f].location == FieldLocation::vertex)
                files.push_back({"." + file_name_part(component_name(mesh.fields[f], c)) + ".txt",
                                 [f, c](const MeshData& data, OutputFile& out) {
                                     write_thesis_values(data, data.fields[f], c, out);
                                 }});
    return files;
}

} // namespace

extern const Format thesis_format;
const Format thesis_format{.name = "thesis",
                           .extensions = {".txt"},
                           .description = "text files of the thesis",
                           .holds = {.vertex_fields = true},
                           .read = read_thesis,
                           .write = write_thesis,
                           .losses = thesis_losses,
                           .companions = companions,
                           .old_name = "tuc"};

} // namespace morph
