// morph-deform: move a mesh with its geometry.
//   morph-deform examples/01_thesis_case1/case.toml -o deformed.vtu --json report.json
#include "formats/case/case_file.h"
#include "formats/formats.h"
#include "formats/weights_file.h"
#include "libmorph/core/error.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/pipeline/deformer.h"
#include "libmorph/weights/weight_fields.h"
#include "tools/common/command_line.h"
#include "tools/common/run.h"
#include "tools/deform/deform_report.h"
#include "tools/deform/gradient_file.h"

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
             "How control points move the mesh: " + joined(names_of<Method>()) + " (wins over [deform])")
        .one_of(names_of<Method>());
    line.add("--diffusivity", options.diffusivity,
             "uniform, inverse-distance or inverse-area (wins over [deform])")
        .one_of(names_of<Diffusivity>());
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
             "are any; untangle: repair inverted elements first; remesh: and remesh what is left\n"
             "inverted or flat, which changes numbers; none: do not look")
        .one_of(names_of<Guard>());
    line.add_from(options.from);
    line.add_to(options.to);
}

template <NamedEnum Enum>
void take(const std::string& option, Enum& setting)
{
    if (!option.empty())
        setting = from_string<Enum>(option);
}

void warn_all(const std::vector<std::string>& warnings)
{
    for (const std::string& warning : warnings)
        warn(kTool, warning);
}

CaseFile case_with_options(const Options& options)
{
    CaseFile file = read_case_file(options.case_file);
    take(options.method, file.motion.deform.method);
    take(options.diffusivity, file.motion.deform.diffusivity);
    take(options.guard, file.motion.deform.guard);
    if (!options.output.empty())
        file.output_mesh = options.output;
    if (!options.gradient.empty() && options.output.empty())
        throw UsageError("where should the derivatives by the control points go? give -o OUT.csv");
    if (file.output_mesh.empty())
        throw UsageError("where should the moved mesh go? give -o OUT or [output] mesh in " + file.path);
    return file;
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

std::optional<Weights> given_weights(const Options& options, const Mesh& mesh, const MotionSettings& motion)
{
    if (options.weights.empty() || motion.deform.method == Method::ffd) // a lattice has its own
        return std::nullopt;
    require_weights_usable(motion.deform, options.weights);
    return read_weights(options.weights, mesh, control_points(motion));
}

Deformer make_deformer(const Mesh& mesh, CaseFile& file, const Options& options)
{
    if (!options.gradient.empty() || !options.save_weights.empty())
        require_linear(file.motion);
    take_su2_box(file, mesh);
    Deformer deformer(mesh, file.motion, given_weights(options, mesh, file.motion));
    warn_all(deformer.warnings());
    return deformer;
}

/// The undeformed mesh with the weights in the place of its own fields.
void stage_weights(const Deformer& deformer, const std::string& path, OutputFiles& outputs)
{
    Mesh mesh = deformer.mesh();
    mesh.fields = weight_fields(deformer.control_points(), *deformer.weights());
    warn_all(write_mesh_data(to_mesh_data(mesh), path, outputs));
}

/// --gradient: derivatives by the vertices in, by the control points out; nothing moves.
void stage_gradient(const Deformer& deformer, const Options& options, OutputFiles& outputs)
{
    const Matrix by_vertex = read_vertex_gradient(options.gradient, deformer.mesh());
    const PlacedLattice* lattice = deformer.lattice();
    write_control_point_gradient(outputs.open(options.output), deformer.control_points(),
                                 deformer.gradient(by_vertex),
                                 lattice ? lattice->lattice.definition().points : std::array<Index, 3>{});
}

int deform(const Options& options, const CommonOptions& common)
{
    Report report(common);
    Stopwatch watch;
    CaseFile file = case_with_options(options);
    require_outputs_writable(options, file);
    DeformRun run;
    run.output = file.output_mesh;
    const Mesh mesh = case_mesh(file, options.from);
    run.read_seconds = watch.lap();
    const Deformer deformer = make_deformer(mesh, file, options);
    run.weights_seconds = watch.lap();
    OutputFiles outputs;
    if (!options.save_weights.empty())
        stage_weights(deformer, options.save_weights, outputs);
    run.write_seconds = watch.lap();
    if (!options.gradient.empty()) {
        stage_gradient(deformer, options, outputs);
    } else {
        run.moved = deformer.move();
        warn_all(repairs(run));
        watch.lap();
        warn_all(write_mesh_data(to_mesh_data(mesh, run.moved), run.output, outputs, options.to));
    }
    run.write_seconds += watch.lap();
    describe(run, deformer, report);
    report.finish(outputs);
    warn_all(defects(run, file.motion.deform.guard));
    return is_valid(run.moved) ? kDone : kInverted;
}

} // namespace

int main(int argc, char** argv)
{
    return run(kTool, [&] {
        CommandLine line(
            kTool,
            "Moves a mesh with the geometry inside it: the nodes of each boundary follow the control\n"
            "points of its curve exactly, the nodes inside follow by harmonic weights. Or a lattice of\n"
            "free-form deformation moves the boundary, or all of the mesh.",
            "  morph-fit naca0012.su2 --marker airfoil -o case.toml   (then edit displacements)\n"
            "  morph-deform case.toml -o deformed.su2 --json report.json");
        Options options;
        add_options(line, options);
        return line.parse(argc, argv) ? deform(options, line.common()) : static_cast<int>(kDone);
    });
}
