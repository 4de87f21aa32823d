// morph-remesh: a better mesh of the same domain.
//   morph-remesh wing.su2 -o coarse.su2 --scale 1.5
#include "formats/case/case_file.h"
#include "formats/formats.h"
#include "libmorph/core/names.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/pipeline/remesh_job.h"
#include "tools/common/command_line.h"
#include "tools/common/report.h"
#include "tools/common/run.h"
#include "tools/remesh/keep_option.h"
#include "tools/remesh/remesh_report.h"
#include "tools/remesh/size_options.h"

#include <nlohmann/json.hpp>

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

RemeshJob job_of(const Options& options)
{
    RemeshJob job;
    job.sizes = options.sizes;
    job.only_bad = options.only_bad;
    job.zones = kept_zones(options.keep);
    job.hausdorff = options.hausdorff;
    job.iterations = options.iterations;
    job.fresh = options.fresh;
    job.features.crease_angle = options.crease;
    job.transfer_fields = !options.no_fields;
    job.where = options.input + ": ";
    return job;
}

void take_curves(const std::string& case_file, FeatureSettings& features)
{
    if (!case_file.empty())
        for (const CurveMove& curve : read_case_file(case_file).motion.curves)
            features.curves.push_back({curve.marker, make_curve(curve)});
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
    RemeshJob job = job_of(options);
    Report report(line.common());
    find_format(options.output, options.to);
    OutputFiles::require_writable(options.output);

    Stopwatch watch;
    const Mesh input = read_mesh(options.input, options.from);
    const double read = watch.lap();
    take_curves(options.case_file, job.features);
    const RemeshedMesh remeshed = remesh(input, job);
    for (const std::string& what : remeshed.left_out)
        warn(kTool, options.input + ": " + what + " may name vertices that are no more, and was left out");
    watch.lap();
    const RemeshCheck found = check_remeshing(input, remeshed.mesh, remeshed.targets);
    describe_remeshing(input, remeshed, found, options.output, report);
    warn_if_beyond(report.json["hausdorff"], options);
    const double check = watch.lap();

    OutputFiles outputs;
    for (const std::string& warning :
         write_mesh_data(to_mesh_data(remeshed.mesh), options.output, outputs, options.to))
        warn(kTool, warning);
    report.json["seconds"] = {{"read", read},
                              {"remesh", remeshed.remesh_seconds},
                              {"fields", remeshed.transfer_seconds},
                              {"check", check},
                              {"write", watch.lap()}};
    report.finish(outputs);
    return is_valid(found) ? kDone : kInverted;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-remesh", [&] { return morph::tools::remesh_file(argc, argv); });
}
