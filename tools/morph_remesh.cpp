// morph-remesh: a better mesh of the same domain.
//   morph-remesh wing.su2 -o coarse.su2 --scale 1.5
#include "formats/case/case_file.h"
#include "formats/formats.h"
#include "libmorph/core/names.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/bounded_remesh.h"
#include "libmorph/remesh/group_regions.h"
#include "libmorph/remesh/remesh.h"
#include "libmorph/remesh/transferred_fields.h"
#include "tools/common/command_line.h"
#include "tools/common/report.h"
#include "tools/common/run.h"
#include "tools/remesh/cut_out_inverted.h"
#include "tools/remesh/keep_option.h"
#include "tools/remesh/remesh_report.h"
#include "tools/remesh/size_options.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-remesh";

struct Options {
    std::string input;
    std::string output;
    SizeSettings sizes;
    int iterations = 5;
    double only_bad = 0;
    std::vector<std::string> keep;
    double hausdorff = 0;
    double crease = FeatureSettings{}.crease_angle;
    std::string case_file;
    bool no_fields = false;
    bool fresh = false;
    std::string from;
    std::string to;
};

void add_options(CommandLine& line, Options& options)
{
    line.add("input", options.input, "Planar mesh or surface; its quads are kept as they are")
        .required()
        .type_name("IN");
    line.add("-o,--output", options.output, "The new mesh").required().type_name("OUT");
    add_size_options(line, options.sizes);
    line.add("--iterations", options.iterations, "Rounds of splitting, collapsing and relaxing")
        .show_default()
        .range(1, 100);
    const Option only_bad =
        line.add("--only-bad", options.only_bad,
                 "Touch only triangles of less than this quality (4 sqrt(3) area / sum of squared sides)\n"
                 "and two rings around them; the others keep their numbers")
            .range(0.0, 1.0)
            .type_name("Q");
    add_keep_option(line, options.keep);
    line.add("--hausdorff", options.hausdorff,
             "Largest distance from IN (planar: of the boundaries); edges become as short as that asks")
        .positive()
        .excludes("--vertices")
        .type_name("D");
    line.add("--crease", options.crease,
             "Degrees between two triangles of a surface from which on the edge between them stays one;\n"
             "edges of markers and borders of groups always do")
        .show_default()
        .range(0.0, 180.0)
        .type_name("DEG");
    line.add("--case", options.case_file,
             "Case file whose [[boundary]] curves the nodes of these markers are put on (default:\n"
             "the smooth curve through the nodes of each marker, corners kept)")
        .type_name("CASE.toml");
    line.add_flag("--fresh", options.fresh,
                  "Mesh a planar domain from its boundary: of the nodes of IN only those of the boundary, of "
                  "markers and\n"
                  "of borders between groups are started from")
        .excludes(only_bad);
    line.add_flag("--no-fields", options.no_fields, "Leave the fields of IN behind");
    line.add_from(options.from);
    line.add_to(options.to);
}

RemeshSettings settings_of(const Mesh& mesh, const Options& options)
{
    RemeshSettings settings;
    if (options.only_bad > 0)
        settings.kept = all_but_bad(mesh, options.only_bad);
    keep_zones(mesh, kept_zones(options.keep), settings.kept);
    if (!settings.kept.empty())
        settings.numbering = NumberingRule::keep_old;
    settings.iterations = options.iterations;
    settings.fresh = options.fresh;
    settings.features.crease_angle = options.crease;
    if (!options.case_file.empty())
        for (const CurveMove& curve : read_case_file(options.case_file).motion.curves)
            settings.features.curves.push_back({curve.marker, make_curve(curve)});
    return settings;
}

/// The new mesh; with a target number of vertices, sizes are corrected by how many there are too many or too
/// few, as long as that helps.
RemeshResult remade(const Mesh& old, const Options& options, const RemeshSettings& settings,
                    Eigen::VectorXd& sizes)
{
    constexpr int kCorrections = 4;
    constexpr double kNear = 0.02; // of the target number
    if (options.hausdorff > 0)
        return remesh_within(old, options.hausdorff, sizes, settings);
    const Index vertices = target_vertices(old, options.sizes);
    RemeshResult made = remesh(old, sizes, settings);
    for (int i = 0; i < kCorrections && vertices > 0; ++i) {
        const double ratio = static_cast<double>(made.data.points.rows()) / vertices;
        if (std::abs(ratio - 1) <= kNear)
            break;
        const Eigen::VectorXd corrected = std::sqrt(ratio) * sizes;
        RemeshResult next = remesh(old, corrected, settings);
        const double next_ratio = static_cast<double>(next.data.points.rows()) / vertices;
        if (std::abs(next_ratio - ratio) <= kNear * ratio)
            break;
        sizes = corrected;
        made = std::move(next);
    }
    return made;
}

/// The new mesh with the borders between groups kept; what sizes were possible goes to the wishes.
Mesh remeshed(Mesh& old, const GroupRegions& regions, const Options& options, const RemeshSettings& settings,
              RemeshWishes& wishes)
{
    const RegionBorders borders(old, regions);
    RemeshResult made = remade(old, options, settings, wishes.sizes);
    wishes.possible = std::move(made.sizes);
    Mesh mesh = build_mesh(made.data);
    borders.remove_from(mesh);
    return mesh;
}

/// Wishes at the vertices of the old mesh, carried to those of the new one.
RemeshWishes carried_wishes(const Locator& locator, const Mesh& mesh, const RemeshWishes& wishes)
{
    const std::vector<Field> carried =
        transferred_fields(locator, mesh,
                           {{"sizes", FieldLocation::vertex, wishes.sizes},
                            {"possible", FieldLocation::vertex, wishes.possible}});
    return {carried[0].values, carried[1].values, wishes.vertices};
}

void warn_if_beyond(const nlohmann::ordered_json& hausdorff, const Options& options)
{
    if (options.hausdorff > 0 && hausdorff["distance"] > options.hausdorff)
        warn(kTool, options.output + ": is " + short_number(hausdorff["distance"]) + " from " +
                        options.input + " at " + hausdorff["at"].dump() + ", more than the " +
                        short_number(options.hausdorff) +
                        " of --hausdorff; it came no nearer in the rounds there are");
}

int remesh_file(int argc, char** argv)
{
    Options options;
    CommandLine line(
        kTool, "Remeshes the triangles of a mesh with target edge lengths.",
        "  morph-remesh wing.su2 -o coarse.su2 --scale 1.5\n"
        "makes edges one and a half times as long; markers, corners and quads stay, nodes of the\n"
        "boundary move along it.");
    add_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;
    kept_zones(options.keep); // refused before the mesh is read
    Report report(line.common());
    find_format(options.output, options.to);
    OutputFiles::require_writable(options.output);

    Stopwatch watch;
    const Mesh input = read_mesh(options.input, options.from);
    const double read = watch.lap();
    Mesh old = without_inverted(input, options.input, report);
    const RemeshSettings settings = settings_of(old, options);
    RemeshWishes wishes;
    wishes.sizes = target_sizes(old, options.sizes, settings.features, options.input + ": ");
    wishes.vertices = target_vertices(old, options.sizes);
    const GroupRegions regions = group_regions(old);
    Mesh mesh = remeshed(old, regions, options, settings, wishes);
    const double remeshed = watch.lap();
    for (const OpaqueSection& carried : old.sections)
        if (carried.names_vertices)
            warn(kTool, options.input + ": " + carried.what +
                            " may name vertices that are no more, and was left out");
        else
            mesh.sections.push_back(carried);
    const Locator locator(old);
    if (!old.groups.empty())
        mesh.groups = transferred_groups(locator, regions, mesh);
    if (!options.no_fields)
        mesh.fields = transferred_fields(locator, mesh, old.fields);
    const RemeshWishes wishes_there = carried_wishes(locator, mesh, wishes);
    const double fields = watch.lap();
    describe_remeshing(input, mesh, wishes_there, options.output, report);
    warn_if_beyond(report.json["hausdorff"], options);
    const double check = watch.lap();

    OutputFiles outputs;
    for (const std::string& warning :
         write_mesh_data(to_mesh_data(mesh), options.output, outputs, options.to))
        warn(kTool, warning);
    report.json["seconds"] = {
        {"read", read}, {"remesh", remeshed}, {"fields", fields}, {"check", check}, {"write", watch.lap()}};
    report.finish(outputs);
    const bool valid = report.json["quality"]["after"]["inverted"] == 0 && report.json.value("folds", 0) == 0;
    return valid ? kDone : kInverted;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-remesh", [&] { return morph::tools::remesh_file(argc, argv); });
}
