// morph-mesh: mesh the domain of a case file.
//   morph-mesh examples/01_thesis_case1/case.toml -o domain.su2
#include "formats/case/case_file.h"
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/quality/quality.h"
#include "tools/common/report.h"
#include "tools/common/run.h"

#include <nlohmann/json.hpp>

namespace {

using namespace morph;
using namespace morph::tools;

constexpr const char* kDescription = "Mesh the domain of a case file: the box of [mesh] generate without the "
                                     "insides of its [[boundary]] curves.";

constexpr const char* kExample =
    "  morph-mesh examples/02_thesis_case2/case.toml -o domain.su2\n"
    "meshes the rectangle around two bodies, 100 nodes on each, and writes it with the\n"
    "markers body1, body2 and farfield.\n";

struct Settings {
    std::string case_file;
    std::string output;
    std::string to;
};

void describe(const MeshData& mesh, const Settings& settings, Report& report)
{
    report.json["vertices"] = mesh.points.rows();
    report.json["triangles"] = mesh.elements.size();
    report.json["min_angle"] = min_angle(mesh);
    report.say(settings.output + ": " + std::to_string(mesh.points.rows()) + " vertices, " +
               std::to_string(mesh.elements.size()) + " triangles, smallest angle " +
               short_number(report.json["min_angle"]) + " degrees");
    for (const Marker& marker : mesh.markers) {
        report.json["markers"][marker.name] = marker.edges.size();
        report.say("  marker " + marker.name + ": " + std::to_string(marker.edges.size()) + " edges");
    }
}

int mesh_case(const Settings& settings, const CommonOptions& common)
{
    find_format(settings.output, settings.to);
    Report report(common);
    OutputFiles::require_writable(settings.output);

    Stopwatch watch;
    const CaseFile file = read_case_file(settings.case_file);
    const double read = watch.lap();
    if (!file.generate)
        throw InputError(file.path + ": nothing to generate: [mesh] has file, expected generate = { box = "
                                     "[xmin, ymin, xmax, ymax], size = ... }");
    const MeshData mesh = generate_mesh(*file.generate, file.motion.curves);
    const double meshed = watch.lap();

    OutputFiles outputs;
    for (const std::string& warning : write_mesh_data(mesh, settings.output, outputs, settings.to))
        warn("morph-mesh", warning);
    describe(mesh, settings, report);
    report.json["seconds"] = {{"read", read}, {"mesh", meshed}, {"write", watch.lap()}};
    report.finish(outputs);
    return kDone;
}

} // namespace

int main(int argc, char** argv)
{
    return run("morph-mesh", [&] {
        CommandLine line("morph-mesh", kDescription, kExample);
        Settings settings;
        line.add("case", settings.case_file, "Case file with [mesh] generate")
            .required()
            .type_name("CASE.toml");
        line.add("-o,--output", settings.output, "Mesh file to write").required().type_name("OUT");
        line.add_to(settings.to);
        if (!line.parse(argc, argv))
            return static_cast<int>(kDone);
        return mesh_case(settings, line.common());
    });
}
