#include "formats/case/entries.h"
#include "formats/case/entry_numbers.h"

namespace morph {

namespace {

std::string required_boundary(const TomlTable& table)
{
    const auto name = table.string("boundary");
    if (!name)
        table.fail_missing("boundary", "boundary = \"airfoil\", or \"lattice\"");
    return *name;
}

ThicknessSettings thickness_entry(const TomlTable& table)
{
    table.require_known({"boundary", "at", "at_least", "equal", "keep_at_least", "keep"});
    ThicknessSettings entry;
    entry.where = table.where();
    entry.boundary = required_boundary(table);
    const auto at = table.numbers("at");
    if (!at || at->empty())
        table.fail_missing("at", "at = [0.25, 0.5, 0.75]");
    entry.at = *at;
    int given = 0;
    for (const std::string key : {"at_least", "equal", "keep_at_least", "keep"}) {
        const auto value = table.number(key);
        if (!value)
            continue;
        ++given;
        if (!(*value > 0))
            table.fail(table.line(key), "[[constraints.thickness]] " + key + " must be above 0");
        entry.value = *value;
        entry.at_least = key.ends_with("at_least");
        entry.relative = key.starts_with("keep");
    }
    if (given != 1)
        table.fail(table.line(), "[[constraints.thickness]] needs one of at_least and equal (a length), or "
                                 "keep_at_least and keep (a part of the thickness before)");
    return entry;
}

/// Rows [i, j] or [i, j, k], from 0.
std::vector<std::array<Index, 3>> lattice_points(const TomlTable& table)
{
    const Matrix rows = points_of(table, "control_points", {"i", "j", "k"});
    std::vector<std::array<Index, 3>> points;
    for (const auto& row : rows.rowwise()) {
        std::array<Index, 3> point{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double value = row(static_cast<Eigen::Index>(axis));
            if (!(value >= 0 && value < 1e6) || value != static_cast<double>(static_cast<Index>(value)))
                table.fail(table.line("control_points"), "[[constraints.tied]] control_points of a lattice "
                                                         "must be whole numbers [i, j] or [i, j, k], from 0");
            point[axis] = static_cast<Index>(value);
        }
        points.push_back(point);
    }
    return points;
}

TieSettings tied_entry(const TomlTable& table)
{
    table.require_known({"boundary", "control_points"});
    TieSettings entry{table.where(), required_boundary(table), {}};
    if (entry.boundary == kLatticeName)
        entry.points = lattice_points(table);
    else
        for (const Index number : whole_numbers(table, "control_points", 1))
            entry.points.push_back({number, 0, 0});
    if (entry.points.size() < 2)
        table.fail(table.line(),
                   "[[constraints.tied]] needs control_points, at least two: [a, b, ...], from 1, of a "
                   "boundary; [[i, j], ...], from 0, of the lattice");
    return entry;
}

Eigen::Vector3d vector_of(const TomlTable& table, const std::string& key)
{
    const auto values = table.numbers(key).value_or(std::vector<double>{0, 0});
    if (values.size() != 2 && values.size() != 3)
        table.fail(table.line(key), "[[constraints.mirrored]] " + key + " must be [x, y] or [x, y, z]");
    return {values[0], values[1], values.size() == 3 ? values[2] : 0};
}

MirrorSettings mirror_entry(const TomlTable& table)
{
    table.require_known({"boundary", "at", "normal"});
    MirrorSettings entry{table.where(), required_boundary(table), vector_of(table, "at"),
                         vector_of(table, "normal")};
    if (!(entry.normal.norm() > 0))
        table.fail_missing("normal", "normal = [0, 1], across the line of symmetry");
    return entry;
}

} // namespace

ConstraintSettings constraint_settings(const TomlTable& table)
{
    table.require_known({"area", "fixed_vertices", "fixed_points", "thickness", "tied", "mirrored"});
    ConstraintSettings entry;
    entry.where = table.where();
    entry.area = table.strings("area").value_or(std::vector<std::string>());
    entry.fixed_vertices = whole_numbers(table, "fixed_vertices", 0);
    entry.fixed_points = points_of(table, "fixed_points", {"x", "y", "z"});
    for (const TomlTable& item : table.tables("thickness"))
        entry.thicknesses.push_back(thickness_entry(item));
    for (const TomlTable& item : table.tables("tied"))
        entry.ties.push_back(tied_entry(item));
    for (const TomlTable& item : table.tables("mirrored"))
        entry.mirrors.push_back(mirror_entry(item));
    return entry;
}

} // namespace morph
