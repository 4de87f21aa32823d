#include "formats/case/entries.h"
#include "formats/case/entry_numbers.h"

namespace morph {

namespace {

PullSettings pull_entry(const TomlTable& table)
{
    table.require_known({"vertices", "points", "displacements"});
    if (table.has("vertices") == table.has("points"))
        table.fail(table.line(), "[[pull]] needs either vertices or points, not both and not neither");
    PullSettings entry;
    entry.where = table.where();
    entry.vertices = whole_numbers(table, "vertices", 0);
    entry.points = points_of(table, "points", {"x", "y", "z"});
    if (!table.has("displacements"))
        table.fail_missing("displacements", "displacements = [[0.0, 0.02]]");
    entry.displacements = points_of(table, "displacements", {"dx", "dy", "dz"});
    const auto expected = entry.points.rows() + static_cast<Eigen::Index>(entry.vertices.size());
    if (entry.displacements.rows() != expected)
        table.fail(table.line("displacements"),
                   "[[pull]] displacements has " + std::to_string(entry.displacements.rows()) +
                       " rows, but there are " + std::to_string(expected) + " points");
    return entry;
}

} // namespace

std::vector<PullSettings> pull_settings(const TomlTable& root)
{
    std::vector<PullSettings> entries;
    for (const TomlTable& table : root.tables("pull"))
        entries.push_back(pull_entry(table));
    return entries;
}

} // namespace morph
