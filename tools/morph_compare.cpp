// morph-compare: the same change by several methods, side by side.
//   morph-compare examples/02_thesis_case2/case.toml --methods harmonic,harmonic-distance --page compare.html
#include "formats/case/case_file.h"
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "tools/common/command_line.h"
#include "tools/common/report.h"
#include "tools/common/run.h"
#include "tools/compare/page.h"
#include "tools/compare/table.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-compare";

struct Options {
    std::string case_file;
    std::vector<std::string> methods;
    std::vector<double> moves{1};
    std::string page;
    std::string from;
};

std::string methods_help()
{
    std::string text = "Which methods (default: all):";
    for (const ComparedMethod& method : compared_methods())
        text += "\n" + method.name + " (" + method.description + ")";
    return text + "\nNAME+untangle repairs the elements that NAME leaves inverted";
}

void add_options(CommandLine& line, Options& options)
{
    line.add("case", options.case_file, "Case file, as for morph-deform").required().type_name("CASE.toml");
    line.add("--methods", options.methods, methods_help()).comma_separated().type_name("a,b");
    line.add("--moves", options.moves,
             "How many times the displacements of the case; several are several tables")
        .comma_separated()
        .type_name("1,2,...");
    line.add("--page", options.page, "Write tables and pictures as a page of HTML").type_name("OUT.html");
    line.add_from(options.from);
}

std::vector<ComparedMethod> chosen_methods(const Options& options)
{
    if (options.methods.empty())
        return compared_methods();
    std::vector<ComparedMethod> chosen;
    for (const std::string& name : options.methods)
        chosen.push_back(compared_method(name));
    return chosen;
}

/// The motion of a case with the FFD box it names as its lattice.
MotionSettings with_box(CaseFile file, const Mesh& mesh)
{
    file.motion.deform.method = Method::ffd; // without which the lattice may not be used
    take_su2_box(file, mesh);
    return file.motion;
}

ComparedMove compare_move(const Mesh& mesh, CaseFile file, double factor,
                          const std::vector<ComparedMethod>& methods)
{
    for (CurveMove& curve : file.motion.curves)
        curve.displacements *= factor;
    const PlacedBoundaries placed = parametrize_boundaries(mesh, file.motion);
    for (const std::string& crossing : boundary_crossings(placed, placed.displacements))
        warn(kTool, crossing + ": no valid mesh exists");
    ComparedMove move{factor, {}};
    for (const ComparedMethod& method : methods)
        try {
            move.rows.push_back(
                compare(mesh, placed, method.uses_lattice ? with_box(file, mesh) : file.motion, method));
        } catch (const std::runtime_error& error) { // the others are still of use
            warn(kTool, method.name + ": " + error.what());
        }
    if (move.rows.empty())
        throw InputError("no method could make the move");
    return move;
}

void describe(const Options& options, const std::vector<ComparedMove>& moves, Report& report)
{
    report.json["case"] = options.case_file;
    report.json["moves"] = nlohmann::ordered_json::array();
    for (const ComparedMove& move : moves) {
        report.json["moves"].push_back(comparison_json(move));
        if (moves.size() > 1)
            report.say(short_number(move.factor) + " times the move of the case");
        for (const std::string& line : comparison_lines(move))
            report.say(line);
    }
}

int compare_methods_of(int argc, char** argv)
{
    CommandLine line(
        kTool,
        "The same move of the boundary by several methods: how well the boundary comes out, what becomes\n"
        "of the elements, and what it costs.",
        "  morph-compare case.toml --methods harmonic,harmonic-distance --moves 0.5,1,2 --page compare.html");
    Options options;
    add_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;
    const std::vector<ComparedMethod> methods = chosen_methods(options);
    Report report(line.common());
    if (!options.page.empty())
        OutputFiles::require_writable(options.page);
    const CaseFile file = read_case_file(options.case_file);
    Mesh mesh = case_mesh(file, options.from);
    std::vector<ComparedMove> moves;
    for (const double factor : options.moves)
        moves.push_back(compare_move(mesh, file, factor, methods));
    OutputFiles outputs;
    if (!options.page.empty())
        outputs.open(options.page)
            .append(comparison_page({options.case_file, file.generate ? "generated mesh" : file.mesh_file},
                                    mesh, moves));
    describe(options, moves, report);
    report.finish(outputs);
    return kDone;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-compare", [&] { return morph::tools::compare_methods_of(argc, argv); });
}
