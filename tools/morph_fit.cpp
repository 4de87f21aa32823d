// morph-fit: a case file for a mesh that has no curves yet.
//   morph-fit naca0012.su2 --marker airfoil --points 20 -o naca0012.toml
#include "formats/case/case_text.h"
#include "formats/formats.h"
#include "formats/output_files.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/weights/fit_marker.h"
#include "tools/common/command_line.h"
#include "tools/common/report.h"
#include "tools/common/run.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace {

using namespace morph;
using namespace morph::tools;

constexpr const char* kTool = "morph-fit";

struct Options {
    std::string mesh;
    std::string from;
    std::vector<std::string> markers;
    FitSettings fit;
    std::string output;
};

void add_options(CommandLine& line, Options& options)
{
    line.add("mesh", options.mesh, "Planar mesh").type_name("MESH").required();
    line.add("--marker", options.markers, "Marker that gets a curve; may be given several times")
        .type_name("NAME")
        .one_value_each_time()
        .required();
    line.add("--degree", options.fit.degree, "Degree of the curves, 1 to 7").type_name("P").show_default();
    line.add("--points", options.fit.control_points, "Control points of each curve, and so weight fields")
        .type_name("K")
        .show_default();
    line.add("--corner-angle", options.fit.corner_angle,
             "Degrees; a node that turns by this much more than its neighbours is kept as a corner")
        .type_name("A")
        .show_default();
    line.add("-o,--output", options.output, "Case file to write").type_name("CASE.toml").required();
    line.add_from(options.from);
}

void require_each_once(const std::vector<std::string>& markers)
{
    for (auto name = markers.begin(); name != markers.end(); ++name)
        if (std::find(markers.begin(), name, *name) != name)
            throw UsageError("marker '" + *name + "' is given twice");
}

std::string counted(std::size_t count, const std::string& noun)
{
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

BoundaryText boundary_text(const FittedMarker& fitted)
{
    BoundaryText text{fitted.name, fitted.fit.curve, {}, {}};
    text.note = "Least-squares fit to " + counted(fitted.chain.vertices.size(), "node") +
                ": largest distance " + short_number(fitted.fit.max_distance) + ", mean " +
                short_number(fitted.fit.mean_distance) + '.';
    const Curve curve(fitted.fit.curve);
    std::vector<double> corners = curve.corners();
    if (curve.degree() == 1)
        corners.clear(); // every point of a polygon is one
    for (const double u : corners) {
        const BasisRow row = curve.basis(u);
        const auto largest = std::max_element(row.value.begin(), row.value.end()) - row.value.begin();
        text.point_notes.emplace_back(row.control[static_cast<std::size_t>(largest)], "a corner");
    }
    return text;
}

/// Path of a file as seen from the folder of another.
std::string path_from(const std::string& file, const std::string& other)
{
    namespace fs = std::filesystem;
    const fs::path target = fs::absolute(file);
    const fs::path folder = fs::weakly_canonical(fs::absolute(other).parent_path());
    return (fs::weakly_canonical(target.parent_path()) / target.filename())
        .lexically_relative(folder)
        .string();
}

std::string deformed_name(const std::string& mesh)
{
    const std::filesystem::path path(mesh);
    return path.stem().string() + "_deformed" + path.extension().string();
}

void describe(const std::vector<FittedMarker>& markers, Report& report)
{
    double largest = 0;
    double sum = 0;
    std::size_t nodes = 0;
    nlohmann::ordered_json boundaries = nlohmann::ordered_json::array();
    for (const FittedMarker& m : markers) {
        const std::size_t count = m.chain.vertices.size();
        largest = std::max(largest, m.fit.max_distance);
        sum += m.fit.mean_distance * static_cast<double>(count);
        nodes += count;
        boundaries.push_back({{"name", m.name},
                              {"nodes", count},
                              {"closed", m.chain.closed},
                              {"degree", m.fit.curve.degree},
                              {"control_points", m.fit.curve.control_points.rows()},
                              {"corners", m.corner_ids.size()},
                              {"corner_vertices", m.corner_ids},
                              {"max_distance", m.fit.max_distance},
                              {"mean_distance", m.fit.mean_distance}});
        report.say(
            m.name + ": " + (m.chain.closed ? "closed" : "open") + ", " + counted(count, "node") + ", " +
            counted(static_cast<std::size_t>(m.fit.curve.control_points.rows()), "control point") + ", " +
            counted(m.corner_ids.size(), "corner") + "; distance of the nodes to the curve: largest " +
            short_number(m.fit.max_distance) + ", mean " + short_number(m.fit.mean_distance));
    }
    report.json["max_distance"] = largest;
    report.json["mean_distance"] = sum / static_cast<double>(nodes);
    report.json["boundaries"] = std::move(boundaries);
}

/// morph-deform will not take curves that cross.
void warn_of_crossings(const std::vector<FittedMarker>& markers)
{
    for (const FittedCrossing& found : fitted_crossings(markers)) {
        const std::string& first = markers[static_cast<std::size_t>(found.first)].name;
        const std::string& second = markers[static_cast<std::size_t>(found.second)].name;
        const Eigen::Vector2d& place = found.crossing.point;
        warn(kTool,
             (found.first == found.second ? "the curve of '" + first + "' crosses itself"
                                          : "the curves of '" + first + "' and '" + second + "' cross") +
                 " near (" + short_number(place.x()) + ", " + short_number(place.y()) +
                 "); more --points may help");
    }
}

int fit(const Options& options, const CommonOptions& common)
{
    Report report(common);
    OutputFiles::require_writable(options.output);
    Stopwatch watch;
    const Mesh mesh = read_mesh(options.mesh, options.from);
    const double read = watch.lap();
    if (mesh.dimension != 2)
        throw InputError(options.mesh +
                         ": is a surface mesh; curves carry the markers of planar meshes (z = 0) only");

    std::vector<FittedMarker> fitted;
    std::vector<BoundaryText> boundaries;
    for (const std::string& name : options.markers) {
        fitted.push_back(fit_marker(mesh, name, options.fit));
        boundaries.push_back(boundary_text(fitted.back()));
    }
    warn_of_crossings(fitted);
    const double fit = watch.lap();

    OutputFiles outputs;
    outputs.open(options.output)
        .append(case_text(kTool, path_from(options.mesh, options.output), deformed_name(options.mesh),
                          boundaries));
    report.json["mesh"] = options.mesh;
    report.json["case"] = options.output;
    describe(fitted, report);
    report.say("wrote " + options.output);
    report.json["seconds"] = {{"read", read}, {"fit", fit}, {"write", watch.lap()}};
    report.finish(outputs);
    return kDone;
}

} // namespace

int main(int argc, char** argv)
{
    return run(kTool, [&] {
        CommandLine line(kTool,
                         "Fit a B-spline to markers of a planar mesh and write a case file for morph-deform.",
                         "  morph-fit naca0012_inv.su2 --marker airfoil --points 20 -o naca0012.toml\n"
                         "  # edit `displacements` in naca0012.toml, then:\n"
                         "  morph-deform naca0012.toml");
        Options options;
        add_options(line, options);
        if (!line.parse(argc, argv))
            return static_cast<int>(kDone);
        require_each_once(options.markers);
        return fit(options, line.common());
    });
}
