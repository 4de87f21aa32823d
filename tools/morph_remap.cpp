// morph-remap: carry fields from one mesh to another.
//   morph-remap coarse.su2 fine.su2 --source-fields restart_flow.csv -o restart_fine.csv
#include "formats/formats.h"
#include "formats/input_file.h"
#include "formats/thesis/files.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remap/remap.h"
#include "tools/common/command_line.h"
#include "tools/common/field_source.h"
#include "tools/common/run.h"
#include "tools/remap/remap_report.h"

#include <algorithm>
#include <string>
#include <vector>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-remap";
constexpr const char* kStatus = "remap_status";
constexpr const char* kDistance = "remap_distance";

struct Options {
    std::string source;
    std::string target;
    std::string output;
    std::vector<std::string> fields;
    std::string source_fields;
    std::string source_neighbors;
    std::string outside;
    std::string quads = to_string(QuadRule::bilinear);
    std::string cells = "sample";
    bool conservative = false;
    InverseDistance inverse_distance;
    std::string from;
    std::string from_target;
    std::string to;
};

void add_options(CommandLine& line, Options& options)
{
    line.add("source", options.source, "Mesh with fields").required().type_name("SOURCE");
    line.add("target", options.target, "Mesh, or list of points (.csv with columns x,y[,z])")
        .required()
        .type_name("TARGET");
    line.add("-o,--output", options.output, "The target with the fields").required().type_name("OUT");
    line.add("--fields", options.fields, "Carry only these fields (default: all)")
        .comma_separated()
        .type_name("a,b");
    line.add("--source-fields", options.source_fields,
             "Fields of the source in a file of their own: an SU2 restart or other CSV file, the\n"
             "thesis's function values, or a mesh file of the same mesh")
        .type_name("FILE");
    line.add("--source-neighbors", options.source_neighbors,
             "The thesis's list of neighbours, to be checked against the source")
        .type_name("FILE.txt");
    line.add("--outside", options.outside,
             "Where targets outside the source get values from: idw (the nearest targets inside, by\n"
             "inverse distance; default for planar meshes), nearest (the nearest vertex of the source),\n"
             "project (its closest point; default for surfaces), fail (nowhere: an error)")
        .one_of(names_of<Outside>());
    line.add("--neighbors", options.inverse_distance.neighbors, "How many targets idw weighs")
        .show_default()
        .range(1, 1000000);
    line.add("--power", options.inverse_distance.power, "Power of the distance in idw")
        .show_default()
        .positive();
    line.add("--quads", options.quads,
             "How values vary in a quad: bilinear, or split into the triangles 1 2 3 and 1 3 4")
        .show_default()
        .one_of(names_of<QuadRule>());
    line.add("--cells", options.cells,
             "Element fields: sample (the value at the centre of each target element), or conservative\n"
             "(the mean over what the source covers of it, which keeps the integral)")
        .show_default()
        .one_of({"sample", "conservative"});
    line.add_flag("--conservative", options.conservative,
                  "Nodal fields: keep the integral (Galerkin projection) instead of interpolating");
    line.add_from(options.from);
    line.add("--from-target", options.from_target, "Format of TARGET, when its extension does not say")
        .type_name("NAME");
    line.add_to(options.to);
}

/// The source with the fields of --source-fields in the place of its own of the same names.
Mesh load_source(Options& options)
{
    MeshData data = read_mesh_data(options.source, options.from);
    if (!options.source_fields.empty()) {
        const bool su2_restart = take_fields_from(options.source_fields, data);
        if (su2_restart && options.to.empty() && find_format(options.output, "").name == "csv")
            options.to = "su2_restart";
    }
    Mesh source = build_mesh_of(std::move(data), options.source);
    if (!options.source_neighbors.empty()) {
        const InputFile file(options.source_neighbors);
        check_thesis_neighbors({options.source_neighbors, file.bytes()}, source);
    }
    return source;
}

/// What goes into the output: a format of points alone gets no more, without a word about it.
MeshData output_data(const Mesh& target, const Options& options)
{
    MeshData data = to_mesh_data(target);
    if (!find_format(options.output, options.to).holds.elements) {
        data.elements.clear();
        data.markers.clear();
        data.sections.clear();
    }
    return data;
}

/// The fields to carry: those asked for, or all.
std::vector<const Field*> chosen_fields(const Mesh& source, const Options& options)
{
    std::vector<const Field*> chosen;
    std::vector<std::string> names;
    for (const Field& field : source.fields) {
        names.push_back(field.name);
        const auto& wanted = options.fields;
        if (wanted.empty() || std::find(wanted.begin(), wanted.end(), field.name) != wanted.end())
            chosen.push_back(&field);
    }
    const std::string& where = options.source_fields.empty() ? options.source : options.source_fields;
    for (const std::string& name : options.fields)
        if (std::find(names.begin(), names.end(), name) == names.end())
            throw InputError(where + ": has no field '" + name + "', but " +
                             (names.empty() ? "none at all" : joined(names)) + did_you_mean(name, names));
    if (chosen.empty())
        throw InputError(
            where + ": has no fields to carry" +
            (options.source_fields.empty() ? "; --source-fields FILE names a file that has" : ""));
    return chosen;
}

RemapSettings settings_of(const Options& options)
{
    RemapSettings settings;
    if (!options.outside.empty())
        settings.outside = from_string<Outside>(options.outside);
    settings.inverse_distance = options.inverse_distance;
    settings.conserve_nodal = options.conservative;
    settings.conserve_elements = options.cells == "conservative";
    settings.quads = from_string<QuadRule>(options.quads);
    return settings;
}

bool tells_distance(const Mesh& source, const RemapSettings& settings)
{
    return source.dimension == 3 || settings.outside == Outside::project;
}

void warn_of_outside(const RemapResult& result)
{
    if (const std::string text = outside_warning(result.vertices, "targets"); !text.empty())
        warn(kTool, text);
    if (result.elements)
        if (const std::string text = outside_warning(*result.elements, "element centres"); !text.empty())
            warn(kTool, text);
}

/// Carries the fields and adds them, and where the targets lie, to the target.
void transfer(const Mesh& source, Mesh& target, const Options& options, RemapResult& result)
{
    Stopwatch watch;
    const std::vector<const Field*> fields = chosen_fields(source, options);
    const RemapSettings settings = settings_of(options);
    result.outside_rule =
        to_string(settings.outside.value_or(source.dimension == 2 ? Outside::idw : Outside::project));
    const Locator locator(source);
    Remapper remapper(locator, target, settings);
    const TargetLocations& targets = remapper.locations(FieldLocation::vertex);
    result.vertices = count_targets(targets, target.numbering.vertex);
    const bool to_elements =
        element_count(target) > 0 && std::any_of(fields.begin(), fields.end(), [](const Field* field) {
            return field->location == FieldLocation::element;
        });
    if (to_elements)
        result.elements = count_targets(remapper.locations(FieldLocation::element), target.numbering.element);
    result.seconds.locate = watch.lap();
    std::vector<Field> transferred = remapper.transfer(fields);
    result.nodal_conservation = remapper.conservation(FieldLocation::vertex);
    result.element_conservation = remapper.conservation(FieldLocation::element);
    result.seconds.interpolate = watch.lap();
    for (std::size_t i = 0; i < fields.size(); ++i)
        result.fields.push_back({transferred[i].name, transferred[i].location,
                                 field_totals(source, *fields[i]), field_totals(target, transferred[i])});
    for (Field& field : transferred)
        set_field(target.fields, std::move(field));
    set_field(target.fields, {kStatus, FieldLocation::vertex, target_status(targets)});
    if (tells_distance(source, settings))
        set_field(target.fields, {kDistance, FieldLocation::vertex, target_distances(targets)});
}

int remap(int argc, char** argv)
{
    Options options;
    CommandLine line(
        kTool,
        "Transfers fields from one mesh to another: interpolated where a target lies in an element of\n"
        "the source, by --outside where it lies in none.",
        "  morph-remap coarse.su2 fine.su2 --source-fields restart_flow.csv -o restart_fine.csv\n"
        "writes the flow of the coarse mesh as a restart file for the fine one.");
    add_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;
    Report report(line.common());
    find_format(options.output, options.to);
    OutputFiles::require_writable(options.output);

    RemapResult result;
    result.source = options.source;
    result.target = options.target;
    result.output = options.output;
    Stopwatch watch;
    const Mesh source = load_source(options);
    Mesh target = read_mesh(options.target, options.from_target);
    result.seconds.read = watch.lap();
    transfer(source, target, options, result);
    watch.lap();
    warn_of_outside(result);
    OutputFiles outputs;
    for (const std::string& warning :
         write_mesh_data(output_data(target, options), options.output, outputs, options.to))
        warn(kTool, warning);
    result.seconds.write = watch.lap();
    describe(result, report);
    report.finish(outputs);
    return kDone;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-remap", [&] { return morph::tools::remap(argc, argv); });
}
