#include "tools/deform/deform_report.h"

#include "libmorph/core/names.h"
#include "tools/common/quality_json.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <utility>

namespace morph::tools {

namespace {

using nlohmann::ordered_json;

ordered_json boundary_json(const CurveBoundary& boundary, const BoundaryFit& fit)
{
    return {{"name", boundary.name},
            {"nodes", boundary.vertices.size()},
            {"degree", boundary.curve.degree()},
            {"closed", boundary.curve.closed()},
            {"control_points", boundary.curve.control_point_count()},
            {"max_distance", fit.largest_distance},
            {"mean_distance", fit.mean_distance},
            {"landing_error", fit.landing_error}};
}

std::string boundary_line(const CurveBoundary& boundary, const BoundaryFit& fit)
{
    return "boundary " + boundary.name + ": " + std::to_string(boundary.vertices.size()) + " nodes on " +
           (boundary.curve.closed() ? "a closed" : "an open") + " curve of degree " +
           std::to_string(boundary.curve.degree()) + " with " +
           std::to_string(boundary.curve.control_point_count()) + " control points; at most " +
           short_number(fit.largest_distance) + " off it, moved with an error of " +
           short_number(fit.landing_error);
}

std::string weights_line(const Deformer& deformer, const WeightsCheck& weights, double seconds)
{
    const DeformSettings& deform = deformer.settings().deform;
    std::string method = to_string(deform.method);
    if (deform.method == Method::harmonic)
        method += " (" + to_string(deform.diffusivity) + ")";
    return "weights: " + method + ", " + std::to_string(deformer.control_points().size()) +
           " control points, from " + short_number(weights.min) + " to " + short_number(weights.max) + ", " +
           short_number(seconds) + " s";
}

ordered_json seconds_json(const DeformRun& run)
{
    return {{"read", run.read_seconds},
            {"weights", run.weights_seconds},
            {"apply", run.moved.seconds.apply},
            {"guard", run.moved.seconds.guard},
            {"write", run.write_seconds}};
}

void describe_pull(const PullOutcome& pull, Report& report)
{
    const double farthest = pull.residual.rowwise().norm().maxCoeff();
    ordered_json residuals = ordered_json::array();
    for (std::size_t i = 0; i < pull.vertices.size(); ++i) {
        ordered_json row = ordered_json::array();
        for (const double component : pull.residual.row(static_cast<Eigen::Index>(i)))
            row.push_back(component);
        residuals.push_back({{"vertex", pull.vertices[i]}, {"residual", row}});
    }
    report.json["pull"] = {{"points", pull.vertices.size()},
                           {"rank", pull.rank},
                           {"max_residual", farthest},
                           {"residuals", residuals}};
    report.say("pulled " + std::to_string(pull.vertices.size()) + " points, reached to within " +
               short_number(farthest));
}

void describe_lattice(const PlacedLattice& placed, Report& report)
{
    const LatticeDefinition& shape = placed.lattice.definition();
    const auto vertices = placed.embedding.inside.size();
    const auto inside = static_cast<std::size_t>(placed.embedding.inside_count);
    report.json["lattice"] = {
        {"basis", to_string(shape.basis)}, {"degree", shape.degree}, {"points", shape.points},
        {"held", placed.held.size()},      {"inside", inside},       {"outside", vertices - inside}};
    report.say("lattice: " + std::to_string(inside) + " of " + std::to_string(vertices) +
               " vertices lie in it");
}

void describe_constraints(const ConstrainedMove& move, Report& report)
{
    ordered_json measured = ordered_json::array();
    report.say("constraints: met by changing the control points by " + short_number(move.change) +
               " in all, in " + std::to_string(move.iterations) + " steps");
    for (const MeasuredConstraint& item : move.measured) {
        measured.push_back({{"name", item.name},
                            {"before", item.undisplaced},
                            {"wanted", item.wanted},
                            {"bound", item.bound},
                            {"reached", item.reached},
                            {"active", item.active}});
        report.say("  " + item.name + ": " + short_number(item.undisplaced) + " before the move, " +
                   short_number(item.reached) + " after it, " + short_number(item.wanted) +
                   " without the constraints");
    }
    report.json["constraints"] = {
        {"change", move.change}, {"iterations", move.iterations}, {"measured", measured}};
}

void describe_control(const ControlOutcome& control, Report& report)
{
    if (control.curve_misfit) {
        report.json["curve_misfit"] = *control.curve_misfit;
        report.say("the lattice makes the moved curves to within " + short_number(*control.curve_misfit));
    }
    if (control.pull)
        describe_pull(*control.pull, report);
    if (control.constrained)
        describe_constraints(*control.constrained, report);
}

/// At most 4 digits, and not above the value: a step that is reported must be safe.
double rounded_down(double value)
{
    if (value <= 0)
        return 0;
    const double digits = std::pow(10, 3 - std::floor(std::log10(value)));
    return std::floor(value * digits) / digits;
}

/// How much of the move is safe and what stops it; the number is rounded down.
std::string safe_step_text(const SafeStep& safe)
{
    return "only " + short_number(rounded_down(safe.step)) + " of this move is safe: element " +
           std::to_string(safe.element) + " turns over there";
}

void describe_safe_step(const SafeStep& safe, Report& report)
{
    report.json["safe_step"] = {{"step", safe.step},
                                {"element", safe.step < 1 ? ordered_json(safe.element) : nullptr}};
    report.say(safe.step < 1 ? safe_step_text(safe) : "all of this move is safe");
}

void describe_untangling(const MoveResult& moved, Report& report)
{
    const UntangleResult& repair = *moved.untangled;
    report.json["untangle"] = {{"tangled", moved.tangled},
                               {"inverted", repair.inverted.size()},
                               {"hopeless", repair.unrepairable},
                               {"patch_vertices", repair.patch_vertices},
                               {"iterations", repair.iterations}};
    report.say("untangled: " + std::to_string(moved.tangled) + " inverted elements before, " +
               std::to_string(repair.inverted.size()) + " after, " + std::to_string(repair.patch_vertices) +
               " vertices moved in " + std::to_string(repair.iterations) + " iterations");
}

void describe_remeshed(const RemeshedPart& part, Report& report)
{
    report.json["remeshed"] = {{"elements", part.elements},
                               {"vertices_before", part.vertices_before},
                               {"vertices_after", part.vertices_after}};
    report.say("remeshed: " + std::to_string(part.elements) + " elements, " +
               std::to_string(part.vertices_before) + " vertices before, " +
               std::to_string(part.vertices_after) + " after");
}

void describe_quality(const MoveResult& moved, Report& report)
{
    if (!moved.before || !moved.after)
        return;
    report.json["quality"] = {{"before", quality_json(*moved.before)}, {"after", quality_json(*moved.after)}};
    for (const auto& [when, quality] :
         {std::pair("before the move", &*moved.before), {"after the move", &*moved.after}}) {
        report.say(std::string(when) + ":");
        for (const std::string& line : quality_summary(*quality))
            report.say("  " + line);
    }
}

void describe_checks(const MoveResult& moved, Report& report)
{
    report.json["boundary_crossings"] = moved.crossings;
    if (moved.safe_step)
        describe_safe_step(*moved.safe_step, report);
    if (moved.untangled)
        describe_untangling(moved, report);
    if (moved.remeshed)
        describe_remeshed(*moved.remeshed, report);
    describe_quality(moved, report);
}

std::string advice(const MoveResult& moved, Guard guard)
{
    if (!moved.crossings.empty())
        return "no position of the others can repair it while the boundary crosses itself";
    if (moved.untangled && !moved.untangled->unrepairable.empty())
        return "element " + std::to_string(moved.untangled->unrepairable[0]) +
               " has all its vertices on the boundary, so that no position of the others can repair it" +
               (guard == Guard::remesh ? "" : "; try guard = \"remesh\"");
    if (moved.untangled)
        return "try steps = \"auto\" with rotations = true, or a smaller move";
    return "try guard = \"untangle\"";
}

} // namespace

void describe(const DeformRun& run, const Deformer& deformer, Report& report)
{
    const DeformSettings& deform = deformer.settings().deform;
    ordered_json& json = report.json;
    json["method"] = to_string(deform.method);
    json["diffusivity"] = to_string(deform.diffusivity);
    json["guard"] = to_string(deform.guard);
    json["steps"] = run.moved.steps;
    json["output"] = run.output;
    json["control_points"] = deformer.control_points().size();
    json["boundaries"] = ordered_json::array();
    for (std::size_t b = 0; b < run.moved.fits.size(); ++b) {
        json["boundaries"].push_back(boundary_json(deformer.boundaries()[b], run.moved.fits[b]));
        report.say(boundary_line(deformer.boundaries()[b], run.moved.fits[b]));
    }
    const WeightsCheck weights = deformer.weights_check();
    json["weights"] = {
        {"min", weights.min}, {"max", weights.max}, {"partition_error", weights.partition_error}};
    report.say(weights_line(deformer, weights, run.weights_seconds));
    if (const PlacedLattice* lattice = deformer.lattice())
        describe_lattice(*lattice, report);
    describe_control(run.moved.control, report);
    describe_checks(run.moved, report);
    json["seconds"] = seconds_json(run);
    report.say("wrote " + run.output);
}

std::vector<std::string> repairs(const DeformRun& run)
{
    std::vector<std::string> found;
    for (const std::string& warning : run.moved.warnings)
        found.push_back(run.output + ": " + warning);
    if (run.moved.remeshed)
        found.push_back(run.output + ": " + std::to_string(run.moved.remeshed->elements) +
                        " elements were remeshed: numbers of vertices and elements differ from those of the "
                        "mesh before the move there");
    return found;
}

std::vector<std::string> defects(const DeformRun& run, Guard guard)
{
    const MoveResult& moved = run.moved;
    std::vector<std::string> found;
    for (const std::string& crossing : moved.crossings)
        found.push_back(run.output + ": " + crossing + ": no valid mesh exists");
    if (moved.before && moved.before->inverted > 0)
        found.push_back("the mesh has " + std::to_string(moved.before->inverted) +
                        " inverted elements before the move already");
    if (!moved.after || moved.after->inverted == 0)
        return found;
    found.push_back(run.output + ": " + std::to_string(moved.after->inverted) +
                    " of its elements are inverted; " + advice(moved, guard));
    if (moved.safe_step && moved.safe_step->step > 0)
        found.push_back(safe_step_text(*moved.safe_step));
    return found;
}

} // namespace morph::tools
