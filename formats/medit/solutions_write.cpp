#include "formats/medit/sink.h"
#include "formats/medit/solutions.h"
#include "formats/text/numbered_names.h"

#include <algorithm>
#include <filesystem>

namespace morph {

namespace {

constexpr std::size_t kBytesOfHeads = 4096; // of the sections, and more than that

/// The types of the solutions that hold a field of some number of components.
std::vector<int> types_of(Eigen::Index components, int dimension)
{
    const Eigen::Index d = dimension;
    if (components == d)
        return {2};
    if (components == d * (d + 1) / 2)
        return {3};
    if (components == d * d)
        return {4};
    return std::vector<int>(static_cast<std::size_t>(components), 1);
}

std::vector<const Field*> fields_at(const MeshData& mesh, FieldLocation location)
{
    std::vector<const Field*> fields;
    for (const Field& field : mesh.fields)
        if (field.location == location)
            fields.push_back(&field);
    return fields;
}

/// Write the rows of @p fields for which @p is_row holds.
template <class IsRow>
void write_section(std::string_view keyword, const std::vector<const Field*>& fields, int dimension,
                   IsRow is_row, MeditSink& sink)
{
    if (fields.empty())
        return;
    std::vector<int> types;
    std::vector<double> line;
    for (const Field* const field : fields) {
        const std::vector<int> more = types_of(field->values.cols(), dimension);
        types.insert(types.end(), more.begin(), more.end());
        line.resize(line.size() + static_cast<std::size_t>(field->values.cols()));
    }
    const Eigen::Index rows = fields.front()->values.rows();
    std::size_t count = 0;
    for (Eigen::Index i = 0; i < rows; ++i)
        count += is_row(i) ? 1 : 0;
    if (count == 0)
        return;
    sink.section(keyword, count, types, line.size(), 0);
    for (Eigen::Index i = 0; i < rows; ++i) {
        if (!is_row(i))
            continue;
        double* to = line.data();
        for (const Field* const field : fields)
            for (Eigen::Index c = 0; c < field->values.cols(); ++c)
                *to++ = field->values(i, c);
        sink.line(line.data(), nullptr);
    }
}

void add_names(const std::vector<const Field*>& fields, int dimension, const std::string& kind,
               std::vector<NumberedName>& names)
{
    std::int64_t number = 1;
    for (const Field* const field : fields) {
        const auto count = static_cast<std::int64_t>(types_of(field->values.cols(), dimension).size());
        names.push_back({kind, number, number + count - 1, field->name});
        number += count;
    }
}

void write_solutions(const MeshData& mesh, OutputFile& out)
{
    std::size_t bytes = kBytesOfHeads;
    for (const Field& field : mesh.fields)
        bytes += static_cast<std::size_t>(field.values.size()) * 8;
    const auto sink = medit_sink(out, is_binary_medit(out.path(), false), mesh.dimension, bytes);
    const auto at_vertices = fields_at(mesh, FieldLocation::vertex);
    const auto at_elements = fields_at(mesh, FieldLocation::element);
    const auto corners_of = [&](Eigen::Index e) {
        return corner_count(mesh.elements[static_cast<std::size_t>(e)]);
    };
    write_section(
        "SolAtVertices", at_vertices, mesh.dimension, [](Eigen::Index) { return true; }, *sink);
    write_section(
        "SolAtTriangles", at_elements, mesh.dimension, [&](Eigen::Index e) { return corners_of(e) == 3; },
        *sink);
    write_section(
        "SolAtQuadrilaterals", at_elements, mesh.dimension,
        [&](Eigen::Index e) { return corners_of(e) == 4; }, *sink);
    std::vector<NumberedName> names;
    add_names(at_vertices, mesh.dimension, "vertex field", names);
    add_names(at_elements, mesh.dimension, "element field", names);
    sink->end("\n" + names_text(names));
}

std::string path_of_solutions(const std::string& mesh_path)
{
    std::filesystem::path path = mesh_path;
    return path.replace_extension(path.extension() == ".meshb" ? ".solb" : ".sol").string();
}

} // namespace

std::vector<Companion> medit_solutions(const MeshData& mesh)
{
    if (mesh.fields.empty())
        return {};
    return {{".sol", write_solutions, path_of_solutions}};
}

} // namespace morph
