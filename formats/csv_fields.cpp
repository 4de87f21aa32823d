#include "formats/csv_fields.h"

#include "formats/number_text.h"
#include "formats/surface.h"
#include "libmorph/core/error.h"

#include <string>

namespace morph {

namespace {

constexpr Eigen::Index kMostComponents = 9;

/// Row of the table for each vertex.
std::vector<Eigen::Index> rows_by_id(const CsvTable& table, Eigen::Index column)
{
    std::vector<Eigen::Index> row(static_cast<std::size_t>(table.rows.rows()), -1);
    for (Eigen::Index r = 0; r < table.rows.rows(); ++r) {
        const double id = table.rows(r, column);
        const std::string line = table.path + ":" + std::to_string(table.lines[static_cast<std::size_t>(r)]);
        if (!(id >= 0 && id < static_cast<double>(row.size()) &&
              id == static_cast<double>(static_cast<Index>(id))))
            throw InputError(line + ": " + table.columns[static_cast<std::size_t>(column)] +
                             " is not one of the " + "numbers from 0 to " + std::to_string(row.size() - 1) +
                             ", one for each of the table's rows");
        Eigen::Index& place = row[static_cast<std::size_t>(id)];
        if (place >= 0)
            throw InputError(line + ": " + table.columns[static_cast<std::size_t>(column)] + " " +
                             std::to_string(static_cast<Index>(id)) +
                             " is there a second time; the first was in line " +
                             std::to_string(table.lines[static_cast<std::size_t>(place)]));
        place = r;
    }
    return row;
}

std::vector<Eigen::Index> rows_in_order(const CsvTable& table)
{
    std::vector<Eigen::Index> rows;
    for (Eigen::Index r = 0; r < table.rows.rows(); ++r)
        rows.push_back(r);
    return rows;
}

/// How many columns from @p first on are called base_0, base_1, ...; 0 when the first is not.
Eigen::Index components_from(const CsvTable& table, std::size_t first, std::string& base)
{
    const std::string& name = table.columns[first];
    if (name.size() < 3 || !name.ends_with("_0"))
        return 0;
    base = name.substr(0, name.size() - 2);
    Eigen::Index count = 1;
    while (count < kMostComponents && first + static_cast<std::size_t>(count) < table.columns.size() &&
           table.columns[first + static_cast<std::size_t>(count)] == base + "_" + std::to_string(count))
        ++count;
    return count;
}

std::vector<Field> fields_of(const CsvTable& table, const std::vector<Eigen::Index>& rows,
                             const std::vector<bool>& taken)
{
    std::vector<Field> fields;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        if (taken[c])
            continue;
        std::string name;
        Eigen::Index components = components_from(table, c, name);
        if (components < 2) { // v_0 alone is a name like any other
            components = 1;
            name = table.columns[c];
        }
        fields.push_back({name, FieldLocation::vertex,
                          table.rows.middleCols(static_cast<Eigen::Index>(c), components)(rows, Eigen::all)});
        c += static_cast<std::size_t>(components) - 1;
    }
    return fields;
}

/// The name as a cell of the header: in quotes where a comma, a quote or a blank at its ends needs it.
std::string header_cell(const std::string& name, bool always_quoted)
{
    std::string cell;
    for (const char c : name)
        cell += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
    const bool plain =
        !name.empty() && name.front() != '#' && name.find_first_of(",\" \t") == std::string::npos;
    return plain && !always_quoted ? cell : '"' + cell + '"';
}

std::string header(const MeshData& mesh, bool as_restart)
{
    std::vector<std::string> names{"x", "y"};
    if (as_restart)
        names.insert(names.begin(), "PointID");
    if (mesh.dimension == 3)
        names.emplace_back("z");
    for (const Field& field : mesh.fields) {
        if (field.location != FieldLocation::vertex)
            continue;
        if (field.values.cols() == 1)
            names.push_back(field.name);
        for (Eigen::Index c = 0; c < field.values.cols() && field.values.cols() > 1; ++c)
            names.push_back(field.name + "_" + std::to_string(c));
    }
    std::string line;
    for (const std::string& name : names)
        line += (line.empty() ? "" : ",") + header_cell(name, as_restart);
    return line + '\n';
}

} // namespace

void write_csv_nodes(const MeshData& mesh, bool as_restart, OutputFile& out)
{
    out.append(header(mesh, as_restart));
    std::size_t numbers = 4;
    for (const Field& field : mesh.fields)
        numbers += static_cast<std::size_t>(field.values.cols());
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        char* end = out.room((numbers + 1) * kLongestNumber);
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

MeshData mesh_of(CsvNodes nodes, const std::string& path)
{
    if (!nodes.points)
        throw InputError(path + ":1: has no columns x and y, which say where the points are");
    MeshData mesh;
    mesh.points = std::move(*nodes.points);
    mesh.dimension = dimension_of(mesh.points);
    mesh.fields = std::move(nodes.fields);
    return mesh;
}

CsvNodes csv_nodes(const CsvTable& table)
{
    const auto x = find_csv_column(table, "x"), y = find_csv_column(table, "y"),
               z = find_csv_column(table, "z");
    const auto id = find_csv_column(table, "PointID");
    if (x.has_value() != y.has_value())
        throw InputError(table.path + ": has a column " + (x ? "x, but none y" : "y, but none x"));
    CsvNodes nodes;
    nodes.has_ids = id.has_value();
    const std::vector<Eigen::Index> rows = id ? rows_by_id(table, *id) : rows_in_order(table);
    for (const Eigen::Index row : rows)
        nodes.lines.push_back(table.lines[static_cast<std::size_t>(row)]);
    std::vector<bool> taken(table.columns.size());
    for (const auto& column : {x, y, x ? z : std::nullopt, id})
        if (column)
            taken[static_cast<std::size_t>(*column)] = true;
    if (x) {
        nodes.points.emplace(Points::Zero(table.rows.rows(), 3));
        nodes.points->col(0) = table.rows.col(*x)(rows);
        nodes.points->col(1) = table.rows.col(*y)(rows);
        if (z)
            nodes.points->col(2) = table.rows.col(*z)(rows);
    }
    nodes.fields = fields_of(table, rows, taken);
    return nodes;
}

} // namespace morph
