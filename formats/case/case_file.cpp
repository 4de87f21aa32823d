#include "tools/case/case_file.h"

#include "formats/input_file.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "tools/case/toml_table.h"

#include <algorithm>
#include <limits>

namespace morph::tools {

namespace {

constexpr Index kMostNodes = 10'000'000;

GenerateEntry generate_entry(const TomlTable& table)
{
    table.require_known({"box", "size"});
    const auto box = table.numbers("box");
    if (!box)
        table.fail_missing("box", "box = [-15, -5, 25, 25]");
    if (box->size() != 4)
        table.fail(table.line("box"), "box must be four numbers [xmin, ymin, xmax, ymax]");
    const auto size = table.number("size");
    if (!size)
        table.fail_missing("size", "size = 1.0");
    GenerateEntry entry;
    std::copy(box->begin(), box->end(), entry.box.begin());
    entry.size = *size;
    if (!(entry.box[0] < entry.box[2] && entry.box[1] < entry.box[3]))
        table.fail(table.line("box"), "box has no area: xmin must be below xmax and ymin below ymax");
    if (!(entry.size > 0))
        table.fail(table.line("size"), "size must be above 0");
    return entry;
}

void read_mesh_section(const TomlTable& root, CaseFile& file)
{
    const auto table = root.table("mesh", "[mesh]");
    if (!table)
        root.fail(1, "the case needs a table [mesh] with file = \"...\" or generate = { ... }");
    table->require_known({"file", "generate"});
    if (table->has("file") == table->has("generate"))
        table->fail(table->line(), "[mesh] needs either file or generate, not both and not neither");
    if (const auto name = table->string("file"))
        file.mesh_file = beside(file.path, *name);
    if (const auto generate = table->table("generate", "[mesh] generate"))
        file.generate = generate_entry(*generate);
}

/// Displacements as given, or as the difference to the moved control points.
Points2 displacements_of(const TomlTable& table, const Points2& control_points)
{
    if (table.has("displacements") && table.has("moved"))
        table.fail(table.line("moved"), "[[boundary]] takes displacements or moved, not both");
    const std::string key = table.has("moved") ? "moved" : "displacements";
    const bool moved = key == "moved";
    auto rows =
        table.pairs(key, moved ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{"dx", "dy"});
    if (!rows)
        return Points2::Zero(control_points.rows(), 2);
    if (rows->rows() != control_points.rows())
        table.fail(table.line(key), "[[boundary]] " + key + " has " + std::to_string(rows->rows()) +
                                        " rows, but there are " + std::to_string(control_points.rows()) +
                                        " control points");
    return moved ? Points2(*rows - control_points) : *rows;
}

CurveDefinition curve_of(const TomlTable& table)
{
    const auto control_points = table.pairs("control_points", {"x", "y"});
    if (!control_points)
        table.fail_missing("control_points", "control_points = [[0, 0], [1, 0], [1, 1]]");
    CurveDefinition curve;
    curve.control_points = *control_points;
    curve.degree = table.integer("degree", 1, kMaxDegree).value_or(3);
    curve.closed = table.boolean("closed").value_or(false);
    curve.knots = table.numbers("knots").value_or(std::vector<double>());
    curve.weights = table.numbers("weights").value_or(std::vector<double>());
    return curve;
}

BoundaryEntry boundary_entry(const TomlTable& table)
{
    table.require_known({"name", "degree", "closed", "control_points", "knots", "weights", "nodes",
                         "displacements", "moved"});
    const auto name = table.string("name");
    if (!name)
        table.fail_missing("name", "name = \"airfoil\"");
    BoundaryEntry entry;
    entry.name = *name;
    entry.line = table.line();
    entry.curve = curve_of(table);
    entry.nodes = table.integer("nodes", 1, kMostNodes).value_or(0);
    entry.displacements = displacements_of(table, entry.curve.control_points);
    try {
        const Curve checked(entry.curve);
    } catch (const InputError& error) {
        table.fail(entry.line, "boundary '" + entry.name + "': " + error.what());
    }
    return entry;
}

void read_boundaries(const TomlTable& root, CaseFile& file)
{
    for (const TomlTable& table : root.tables("boundary")) {
        BoundaryEntry entry = boundary_entry(table);
        for (const BoundaryEntry& other : file.boundaries)
            if (other.name == entry.name)
                table.fail(entry.line, "boundary '" + entry.name + "' is given twice, first in line " +
                                           std::to_string(other.line));
        file.boundaries.push_back(std::move(entry));
    }
    if (file.boundaries.empty() && !file.lattice)
        root.fail(
            1,
            "the case has no [[boundary]] and no [lattice], so there is nothing to move; morph-fit makes a "
            "boundary from a marker");
}

void read_output_section(const TomlTable& root, CaseFile& file)
{
    const auto table = root.table("output", "[output]");
    if (!table)
        return;
    table->require_known({"mesh"});
    if (const auto name = table->string("mesh"))
        file.output_mesh = beside(file.path, *name);
}

toml::table parse(std::string_view bytes, const std::string& path)
{
    try {
        return toml::parse(bytes, path);
    } catch (const toml::parse_error& error) {
        throw InputError(path + ":" + std::to_string(error.source().begin.line) + ": " +
                         std::string(error.description()));
    }
}

} // namespace

CaseFile read_case_file(const std::string& path)
{
    const InputFile file(path);
    return parse_case_file(file.bytes(), path);
}

CaseFile parse_case_file(std::string_view bytes, const std::string& path)
{
    const toml::table document = parse(bytes, path);
    const TomlTable root(document, path, "the case file");
    root.require_known({"mesh", "boundary", "lattice", "pull", "constraints", "deform", "output"});
    CaseFile file;
    file.path = path;
    read_mesh_section(root, file);
    if (const auto table = root.table("lattice", "[lattice]"))
        file.lattice = lattice_entry(*table);
    file.pulls = pull_entries(root);
    if (const auto table = root.table("constraints", "[constraints]"))
        file.constraints = constraints_entry(*table);
    read_boundaries(root, file);
    if (const auto table = root.table("deform", "[deform]"))
        file.deform = deform_entry(*table);
    if (file.deform.method == "ffd" && !file.lattice)
        root.fail(1, "method = \"ffd\" needs a [lattice]");
    read_output_section(root, file);
    return file;
}

} // namespace morph::tools
