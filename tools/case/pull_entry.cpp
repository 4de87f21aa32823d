#include "tools/case/pull_entry.h"

namespace morph::tools {

namespace {

const std::vector<std::string> kPlane{"x", "y"};
const std::vector<std::string> kSpace{"x", "y", "z"};
const std::vector<std::string> kPlaneMove{"dx", "dy"};
const std::vector<std::string> kSpaceMove{"dx", "dy", "dz"};

/// Whole numbers, lowered by @p base.
std::vector<Index> whole_numbers(const TomlTable& table, const std::string& key, Index base)
{
    constexpr double kMost = 2147483647;
    std::vector<Index> numbers;
    for (const double value : table.numbers(key).value_or(std::vector<double>())) {
        if (!(value >= base && value <= kMost && value == static_cast<double>(static_cast<Index>(value))))
            table.fail(table.line(key), key + " must be whole numbers from " + std::to_string(base) + " on");
        numbers.push_back(static_cast<Index>(value) - base);
    }
    return numbers;
}

Matrix in_space(const Matrix& rows)
{
    Matrix full = Matrix::Zero(rows.rows(), 3);
    full.leftCols(rows.cols()) = rows;
    return full;
}

/// Rows of two or three numbers, whichever the first row has.
Matrix points_of(const TomlTable& table, const std::string& key, const std::vector<std::string>& plane,
                 const std::vector<std::string>& space)
{
    if (!table.has(key))
        return Matrix::Zero(0, 3);
    return in_space(*table.rows(key, table.row_width(key) == 3 ? space : plane));
}

PullEntry pull_entry(const TomlTable& table)
{
    table.require_known({"vertices", "points", "displacements"});
    if (table.has("vertices") == table.has("points"))
        table.fail(table.line(), "[[pull]] needs either vertices or points, not both and not neither");
    PullEntry entry;
    entry.line = table.line();
    entry.vertices = whole_numbers(table, "vertices", 0);
    entry.points = points_of(table, "points", kPlane, kSpace);
    if (!table.has("displacements"))
        table.fail_missing("displacements", "displacements = [[0.0, 0.02]]");
    entry.displacements = points_of(table, "displacements", kPlaneMove, kSpaceMove);
    const auto wanted = entry.points.rows() + static_cast<Eigen::Index>(entry.vertices.size());
    if (entry.displacements.rows() != wanted)
        table.fail(table.line("displacements"),
                   "[[pull]] displacements has " + std::to_string(entry.displacements.rows()) +
                       " rows, but there are " + std::to_string(wanted) + " points");
    return entry;
}

} // namespace

std::vector<PullEntry> pull_entries(const TomlTable& root)
{
    std::vector<PullEntry> entries;
    for (const TomlTable& table : root.tables("pull"))
        entries.push_back(pull_entry(table));
    return entries;
}

} // namespace morph::tools
