// The text files of the thesis; see tuc_files.h.
#include "formats/tuc_files.h"
#include "libmorph/mesh/builder.h"

#include <algorithm>

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
                         write_tuc_neighbors(build_mesh(data), out);
                     }});
    for (std::size_t f = 0; f < mesh.fields.size(); ++f)
        for (Eigen::Index c = 0; c < mesh.fields[f].values.cols(); ++c)
            if (mesh.fields[f].location == FieldLocation::vertex)
                files.push_back({"." + file_name_part(component_name(mesh.fields[f], c)) + ".txt",
                                 [f, c](const MeshData& data, OutputFile& out) {
                                     write_tuc_values(data, data.fields[f], c, out);
                                 }});
    return files;
}

std::vector<std::string> losses(const MeshData& mesh, const WriteOptions&)
{
    std::vector<std::string> lost;
    if (mesh.elements.empty()) {
        for (const Field& field : mesh.fields)
            lost.push_back("field " + field.name + " of points without elements");
        return lost;
    }
    std::vector<bool> used(static_cast<std::size_t>(mesh.points.rows()));
    for (const Element& element : mesh.elements)
        for (int k = 0; k < corner_count(element); ++k)
            used[static_cast<std::size_t>(element[static_cast<std::size_t>(k)])] = true;
    const auto unused = std::count(used.begin(), used.end(), false);
    if (unused > 0)
        lost.push_back(std::to_string(unused) + " vertices of no element");
    return lost;
}

} // namespace

extern const Format tuc_format;
const Format tuc_format{.name = "tuc",
                        .extensions = {".txt"},
                        .description = "text files of the thesis",
                        .holds = {.vertex_fields = true},
                        .read = read_tuc,
                        .write = write_tuc,
                        .losses = losses,
                        .companions = companions};

} // namespace morph
