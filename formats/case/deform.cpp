#include "formats/case/entries.h"

namespace morph {

namespace {

constexpr Index kMostSteps = 10000;

int steps_of(const TomlTable& table)
{
    if (!table.is_text("steps"))
        return table.integer("steps", 1, kMostSteps).value_or(1);
    table.choice("steps", {"auto"});
    return 0;
}

RigidMarker rigid_marker(const TomlTable& table)
{
    table.require_known({"marker", "distance"});
    const auto marker = table.string("marker");
    if (!marker)
        table.fail_missing("marker", "marker = \"airfoil\"");
    const auto distance = table.number("distance");
    if (!distance)
        table.fail_missing("distance", "distance = 0.02");
    if (!(*distance > 0))
        table.fail(table.line("distance"), "[deform] rigid distance must be above 0");
    return {*marker, *distance};
}

} // namespace

DeformSettings deform_settings(const TomlTable& table)
{
    std::vector<std::string> known{"method",    "diffusivity", "guard", "fixed",
                                   "rotations", "steps",       "slide", "rigid"};
    known.insert(known.end(), method_option_keys().begin(), method_option_keys().end());
    table.require_known(known);
    DeformSettings entry;
    entry.where = table.where();
    entry.method = table.choice<Method>("method").value_or(entry.method);
    entry.diffusivity = table.choice<Diffusivity>("diffusivity").value_or(entry.diffusivity);
    entry.guard = table.choice<Guard>("guard").value_or(entry.guard);
    entry.fixed = table.strings("fixed");
    entry.rotations = table.boolean("rotations");
    entry.steps = steps_of(table);
    entry.slide = table.strings("slide").value_or(std::vector<std::string>());
    const TomlTable::TextsAndTables rigid = table.texts_and_tables("rigid");
    for (const std::string& marker : rigid.texts)
        entry.rigid.push_back({marker, 0});
    for (const TomlTable& item : rigid.tables)
        entry.rigid.push_back(rigid_marker(item));
    read_method_options(table, entry);
    return entry;
}

} // namespace morph
