#include "formats/field_file.h"

#include "formats/csv/fields.h"
#include "formats/input_file.h"
#include "formats/text/number_text.h"
#include "formats/thesis/files.h"
#include "libmorph/core/error.h"

#include <cmath>

namespace morph {

namespace {

constexpr double kSamePlace = 1e-6; // of the mesh's size: what formats of few digits leave

void require_count(const std::string& path, std::size_t found, std::size_t expected, const std::string& what)
{
    if (found != expected)
        throw InputError(path + ": holds fields of " + std::to_string(found) + " " + what +
                         ", but the mesh has " + std::to_string(expected));
}

std::string place(const Points& points, Eigen::Index vertex)
{
    std::string text;
    for (Eigen::Index c = 0; c < (points(vertex, 2) == 0 ? 2 : 3); ++c) {
        text += ' ';
        text += exact_text(points(vertex, c));
    }
    return text;
}

/// @param lines  of the vertices in the file; empty: do not name them
void require_same_places(const std::string& path, const Points& points, const MeshData& mesh,
                         const std::vector<int>& lines)
{
    if (mesh.points.rows() == 0)
        return;
    const double size = (mesh.points.colwise().maxCoeff() - mesh.points.colwise().minCoeff()).norm();
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
        if ((points.row(v) - mesh.points.row(v)).norm() <= kSamePlace * size)
            continue;
        const std::string line =
            lines.empty() ? "" : ":" + std::to_string(lines[static_cast<std::size_t>(v)]);
        throw InputError(path + line + ": vertex " + std::to_string(v) + " is at" + place(points, v) +
                         ", but in the mesh at" + place(mesh.points, v) +
                         "; these are fields of another mesh");
    }
}

void require_finite(const std::string& path, const Field& field)
{
    for (Eigen::Index i = 0; i < field.values.rows(); ++i)
        for (Eigen::Index c = 0; c < field.values.cols(); ++c)
            if (!std::isfinite(field.values(i, c)))
                throw InputError(path + ": field '" + field.name + "' is " + exact_text(field.values(i, c)) +
                                 (field.location == FieldLocation::vertex ? " at vertex " : " in element ") +
                                 std::to_string(i));
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
    for (const Field& field : other.fields)
        require_finite(file.path, field);
    return {std::move(other.fields)};
}

FieldFile read_file(const Format& format, const InputBytes& file, const MeshData& mesh)
{
    if (format.name == "thesis")
        return {{read_thesis_values(file, mesh)}};
    return format.holds.elements ? read_mesh_fields(format, file, mesh) : read_table(file, mesh);
}

} // namespace

FieldFile parse_fields(const InputBytes& file, const MeshData& mesh, const std::string& format)
{
    FieldFile found = read_file(find_format(file.path, format), file, mesh);
    if (found.fields.empty())
        throw InputError(file.path + ": has no fields");
    return found;
}

FieldFile read_fields(const std::string& path, const MeshData& mesh, const std::string& format)
{
    find_format(path, format); // before the file is opened
    const InputFile file(path);
    return parse_fields({path, file.bytes()}, mesh, format);
}

} // namespace morph
