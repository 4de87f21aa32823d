#include "formats/case/case_file.h"

#include "formats/case/entries.h"
#include "formats/formats.h"
#include "formats/input_file.h"
#include "formats/su2/ffd.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"

#include <algorithm>
#include <map>

namespace morph {

namespace {

constexpr Index kMostNodes = 10'000'000;

GenerateSettings generate_settings(const TomlTable& table, const std::string& path)
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
    GenerateSettings entry;
    entry.where = path + ": ";
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
        file.mesh_file = relative_to(file.path, *name);
    if (const auto generate = table->table("generate", "[mesh] generate"))
        file.generate = generate_settings(*generate, file.path);
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

CurveMove curve_move(const TomlTable& table)
{
    table.require_known({"name", "degree", "closed", "control_points", "knots", "weights", "nodes",
                         "displacements", "moved"});
    const auto name = table.string("name");
    if (!name)
        table.fail_missing("name", "name = \"airfoil\"");
    CurveMove move;
    move.marker = *name;
    move.where = table.where();
    move.curve = curve_of(table);
    move.nodes = table.integer("nodes", 1, kMostNodes).value_or(0);
    move.displacements = displacements_of(table, move.curve.control_points);
    make_curve(move); // refuses what is no curve
    return move;
}

void read_boundaries(const TomlTable& root, CaseFile& file)
{
    std::map<std::string, int> lines;
    for (const TomlTable& table : root.tables("boundary")) {
        CurveMove move = curve_move(table);
        const auto [first, is_new] = lines.try_emplace(move.marker, table.line());
        if (!is_new)
            table.fail(table.line(), "boundary '" + move.marker + "' is given twice, first in line " +
                                         std::to_string(first->second));
        file.motion.curves.push_back(std::move(move));
    }
    if (file.motion.curves.empty() && !file.motion.lattice)
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
        file.output_mesh = relative_to(file.path, *name);
}

void read_lattice(const TomlTable& root, CaseFile& file)
{
    const auto table = root.table("lattice", "[lattice]");
    if (!table)
        return;
    LatticeEntry entry = lattice_entry(*table);
    file.motion.lattice = std::move(entry.settings);
    file.su2_box = std::move(entry.su2_box);
    file.su2_box_displacements = std::move(entry.sparse_displacements);
}

LatticeDefinition shape_of(const Su2FfdBox& box)
{
    LatticeDefinition shape;
    shape.dimension = box.dimension;
    shape.basis = box.bspline ? LatticeBasis::bspline : LatticeBasis::bernstein;
    std::copy(box.degree.begin(), box.degree.end(), shape.degree.begin());
    std::copy(box.points.begin(), box.points.end(), shape.points.begin());
    shape.control_points = box.control_points;
    return shape;
}

/// The FFD box of that tag.
LatticeDefinition su2_shape(const std::vector<Su2FfdBox>& boxes, const CaseFile& file)
{
    std::vector<std::string> tags;
    for (const Su2FfdBox& box : boxes) {
        if (box.tag == file.su2_box)
            return shape_of(box);
        tags.push_back(box.tag);
    }
    throw InputError("su2_box '" + file.su2_box + "' is not in " + file.mesh_file + ", which has " +
                     (tags.empty() ? "no FFD boxes" : joined(tags)) + did_you_mean(file.su2_box, tags));
}

} // namespace

CaseFile read_case_file(const std::string& path)
{
    const InputFile file(path);
    return parse_case_file(file.bytes(), path);
}

CaseFile parse_case_file(std::string_view bytes, const std::string& path)
{
    const TomlTable root = TomlTable::parse(bytes, path, "the case file");
    root.require_known({"mesh", "boundary", "lattice", "pull", "constraints", "deform", "output"});
    CaseFile file;
    file.path = path;
    file.motion.where = path + ": ";
    file.motion.deform.where = root.where(1);
    read_mesh_section(root, file);
    read_lattice(root, file);
    file.motion.pulls = pull_settings(root);
    if (const auto table = root.table("constraints", "[constraints]"))
        file.motion.constraints = constraint_settings(*table);
    read_boundaries(root, file);
    if (const auto table = root.table("deform", "[deform]"))
        file.motion.deform = deform_settings(*table);
    if (file.motion.deform.method == Method::ffd && !file.motion.lattice)
        root.fail(1, "method = \"ffd\" needs a [lattice]");
    read_output_section(root, file);
    return file;
}

Mesh case_mesh(const CaseFile& file, const std::string& from)
{
    return file.generate ? build_mesh(generate_mesh(*file.generate, file.motion.curves))
                         : read_mesh(file.mesh_file, from);
}

void take_su2_box(CaseFile& file, const Mesh& mesh)
{
    if (file.su2_box.empty() || !uses_lattice(file.motion))
        return;
    LatticeSettings& lattice = *file.motion.lattice;
    try {
        lattice.shape = su2_shape(su2_ffd_boxes(mesh.sections, file.mesh_file), file);
    } catch (const InputError& error) {
        throw InputError(lattice.where + "[lattice] " + error.what());
    }
    lattice.displacements =
        full_displacements(file.su2_box_displacements, lattice.shape.points, lattice.where);
}

} // namespace morph
