// morph-quality: what is wrong with this mesh.
//   morph-quality deformed.su2 --reference naca0012.su2 --list bad.csv --picture worst.png
#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/element_metrics.h"
#include "tools/common/command_line.h"
#include "tools/common/report.h"
#include "tools/common/run.h"
#include "tools/picture/image_kind.h"
#include "tools/picture/picture.h"
#include "tools/quality/element_files.h"
#include "tools/quality/full_report.h"
#include "tools/quality/reference.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-quality";

struct Options {
    std::string mesh;
    std::string reference;
    std::string list;
    std::string csv;
    std::string vtu;
    std::string picture;
    std::string from;
};

void add_options(CommandLine& line, Options& options)
{
    line.add("mesh", options.mesh, "Mesh file").required().type_name("MESH");
    line.add("--reference", options.reference,
             "The same mesh before it was moved: adds size-skew and what changed next to the walls")
        .type_name("UNDEFORMED");
    line.add("--list", options.list, "Write the inverted elements with their metrics as CSV")
        .type_name("FILE.csv");
    line.add("--csv", options.csv, "Write every element with its metrics as CSV").type_name("FILE.csv");
    line.add("--vtu", options.vtu, "Write the mesh with every metric as an element field")
        .type_name("FILE.vtu");
    line.add("--picture", options.picture,
             "Draw the mesh by scaled Jacobian, and its worst element from near")
        .type_name("OUT.png|OUT.svg");
    line.add_from(options.from);
}

void require_writable(const Options& options)
{
    for (const std::string& path : {options.list, options.csv, options.vtu, options.picture})
        if (!path.empty())
            OutputFiles::require_writable(path);
    if (!options.picture.empty())
        picture::image_kind(options.picture);
}

void write_element_files(const Options& options, OutputFiles& outputs, const Mesh& mesh,
                         const PositionsView* reference)
{
    if (options.list.empty() && options.csv.empty() && options.vtu.empty())
        return;
    MeshData data = to_mesh_data(mesh);
    std::vector<Field> metrics = element_metrics(mesh, reference);
    if (!options.list.empty())
        write_elements(outputs.open(options.list), data, metrics, true);
    if (!options.csv.empty())
        write_elements(outputs.open(options.csv), data, metrics, false);
    if (options.vtu.empty())
        return;
    add_metric_fields(data, std::move(metrics));
    for (const std::string& warning : write_mesh_data(data, options.vtu, outputs, "vtu"))
        warn(kTool, warning);
}

void draw(const Options& options, OutputFiles& outputs, const Mesh& mesh)
{
    if (options.picture.empty())
        return;
    picture::PictureOptions look;
    look.field = "scaled_jacobian";
    look.close_up = true;
    const std::string name = std::filesystem::path(options.mesh).filename().string();
    outputs.open(options.picture)
        .append(picture::draw_picture({{&mesh, name}}, look, picture::image_kind(options.picture)));
}

FullQuality check(const Options& options, OutputFiles& outputs)
{
    const Mesh mesh = read_mesh(options.mesh, options.from);
    std::optional<Points> reference;
    std::optional<PositionsView> view;
    if (!options.reference.empty())
        view.emplace(
            reference.emplace(reference_points(options.reference, options.from, mesh, options.mesh)));
    const PositionsView* before = view ? &*view : nullptr;
    write_element_files(options, outputs, mesh, before);
    draw(options, outputs, mesh);
    return full_quality(mesh, before);
}

int quality(int argc, char** argv)
{
    CommandLine line(
        kTool, "What is wrong with this mesh: inverted and badly shaped elements, cells next to walls",
        "  morph-quality deformed.su2 --reference naca0012.su2 --list bad.csv --picture worst.png\n"
        "counts the inverted elements of deformed.su2, compares every element with what it was in\n"
        "naca0012.su2, lists the inverted ones in bad.csv, and draws the worst spot.");
    Options options;
    add_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;

    require_writable(options);
    Report report(line.common());
    OutputFiles outputs;
    const FullQuality result = check(options, outputs);
    describe(result, report);
    report.finish(outputs);
    return result.summary.inverted > 0 ? kInverted : kDone;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run(morph::tools::kTool, [&] { return morph::tools::quality(argc, argv); });
}
