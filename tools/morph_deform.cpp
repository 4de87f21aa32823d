// morph-deform: move a mesh with its geometry.
//   morph-deform examples/01_thesis_case1/case.toml -o deformed.vtu --json report.json
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/deform/gradient.h"
#include "libmorph/deform/repair.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/weights/weight_fields.h"
#include "tools/case/generate_mesh.h"
#include "tools/common/command_line.h"
#include "tools/common/run.h"
#include "tools/deform/deform_report.h"
#include "tools/deform/gradient_file.h"
#include "tools/deform/polygon_crossings.h"

#include <algorithm>

namespace {

using namespace morph;
using namespace morph::tools;

constexpr const char* kTool = "morph-deform";

struct Options {
    std::string case_file;
    std::string output;
    std::string method;
    std::string diffusivity;
    std::string weights;
    std::string save_weights;
    std::string gradient;
    std::string guard;
    std::string from;
    std::string to;
};

void add_options(CommandLine& line, Options& options)
{
    line.add("case", options.case_file, "Case file: mesh, curves and how their control points move")
        .required()
        .type_name("CASE.toml");
    line.add("-o,--output", options.output, "The moved mesh (wins over [output] mesh)").type_name("OUT");
    line.add("--method", options.method,
             "How control points move the mesh: " + joined(move_methods()) + " (wins over [deform])")
        .one_of(move_methods());
    line.add("--diffusivity", options.diffusivity,
             "uniform, inverse-distance or inverse-area (wins over [deform])")
        .one_of(diffusivities());
    line.add("--weights", options.weights, "Take the weights from this file instead of solving for them")
        .type_name("W.vtu");
    line.add("--save-weights", options.save_weights,
             "Write the weights as nodal fields h_<boundary>_<i> on the undeformed mesh")
        .type_name("W.vtu");
    line.add("--gradient", options.gradient,
             "Move nothing: turn the derivatives dJ/dX of an objective by the vertices (CSV with "
             "id,dx,dy) into\n"
             "those by the control points, which go to OUT as CSV")
        .type_name("dJdX.csv");
    line.add("--guard", options.guard,
             "check: count inverted elements, look for crossing boundaries, exit with 3 if there\n"
             "are any; untangle: repair inverted elements first; remesh: and make anew what is left\n"
             "inverted or flat, which changes numbers; none: do not look")
        .one_of(guards());
    line.add_from(options.from);
    line.add_to(options.to);
}

CaseFile case_with_options(const Options& options)
{
    CaseFile file = read_case_file(options.case_file);
    const auto take = [](const std::string& option, std::string& setting) {
        if (!option.empty())
            setting = option;
    };
    take(options.method, file.deform.method);
    take(options.diffusivity, file.deform.diffusivity);
    take(options.guard, file.deform.guard);
    take(options.output, file.output_mesh);
    if (!options.gradient.empty() && options.output.empty())
        throw UsageError("where should the derivatives by the control points go? give -o OUT.csv");
    if (file.output_mesh.empty())
        throw UsageError("where should the moved mesh go? give -o OUT or [output] mesh in " + file.path);
    return file;
}

DeformResult result_for(const CaseFile& file)
{
    DeformResult result;
    result.method = file.deform.method;
    result.diffusivity = file.deform.diffusivity;
    result.guard = file.deform.guard;
    result.output = file.output_mesh;
    return result;
}

void require_outputs_writable(const Options& options, const CaseFile& file)
{
    if (options.gradient.empty())
        find_format(file.output_mesh, options.to);
    OutputFiles::require_writable(file.output_mesh);
    if (options.save_weights.empty())
        return;
    find_format(options.save_weights, "");
    OutputFiles::require_writable(options.save_weights);
}

Mesh load_mesh(const CaseFile& file, const std::string& from)
{
    return file.generate ? build_mesh(generate_mesh(file)) : read_mesh(file.mesh_file, from);
}

void stage_mesh(const MeshData& data, const std::string& path, const std::string& format,
                OutputFiles& outputs)
{
    for (const std::string& warning : write_mesh_data(data, path, outputs, format))
        warn(kTool, warning);
}

/// The undeformed mesh with the weights in the place of its own fields.
void stage_weights(Mesh& mesh, const Weights& weights, const std::string& path, OutputFiles& outputs)
{
    std::vector<Field> fields = weight_fields(weights);
    fields.swap(mesh.fields);
    stage_mesh(to_mesh_data(mesh), path, "", outputs);
    fields.swap(mesh.fields);
}

std::string advice(const DeformResult& result)
{
    if (!result.crossings.empty())
        return "no position of the others can mend it while the boundary crosses itself";
    if (result.untangled && !result.untangled->unrepairable.empty())
        return "element " + std::to_string(result.untangled->unrepairable[0]) +
               " has all its vertices on the boundary, so that no position of the others can mend it" +
               (result.guard == "remesh" ? "" : "; try guard = \"remesh\"");
    if (result.untangled)
        return "try steps = \"auto\" with rotations = true, or a smaller move";
    return "try guard = \"untangle\"";
}

void warn_of_invalid_mesh(const DeformResult& result)
{
    for (const std::string& crossing : result.crossings)
        warn(kTool, result.output + ": " + crossing + ": no valid mesh exists");
    if (result.before && result.before->inverted > 0)
        warn(kTool, "the mesh has " + std::to_string(result.before->inverted) +
                        " inverted elements before the move already");
    if (result.after && result.after->inverted > 0)
        warn(kTool, result.output + ": " + std::to_string(result.after->inverted) +
                        " of its elements are inverted; " + advice(result));
    if (result.safe_step && result.safe_step->step > 0 && result.after && result.after->inverted > 0)
        warn(kTool, safe_step_text(*result.safe_step));
}

void untangle_moved(Mesh& mesh, const Points& before, DeformResult& result)
{
    result.tangled = static_cast<Index>(inverted_elements(mesh, points(mesh)).size());
    if (result.tangled == 0)
        return;
    result.untangled = repair(mesh, before);
    for (std::vector<Index>* list : {&result.untangled->inverted, &result.untangled->unrepairable}) {
        for (Index& element : *list)
            element = mesh.numbering.element[static_cast<std::size_t>(element)];
        std::sort(list->begin(), list->end());
    }
}

/// The last resort, for what positions alone cannot mend.
void remesh_moved(Mesh& mesh, const Points& before, DeformResult& result)
{
    try {
        result.remeshed = remesh_bad_part(mesh, before);
    } catch (const InputError& error) {
        warn(kTool, result.output + ": " + error.what());
    }
    if (result.remeshed)
        warn(kTool, result.output + ": " + std::to_string(result.remeshed->elements) +
                        " elements were made anew: numbers of vertices and elements differ from those of the "
                        "mesh before the move there");
}

/// Moves the mesh and looks at every element before and after.
void move_and_check(Mesh& mesh, const CaseFile& file, const CaseMotion& motion, DeformResult& result)
{
    Stopwatch watch;
    const Points before = points(mesh);
    result.steps = apply_motion(mesh, file, motion, points(mesh));
    result.seconds.apply = watch.lap();
    for (std::size_t b = 0; b < motion.curves.boundaries.size(); ++b)
        result.fits.push_back(boundary_fit(motion.curves, b, before, points(mesh)));
    if (mesh.dimension == 2 && is_linear(file))
        result.safe_step = safe_step(mesh, before, points(mesh));
    if (result.guard != "none") {
        result.crossings = boundary_crossings(motion.curves);
        if (result.crossings.empty() && mesh.dimension == 2)
            result.crossings = polygon_crossings(mesh, before);
        result.before = quality_report(mesh, before);
        if ((result.guard == "untangle" || result.guard == "remesh") && result.crossings.empty())
            untangle_moved(mesh, before, result);
        if (result.guard == "remesh" && result.crossings.empty() && mesh.dimension == 2)
            remesh_moved(mesh, before, result);
        result.after = quality_report(mesh);
    }
    result.seconds.guard = watch.lap();
}

/// --gradient: derivatives by the vertices in, by the control points out; nothing moves.
void stage_gradient(const Options& options, const Mesh& mesh, const CaseMotion& motion, OutputFiles& outputs)
{
    const Matrix by_vertex = read_vertex_gradient(options.gradient, mesh);
    const std::array<Index, 3> lattice_points =
        motion.lattice ? motion.lattice->lattice.definition().points : std::array<Index, 3>{};
    write_control_point_gradient(outputs.open(options.output), motion.columns(),
                                 control_point_gradient(motion.rows(), by_vertex), lattice_points);
}

CaseMotion prepared_motion(const Mesh& mesh, const CaseFile& file, const Options& options)
{
    if (!is_linear(file) && (!options.gradient.empty() || !options.save_weights.empty()))
        throw InputError(file.path +
                         ": the move is not linear in the control points, so it has no weights to "
                         "save and no gradient");
    CaseMotion motion = prepare_motion(mesh, file, options.weights);
    for (const std::string& warning : placement_warnings(motion.curves))
        warn(kTool, warning);
    if (motion.lattice)
        for (const std::string& warning : motion.lattice->warnings)
            warn(kTool, warning);
    return motion;
}

int deform(int argc, char** argv)
{
    Options options;
    CommandLine line(
        kTool,
        "Moves a mesh with the geometry inside it: the nodes of each boundary follow the control\n"
        "points of its curve exactly, the nodes inside follow by harmonic weights. Or a lattice of\n"
        "free-form deformation moves the boundary, or all of the mesh.",
        "  morph-fit naca0012.su2 --marker airfoil -o case.toml   (then edit displacements)\n"
        "  morph-deform case.toml -o deformed.su2 --json report.json");
    add_options(line, options);
    if (!line.parse(argc, argv))
        return kDone;
    Report report(line.common());
    Stopwatch watch;
    const CaseFile file = case_with_options(options);
    require_outputs_writable(options, file);
    DeformResult result = result_for(file);
    Mesh mesh = load_mesh(file, options.from);
    result.seconds.read = watch.lap();
    CaseMotion motion = prepared_motion(mesh, file, options);
    result.weights = check_weights(motion);
    result.seconds.weights = watch.lap();
    OutputFiles outputs;
    if (!options.save_weights.empty())
        stage_weights(mesh, dense_weights(motion), options.save_weights, outputs);
    result.seconds.write = watch.lap();
    if (!options.gradient.empty()) {
        stage_gradient(options, mesh, motion, outputs);
    } else {
        result.control = control_motion(mesh, file, motion);
        move_and_check(mesh, file, motion, result);
        watch.lap();
        stage_mesh(to_mesh_data(mesh), file.output_mesh, options.to, outputs);
    }
    result.seconds.write += watch.lap();
    describe(result, motion, report);
    report.finish(outputs);
    warn_of_invalid_mesh(result);
    return is_valid(result) ? kDone : kInverted;
}

} // namespace

int main(int argc, char** argv)
{
    return run(kTool, [&] { return deform(argc, argv); });
}
