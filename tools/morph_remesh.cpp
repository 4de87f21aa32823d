// morph-remesh: a better mesh of the same domain.
//   morph-remesh wing.su2 -o coarse.su2 --scale 1.5
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remap/remap.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/remesh.h"
#include "libmorph/remesh/wanted_size.h"
#include "tools/case/case_file.h"
#include "tools/common/quality_json.h"
#include "tools/common/report.h"
#include "tools/common/run.h"
#include "tools/remesh/group_regions.h"

#include <cmath>
#include <numeric>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-remesh";

struct Options {
    std::string input;
    std::string output;
    double size = 0;
    double scale = 1;
    std::string size_field;
    Index vertices = 0;
    double gradation = 0;
    int iterations = 5;
    double only_bad = 0;
    std::string case_file;
    bool no_fields = false;
    std::string from;
    std::string to;
};

void add_options(CommandLine& line, Options& options)
{
    CLI::App& app = line.app();
    app.add_option("input", options.input, "Planar mesh or surface; its quads are kept as they are")
        ->required()
        ->type_name("IN");
    app.add_option("-o,--output", options.output, "The new mesh")->required()->type_name("OUT");
    CLI::Option* size = app.add_option("--size", options.size, "Edge length wanted everywhere")
                            ->check(CLI::PositiveNumber)
                            ->type_name("H");
    app.add_option("--size-field", options.size_field,
                   "Nodal field of IN with the edge lengths wanted (default: those IN has)")
        ->excludes(size)
        ->type_name("NAME");
    app.add_option("--scale", options.scale, "Factor on the edge lengths wanted")
        ->capture_default_str()
        ->check(CLI::PositiveNumber);
    app.add_option("--vertices", options.vertices, "Scale them further, to about this many vertices")
        ->check(CLI::Range(3, 100000000))
        ->type_name("N");
    app.add_option("--gradation", options.gradation,
                   "Edges that follow each other differ in length by at most this factor, such as 1.2")
        ->check(CLI::Range(1.01, 100.0));
    app.add_option("--iterations", options.iterations, "Rounds of splitting, collapsing and relaxing")
        ->capture_default_str()
        ->check(CLI::Range(1, 100));
    app.add_option("--only-bad", options.only_bad,
                   "Touch only triangles of less than this quality (4 sqrt(3) area / sum of squared sides)\n"
                   "and two rings around them; the others keep their numbers")
        ->check(CLI::Range(0.0, 1.0))
        ->type_name("Q");
    app.add_option("--case", options.case_file,
                   "Case file whose [[boundary]] curves the nodes of these markers are put on (default:\n"
                   "the smooth curve through the nodes of each marker, corners kept)")
        ->type_name("CASE.toml");
    app.add_flag("--no-fields", options.no_fields, "Leave the fields of IN behind");
    line.add_from(options.from);
    line.add_to(options.to);
}

/// The edge length wanted at each vertex.
Eigen::VectorXd wanted_sizes(const Mesh& mesh, const Options& options)
{
    Eigen::VectorXd sizes = own_sizes(mesh);
    if (options.size > 0)
        sizes.setConstant(options.size);
    else if (!options.size_field.empty()) {
        const Field* field = find_field(mesh.fields, options.size_field, FieldLocation::vertex);
        std::vector<std::string> names;
        for (const Field& f : mesh.fields)
            names.push_back(f.name);
        if (field == nullptr)
            throw InputError(options.input + ": has no nodal field '" + options.size_field + "'" +
                             did_you_mean(options.size_field, names));
        if (field->values.cols() != 1)
            throw InputError(options.input + ": field '" + options.size_field + "' has " +
                             std::to_string(field->values.cols()) + " components, but a size has 1");
        sizes = field->values.col(0);
    }
    sizes *= options.scale;
    // Each undoes a little of what the other did, less and less.
    constexpr int kRounds = 8;
    for (int round = 0; round < kRounds; ++round) {
        if (options.vertices > 0)
            scale_to_vertices(mesh, options.vertices, sizes);
        if (options.gradation > 0)
            limit_gradation(mesh, options.gradation, sizes);
    }
    return sizes;
}

RemeshSettings settings_of(const Mesh& mesh, const Options& options)
{
    RemeshSettings settings;
    if (options.only_bad > 0) {
        settings.kept = all_but_bad(mesh, options.only_bad);
        settings.numbering = NumberingRule::keep_old;
    }
    settings.iterations = options.iterations;
    if (!options.case_file.empty())
        for (const BoundaryEntry& boundary : read_case_file(options.case_file).boundaries)
            settings.features.curves.push_back({boundary.name, Curve(boundary.curve)});
    return settings;
}

/// The new mesh; with a number of vertices wanted, sizes are corrected by how many there are too many or too
/// few.
Mesh remade(const Mesh& old, const Options& options, Eigen::VectorXd& sizes)
{
    constexpr int kCorrections = 4;
    constexpr double kNear = 0.02; // of the number wanted
    const RemeshSettings settings = settings_of(old, options);
    Mesh mesh = build_mesh(remesh(old, sizes, settings).data);
    for (int i = 0; i < kCorrections && options.vertices > 0; ++i) {
        const double ratio = static_cast<double>(vertex_count(mesh)) / options.vertices;
        if (std::abs(ratio - 1) <= kNear)
            break;
        sizes *= std::sqrt(ratio);
        mesh = build_mesh(remesh(old, sizes, settings).data);
    }
    return mesh;
}

/// The new mesh, with edges along every border between groups of elements.
Mesh remade_between(Mesh& old, const GroupRegions& regions, const Options& options, Eigen::VectorXd& sizes)
{
    if (regions.groups.size() < 2)
        return remade(old, options, sizes);
    std::string name = "borders of groups";
    while (find_marker(old.markers, name))
        name += '_';
    old.markers.push_back(region_borders(old, regions, name));
    Mesh mesh = remade(old, options, sizes);
    old.markers.pop_back();
    std::erase_if(mesh.markers, [&](const Marker& marker) { return marker.name == name; });
    return mesh;
}

/// Carry the fields of the old mesh, and the sizes wanted as the last of them.
std::vector<Field> carried(const Locator& locator, const Mesh& mesh, const Eigen::VectorXd& sizes,
                           bool no_fields)
{
    const Mesh& old = locator.source();
    const Field wanted{"size", FieldLocation::vertex, sizes};
    std::vector<const Field*> fields;
    for (const Field& field : old.fields)
        if (!no_fields)
            fields.push_back(&field);
    fields.push_back(&wanted);
    RemapSettings settings;
    settings.outside = Outside::project;
    settings.conserve_elements = old.dimension == 2; // in space elements do not overlap: sampled
    return Remapper(locator, mesh, settings).carry(fields);
}

/// Smallest, mean and worst of the triangles: the measure that remeshing aims at.
nlohmann::ordered_json triangle_json(const Mesh& mesh)
{
    const std::vector<double> quality = triangle_qualities(mesh);
    std::vector<double> of_triangles;
    Index worst = -1;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const auto place = static_cast<std::size_t>(f);
        if (element_corners(mesh, f)[3] >= 0)
            continue;
        of_triangles.push_back(quality[place]);
        if (worst < 0 || quality[place] < quality[static_cast<std::size_t>(worst)])
            worst = f;
    }
    if (worst < 0)
        return nullptr;
    const double sum = std::accumulate(of_triangles.begin(), of_triangles.end(), 0.0);
    return {{"min", quality[static_cast<std::size_t>(worst)]},
            {"mean", sum / static_cast<double>(of_triangles.size())},
            {"worst_element", mesh.numbering.element[static_cast<std::size_t>(worst)]}};
}

void describe(const Mesh& old, const Mesh& mesh, double conformity, const std::string& output, Report& report)
{
    const QualityReport before = quality_report(old), after = quality_report(mesh);
    report.json["quality"] = {{"before", quality_json(before)}, {"after", quality_json(after)}};
    report.json["triangle_quality"] = {{"before", triangle_json(old)}, {"after", triangle_json(mesh)}};
    report.json["size_conformity"] = conformity;
    report.say(output + ": " + std::to_string(after.vertices) + " vertices, " +
               std::to_string(after.triangles) + " triangles, " + std::to_string(after.quads) +
               " quads (from " + std::to_string(before.vertices) + ", " + std::to_string(before.triangles) +
               ", " + std::to_string(before.quads) + ")");
    report.say("  " + short_number(100 * conformity) +
               " % of the edges have 0.7 to 1.4 times the length wanted");
    for (const std::string& text : quality_summary(after))
        report.say("  " + text);
}

int remesh_file(int argc, char** argv)
{
    Options options;
    CommandLine line(
        kTool, "Makes the triangles of a mesh anew, of the edge lengths wanted.",
        "  morph-remesh wing.su2 -o coarse.su2 --scale 1.5\n"
        "makes edges one and a half times as long; markers, corners and quads stay, nodes of the\n"
        "boundary move along it.");
    add_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;
    Report report(line.common());
    find_format(options.output, options.to);
    OutputFiles::require_writable(options.output);

    Stopwatch watch;
    Mesh old = read_mesh(options.input, options.from);
    const double read = watch.lap();
    Eigen::VectorXd sizes = wanted_sizes(old, options);
    const GroupRegions regions = group_regions(old);
    for (const CarriedText& carried : old.carried)
        warn(kTool,
             options.input + ": " + carried.what + " may name vertices that are no more, and was left out");
    Mesh mesh = remade_between(old, regions, options, sizes);
    const double remeshed = watch.lap();
    const Locator locator(old);
    if (!old.groups.empty())
        mesh.groups = carried_groups(locator, regions, mesh);
    mesh.fields = carried(locator, mesh, sizes, options.no_fields);
    const double conformity = size_conformity(mesh, mesh.fields.back().values.col(0));
    mesh.fields.pop_back();
    const double fields = watch.lap();
    describe(old, mesh, conformity, options.output, report);
    watch.lap();

    OutputFiles outputs;
    for (const std::string& warning : write_mesh_data(to_data(mesh), options.output, outputs, options.to))
        warn(kTool, warning);
    report.json["seconds"] = {
        {"read", read}, {"remesh", remeshed}, {"fields", fields}, {"write", watch.lap()}};
    report.finish(outputs);
    return report.json["quality"]["after"]["inverted"] > 0 ? kInverted : kDone;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-remesh", [&] { return morph::tools::remesh_file(argc, argv); });
}
