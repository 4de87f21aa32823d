#include "formats/csv/fields.h"

#include "formats/text/number_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace morph {

namespace {

constexpr Eigen::Index kMostComponents = 9;

[[noreturn]] void fail(const CsvTable& table, int line, const std::string& message)
{
    throw InputError(table.path + ":" + std::to_string(line) + ": " + message);
}

/// The vertex a row is for: a whole number below the number of rows.
std::size_t vertex_of(const CsvTable& table, Eigen::Index row, Eigen::Index column)
{
    const double id = table.rows(row, column);
    const auto count = static_cast<double>(table.rows.rows());
    if (!(id >= 0 && id < count && id == std::floor(id)))
        fail(table, table.lines[static_cast<std::size_t>(row)],
             "PointID is " + exact_text(id) + ", but the " + std::to_string(table.rows.rows()) +
                 " row(s) must have the numbers from 0, each once");
    return static_cast<std::size_t>(id);
}

/// Row of the table for each vertex.
std::vector<Eigen::Index> rows_by_id(const CsvTable& table, Eigen::Index column)
{
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(table.rows.rows()), -1);
    for (Eigen::Index r = 0; r < table.rows.rows(); ++r) {
        const std::size_t vertex = vertex_of(table, r, column);
        if (rows[vertex] >= 0)
            fail(table, table.lines[static_cast<std::size_t>(r)],
                 "PointID " + std::to_string(vertex) + " is there again, after line " +
                     std::to_string(table.lines[static_cast<std::size_t>(rows[vertex])]));
        rows[vertex] = r;
    }
    return rows;
}

std::vector<Eigen::Index> rows_in_order(const CsvTable& table)
{
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(table.rows.rows()));
    std::iota(rows.begin(), rows.end(), Eigen::Index{0});
    return rows;
}

/// Some columns side by side. By elements and not by blocks, because a table without rows has no first.
Matrix gathered(const CsvTable& table, const std::vector<Eigen::Index>& rows, Eigen::Index first,
                Eigen::Index count)
{
    Matrix values(static_cast<Eigen::Index>(rows.size()), count);
    for (Eigen::Index i = 0; i < values.rows(); ++i)
        for (Eigen::Index c = 0; c < count; ++c)
            values(i, c) = table.rows(rows[static_cast<std::size_t>(i)], first + c);
    return values;
}

Points gathered_points(const CsvTable& table, const std::vector<Eigen::Index>& rows, Eigen::Index x,
                       Eigen::Index y, std::optional<Eigen::Index> z)
{
    Points points(static_cast<Eigen::Index>(rows.size()), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const Eigen::Index row = rows[static_cast<std::size_t>(i)];
        points.row(i) << table.rows(row, x), table.rows(row, y), z ? table.rows(row, *z) : 0.0;
    }
    return points;
}

bool has_column(const CsvTable& table, const std::string& name)
{
    return std::find(table.columns.begin(), table.columns.end(), name) != table.columns.end();
}

/// A field and how many columns it takes.
struct FieldColumns {
    std::string name;
    Eigen::Index count = 1;
};

/// The field that begins with column @p first.
FieldColumns field_columns(const CsvTable& table, std::size_t first)
{
    const std::string& name = table.columns[first];
    if (name.size() < 3 || !name.ends_with("_0"))
        return {name};
    FieldColumns field{name.substr(0, name.size() - 2)};
    const auto is_next = [&](std::size_t column) {
        return column < table.columns.size() &&
               table.columns[column] == field.name + "_" + std::to_string(field.count);
    };
    while (is_next(first + static_cast<std::size_t>(field.count)))
        ++field.count;
    const bool is_vector =
        field.count >= 2 && field.count <= kMostComponents && !has_column(table, field.name);
    return is_vector ? field : FieldColumns{name};
}

std::vector<Field> fields_of(const CsvTable& table, const std::vector<Eigen::Index>& rows,
                             const std::vector<bool>& taken)
{
    std::vector<Field> fields;
    for (std::size_t c = 0; c < table.columns.size();) {
        if (taken[c]) {
            ++c;
            continue;
        }
        const FieldColumns columns = field_columns(table, c);
        if (columns.name.empty())
            fail(table, table.header_line, "column " + std::to_string(c + 1) + " has no name");
        fields.push_back({columns.name, FieldLocation::vertex,
                          gathered(table, rows, static_cast<Eigen::Index>(c), columns.count)});
        c += static_cast<std::size_t>(columns.count);
    }
    return fields;
}

/// The name as a cell of the header: in quotes where a comma, a quote or a blank needs it.
std::string header_cell(const std::string& name, bool always_quoted)
{
    if (!always_quoted && name.find_first_of(",\" \t") == std::string::npos)
        return name;
    std::string cell = "\"";
    for (const char c : name)
        cell += c == '"' ? "\"\"" : std::string(1, c);
    return cell + '"';
}

/// The columns of the nodal fields, in their order.
std::vector<std::string> field_column_names(const MeshData& mesh)
{
    std::vector<std::string> names;
    for (const Field& field : mesh.fields) {
        if (field.location != FieldLocation::vertex)
            continue;
        if (field.values.cols() == 1)
            names.push_back(field.name);
        else
            for (Eigen::Index c = 0; c < field.values.cols(); ++c)
                names.push_back(field.name + "_" + std::to_string(c));
    }
    return names;
}

void require_legible(const std::string& name, const std::string& path)
{
    if (name.empty() || name.find_first_of("\r\n") != std::string::npos)
        throw InputError(path + ": csv cannot hold a field whose name is empty or has a line end; rename it");
    constexpr std::array<std::string_view, 4> kNoFields{"x", "y", "z", "PointID"};
    const auto taken = std::find_if(kNoFields.begin(), kNoFields.end(), [&](std::string_view column) {
        return equals_without_case(name, column);
    });
    if (taken != kNoFields.end())
        throw InputError(path + ": csv cannot hold a field called '" + name + "', because the column " +
                         std::string(*taken) + " has a meaning of its own; rename it");
}

/// Otherwise the file would read back with fields for coordinates, or not at all.
void require_legible(std::vector<std::string> names, const std::string& path)
{
    for (const std::string& name : names)
        require_legible(name, path);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end())
        throw InputError(path + ": csv cannot hold two fields that both need the column '" + *twice +
                         "'; rename one");
}

std::string header(const MeshData& mesh, bool as_restart, const std::string& path)
{
    const std::vector<std::string> fields = field_column_names(mesh);
    require_legible(fields, path);
    std::vector<std::string> names{"x", "y"};
    if (as_restart)
        names.insert(names.begin(), "PointID");
    if (mesh.dimension == 3)
        names.emplace_back("z");
    names.insert(names.end(), fields.begin(), fields.end());
    std::string line;
    for (const std::string& name : names) {
        line += header_cell(name, as_restart);
        line += ',';
    }
    line.back() = '\n';
    return line;
}

} // namespace

CsvNodes csv_nodes(const CsvTable& table)
{
    const auto x = find_csv_column(table, "x");
    const auto y = find_csv_column(table, "y");
    const auto z = find_csv_column(table, "z");
    const auto id = find_csv_column(table, "PointID");
    if (x.has_value() != y.has_value())
        fail(table, table.header_line, x ? "has a column x, but none y" : "has a column y, but none x");
    CsvNodes nodes;
    nodes.has_ids = id.has_value();
    const std::vector<Eigen::Index> rows = id ? rows_by_id(table, *id) : rows_in_order(table);
    for (const Eigen::Index row : rows)
        nodes.lines.push_back(table.lines[static_cast<std::size_t>(row)]);
    std::vector<bool> taken(table.columns.size());
    for (const auto& column : {x, y, x ? z : std::nullopt, id})
        if (column)
            taken[static_cast<std::size_t>(*column)] = true;
    if (x)
        nodes.points = gathered_points(table, rows, *x, *y, z);
    nodes.fields = fields_of(table, rows, taken);
    return nodes;
}

MeshData csv_mesh(const CsvTable& table)
{
    CsvNodes nodes = csv_nodes(table);
    if (!nodes.points)
        fail(table, table.header_line,
             "has no columns x and y, which say where the points are, but " + joined(table.columns));
    MeshData mesh;
    mesh.points = std::move(*nodes.points);
    mesh.dimension = dimension_of(mesh.points);
    mesh.fields = std::move(nodes.fields);
    return mesh;
}

void write_csv_nodes(const MeshData& mesh, bool as_restart, OutputFile& out)
{
    out.append(header(mesh, as_restart, out.path()));
    std::size_t numbers = 4; // PointID, x, y, z
    for (const Field& field : mesh.fields)
        numbers += static_cast<std::size_t>(field.values.cols());
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        char* end = out.room(numbers * kLongestNumber);
        if (as_restart)
            end = number_text(end, v, ',');
        for (Eigen::Index c = 0; c < mesh.dimension; ++c)
            end = number_text(end, mesh.points(v, c), ',');
        for (const Field& field : mesh.fields)
            for (Eigen::Index c = 0; c < field.values.cols() && field.location == FieldLocation::vertex; ++c)
                end = number_text(end, field.values(v, c), ',');
        end[-1] = '\n';
        out.advance_to(end);
    }
}

} // namespace morph
