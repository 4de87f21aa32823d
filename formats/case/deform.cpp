#include "tools/case/deform_entry.h"

namespace morph::tools {

namespace {

constexpr Index kMostSteps = 10000;

int steps_of(const TomlTable& table)
{
    if (!table.is_text("steps"))
        return table.integer("steps", 1, kMostSteps).value_or(1);
    table.choice("steps", {"auto"});
    return 0;
}

RigidEntry rigid_entry(const TomlTable& table)
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
    return {table.line(), *marker, *distance};
}

} // namespace

const std::vector<std::string>& move_methods()
{
    static const std::vector<std::string> names{"harmonic", "ffd",        "rbf",    "idw",
                                                "damping",  "elasticity", "spring", "biharmonic"};
    return names;
}

const std::vector<std::string>& diffusivities()
{
    static const std::vector<std::string> names{"uniform", "inverse-distance", "inverse-area"};
    return names;
}

const std::vector<std::string>& guards()
{
    static const std::vector<std::string> names{"none", "check", "untangle", "remesh"};
    return names;
}

bool uses_rotations(const DeformEntry& deform)
{
    return deform.rotations.value_or(deform.method == "idw");
}

DeformEntry deform_entry(const TomlTable& table)
{
    std::vector<std::string> known{"method",    "diffusivity", "guard", "fixed",
                                   "rotations", "steps",       "slide", "rigid"};
    known.insert(known.end(), method_option_keys().begin(), method_option_keys().end());
    table.require_known(known);
    DeformEntry entry;
    entry.line = table.line();
    entry.method = table.choice("method", move_methods()).value_or(entry.method);
    entry.diffusivity = table.choice("diffusivity", diffusivities()).value_or(entry.diffusivity);
    entry.guard = table.choice("guard", guards()).value_or(entry.guard);
    entry.fixed = table.strings("fixed");
    entry.rotations = table.boolean("rotations");
    entry.steps = steps_of(table);
    entry.slide = table.strings("slide").value_or(std::vector<std::string>());
    const TomlTable::TextsAndTables rigid = table.texts_and_tables("rigid");
    for (const std::string& marker : rigid.texts)
        entry.rigid.push_back({table.line("rigid"), marker, 0});
    for (const TomlTable& item : rigid.tables)
        entry.rigid.push_back(rigid_entry(item));
    entry.options = method_options(table);
    return entry;
}

} // namespace morph::tools
