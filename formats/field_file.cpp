#include "formats/field_file.h"

#include "formats/csv_fields.h"
#include "formats/formats.h"
#include "formats/input_file.h"
#include "formats/tuc_files.h"
#include "libmorph/core/error.h"

namespace morph {

namespace {

constexpr double kSamePlace = 1e-6; // of the mesh's size: what formats of few digits leave

void require_count(const std::string& path, std::size_t found, std::size_t expected, const std::string& what)
{
    if (found != expected)
        throw InputError(path + ": holds fields of " + std::to_string(found) + " " + what +
                         ", but the mesh has " + std::to_string(expected));
}

/// @param lines  of the rows in the file; empty: do not name them
void require_same_places(const std::string& path, const Points& points, const MeshData& mesh,
                         const std::vector<int>& lines)
{
    if (mesh.points.rows() == 0)
        return;
    const double size = (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff()).norm();
    for (Eigen::Index v = 0; v < points.rows(); ++v)
        if (!((points.row(v) - mesh.points.row(v)).norm() <= kSamePlace * size))
            throw InputError(path +
                             (lines.empty() ? "" : ":" + std::to_string(lines[static_cast<std::size_t>(v)])) +
                             ": vertex " + std::to_string(v) +
                             " lies elsewhere than in the mesh; these are the fields of another mesh");
}

FieldFile read_table(const InputBytes& file, const MeshData& mesh)
{
    CsvNodes nodes = csv_nodes(parse_csv_table(file.bytes, file.path));
    require_count(file.path, nodes.lines.size(), static_cast<std::size_t>(mesh.points.rows()), "vertices");
    if (nodes.points)
        require_same_places(file.path, *nodes.points, mesh, nodes.lines);
    return {std::move(nodes.fields), nodes.has_ids};
}

FieldFile read_mesh_fields(const Format& format, const InputBytes& file, const MeshData& mesh)
{
    MeshData other = format.read(file);
    require_count(file.path, static_cast<std::size_t>(other.points.rows()),
                  static_cast<std::size_t>(mesh.points.rows()), "vertices");
    require_count(file.path, other.elements.size(), mesh.elements.size(), "elements");
    require_same_places(file.path, other.points, mesh, {});
    return {std::move(other.fields)};
}

} // namespace

FieldFile read_fields(const std::string& path, const MeshData& mesh, const std::string& format)
{
    const Format& reader = find_format(path, format);
    const InputFile input(path);
    const InputBytes file{path, input.bytes()};
    if (reader.name == "tuc")
        return {{read_tuc_values(file, mesh)}};
    return reader.holds.elements ? read_mesh_fields(reader, file, mesh) : read_table(file, mesh);
}

} // namespace morph
