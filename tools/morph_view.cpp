// morph-view: look at a mesh, or at two side by side.
//   morph-view naca0012.su2 deformed.su2 -o before_after.png
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/quality/quality.h"
#include "tools/common/command_line.h"
#include "tools/common/report.h"
#include "tools/common/run.h"
#include "tools/picture/image_kind.h"
#include "tools/picture/picture.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-view";

struct Options {
    std::vector<std::string> meshes;
    std::string out;
    std::string zoom;
    std::string from;
    picture::PictureOptions picture;
};

/// @throws UsageError  not four finite numbers xmin,ymin,xmax,ymax with xmin < xmax and ymin < ymax
picture::Box parse_zoom(const std::string& text)
{
    const std::string expected =
        "--zoom needs xmin,ymin,xmax,ymax with xmin < xmax and ymin < ymax, not '" + text + "'";
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    for (;;) {
        double value = 0;
        const auto [stop, error] = std::from_chars(at, end, value);
        if (error != std::errc() || !std::isfinite(value) || (stop != end && *stop != ','))
            throw UsageError(expected);
        numbers.push_back(value);
        if (stop == end)
            break;
        at = stop + 1;
    }
    if (numbers.size() != 4 || !(numbers[0] < numbers[2]) || !(numbers[1] < numbers[3]))
        throw UsageError(expected);
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

void refuse_case_files(const std::vector<std::string>& paths)
{
    for (const std::string& path : paths)
        if (picture::lower_extension(path) == ".toml")
            throw InputError(path + ": case files cannot be shown, only mesh files; draw the mesh it names");
}

std::vector<Mesh> read_meshes(const Options& options)
{
    std::vector<Mesh> meshes;
    for (const std::string& path : options.meshes)
        meshes.push_back(read_mesh(path, options.from));
    if (!options.zoom.empty())
        for (std::size_t i = 0; i < meshes.size(); ++i)
            if (meshes[i].dimension == 3)
                throw InputError(options.meshes[i] +
                                 ": --zoom is for planar meshes, but this is a surface in space");
    return meshes;
}

std::string caption(const Options& options, std::size_t number)
{
    std::string name = std::filesystem::path(options.meshes[number]).filename().string();
    if (options.meshes.size() == 1)
        return name;
    return (number == 0 ? "before: " : "after: ") + name;
}

nlohmann::ordered_json mesh_json(const std::string& path, const Mesh& mesh, std::size_t inverted)
{
    nlohmann::ordered_json json;
    json["file"] = path;
    json["vertices"] = mesh.numbering.file_vertices;
    json["elements"] = element_count(mesh);
    json["inverted"] = inverted;
    return json;
}

void describe(Report& report, const Options& options, const std::vector<Mesh>& meshes)
{
    report.json["picture"] = options.out;
    report.json["meshes"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const std::size_t inverted = inverted_elements(meshes[i], points(meshes[i])).size();
        report.json["meshes"].push_back(mesh_json(options.meshes[i], meshes[i], inverted));
        report.say(options.meshes[i] + ": " + std::to_string(element_count(meshes[i])) + " elements, " +
                   std::to_string(inverted) + " inverted");
    }
    report.say("picture written to " + options.out);
}

void add_options(CommandLine& line, Options& options)
{
    line.add("meshes", options.meshes, "Mesh file; a second one is drawn next to it in the same view")
        .required()
        .count(1, 2)
        .type_name("MESH [MESH2]");
    line.add("-o,--out", options.out, "Picture to write").required().type_name("OUT.png|OUT.svg");
    line.add("--field", options.picture.field, "Colour the elements by this field, or by scaled_jacobian")
        .type_name("NAME");
    line.add("--zoom", options.zoom, "Show this part (default: the bodies, and the domain as an inset)")
        .type_name("xmin,ymin,xmax,ymax");
    line.add("--width", options.picture.width, "Width in pixels (PNG) or points (SVG)")
        .type_name("PX")
        .range(picture::kNarrowest, picture::kWidest);
    line.add_flag("--edges,!--no-edges", options.picture.edges,
                  "Draw the edges of the elements (default), or do not");
    line.add("--title", options.picture.title, "Write this above the picture").type_name("TEXT");
    line.add_from(options.from);
}

int view(int argc, char** argv)
{
    CommandLine line(
        kTool, "Draw a mesh, or two side by side",
        "  morph-view naca0012.su2 deformed.su2 -o before_after.png\n"
        "draws both around the airfoil, with the whole domain as an inset, and inverted elements\n"
        "in red; where there are any, a second row shows the worst spot from near.");
    Options options;
    add_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;

    if (!options.zoom.empty())
        options.picture.zoom = parse_zoom(options.zoom);
    refuse_case_files(options.meshes);
    const picture::ImageKind kind = picture::image_kind(options.out);
    OutputFiles::require_writable(options.out);
    Report report(line.common());
    OutputFiles outputs;
    const std::vector<Mesh> meshes = read_meshes(options);
    std::vector<picture::Subject> subjects;
    for (std::size_t i = 0; i < meshes.size(); ++i)
        subjects.push_back({&meshes[i], caption(options, i)});
    outputs.open(options.out).append(picture::draw_picture(subjects, options.picture, kind));
    describe(report, options, meshes);
    report.finish(outputs);
    return kDone;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-view", [&] { return morph::tools::view(argc, argv); });
}
