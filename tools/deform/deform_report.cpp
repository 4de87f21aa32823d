#include "tools/deform/deform_report.h"

#include "tools/common/quality_json.h"

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

std::string weights_line(const DeformResult& result, std::size_t control_points)
{
    const std::string method =
        result.method == "harmonic" ? result.method + " (" + result.diffusivity + ")" : result.method;
    return "weights: " + method + ", " + std::to_string(control_points) + " control points, from " +
           short_number(result.weights.min) + " to " + short_number(result.weights.max) + ", " +
           short_number(result.seconds.weights) + " s";
}

ordered_json seconds_json(const StageSeconds& seconds)
{
    return {{"read", seconds.read},
            {"weights", seconds.weights},
            {"apply", seconds.apply},
            {"guard", seconds.guard},
            {"write", seconds.write}};
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
    report.json["lattice"] = {{"basis", shape.basis == LatticeBasis::bernstein ? "bernstein" : "bspline"},
                              {"degree", shape.degree},
                              {"points", shape.points},
                              {"held", placed.held.size()},
                              {"inside", inside},
                              {"outside", vertices - inside}};
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

/// At most 4 digits, and not above the value: a step that is told must be safe.
double rounded_down(double value)
{
    if (value <= 0)
        return 0;
    const double digits = std::pow(10, 3 - std::floor(std::log10(value)));
    return std::floor(value * digits) / digits;
}

void describe_safe_step(const SafeStep& safe, Report& report)
{
    report.json["safe_step"] = {{"step", safe.step},
                                {"element", safe.step < 1 ? ordered_json(safe.element) : nullptr}};
    report.say(safe.step < 1 ? safe_step_text(safe) : "all of this move is safe");
}

void describe_repair(const DeformResult& result, Report& report)
{
    const UntangleResult& repair = *result.untangled;
    report.json["untangle"] = {{"tangled", result.tangled},
                               {"inverted", repair.inverted.size()},
                               {"hopeless", repair.unrepairable},
                               {"patch_vertices", repair.patch_vertices},
                               {"iterations", repair.iterations}};
    report.say("untangled: " + std::to_string(result.tangled) + " inverted elements before, " +
               std::to_string(repair.inverted.size()) + " after, " + std::to_string(repair.patch_vertices) +
               " vertices moved in " + std::to_string(repair.iterations) + " iterations");
}

void describe_remeshed(const RemeshedPart& part, Report& report)
{
    report.json["remeshed"] = {{"elements", part.elements},
                               {"vertices_before", part.vertices_before},
                               {"vertices_after", part.vertices_after}};
    report.say("remeshed: " + std::to_string(part.elements) + " elements made anew, " +
               std::to_string(part.vertices_before) + " vertices before, " +
               std::to_string(part.vertices_after) + " after");
}

void describe_quality(const DeformResult& result, Report& report)
{
    if (!result.before || !result.after)
        return;
    report.json["quality"] = {{"before", quality_json(*result.before)},
                              {"after", quality_json(*result.after)}};
    for (const auto& [when, quality] :
         {std::pair("before the move", &*result.before), {"after the move", &*result.after}}) {
        report.say(std::string(when) + ":");
        for (const std::string& line : quality_summary(*quality))
            report.say("  " + line);
    }
}

} // namespace

bool is_valid(const DeformResult& result)
{
    return result.crossings.empty() && !(result.after && result.after->inverted > 0);
}

std::string safe_step_text(const SafeStep& safe)
{
    return "only " + short_number(rounded_down(safe.step)) + " of this move is safe: element " +
           std::to_string(safe.element) + " turns over there";
}

void describe(const DeformResult& result, const CaseMotion& motion, Report& report)
{
    const PlacedBoundaries& placed = motion.curves;
    ordered_json& json = report.json;
    json["method"] = result.method;
    json["diffusivity"] = result.diffusivity;
    json["guard"] = result.guard;
    json["steps"] = result.steps;
    json["output"] = result.output;
    json["control_points"] = motion.columns().size();
    json["boundaries"] = ordered_json::array();
    for (std::size_t b = 0; b < result.fits.size(); ++b) { // none when only a gradient was asked for
        json["boundaries"].push_back(boundary_json(placed.boundaries[b], result.fits[b]));
        report.say(boundary_line(placed.boundaries[b], result.fits[b]));
    }
    json["weights"] = {{"min", result.weights.min},
                       {"max", result.weights.max},
                       {"partition_error", result.weights.partition_error}};
    report.say(weights_line(result, motion.columns().size()));
    if (motion.lattice)
        describe_lattice(*motion.lattice, report);
    describe_control(result.control, report);
    json["boundary_crossings"] = result.crossings;
    if (result.safe_step)
        describe_safe_step(*result.safe_step, report);
    if (result.untangled)
        describe_repair(result, report);
    if (result.remeshed)
        describe_remeshed(*result.remeshed, report);
    describe_quality(result, report);
    json["seconds"] = seconds_json(result.seconds);
    report.say("wrote " + result.output);
}

} // namespace morph::tools
