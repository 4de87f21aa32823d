#include "tools/remap/remap_report.h"

#include "libmorph/core/names.h"

#include <nlohmann/json.hpp>

namespace morph::tools {

namespace {

using nlohmann::ordered_json;

ordered_json row_json(const Eigen::RowVectorXd& row)
{
    ordered_json json = ordered_json::array();
    for (const double value : row)
        json.push_back(value);
    return json;
}

ordered_json totals_json(const FieldTotals& totals)
{
    ordered_json json{{"min", row_json(totals.min)}, {"max", row_json(totals.max)}};
    if (totals.integral.size() > 0)
        json["integral"] = row_json(totals.integral);
    return json;
}

std::string place(const Eigen::RowVector3d& point)
{
    const std::string xy = "(" + short_number(point.x()) + ", " + short_number(point.y());
    return point.z() == 0 ? xy + ")" : xy + ", " + short_number(point.z()) + ")";
}

std::string outside_text(const TargetCounts& counts, const std::string& what)
{
    const double percent = 100.0 * static_cast<double>(counts.outside) / static_cast<double>(counts.targets);
    return std::to_string(counts.outside) + " of " + std::to_string(counts.targets) + " " + what + " (" +
           short_number(percent) + " %) lie outside the source, the farthest, number " +
           std::to_string(counts.farthest) + " at " + place(counts.where) + ", by " +
           short_number(counts.distance);
}

/// What the common area leaves of an area; less than rounding is nothing.
double uncovered(double whole, double common)
{
    constexpr double kRounding = 1e-13;
    const double rest = whole - common;
    return rest > kRounding * whole ? rest : 0;
}

ordered_json farthest_json(const TargetCounts& counts)
{
    return {{"target", counts.farthest},
            {"x", counts.where.x()},
            {"y", counts.where.y()},
            {"z", counts.where.z()},
            {"distance", counts.distance}};
}

std::string numbers(const Eigen::RowVectorXd& row)
{
    std::string text;
    for (const double value : row)
        text += (text.empty() ? "" : " ") + short_number(value);
    return row.size() == 1 ? text : "(" + text + ")";
}

std::string range(const FieldTotals& totals)
{
    const std::string text = numbers(totals.min) + " to " + numbers(totals.max);
    return totals.integral.size() == 0 ? text : text + ", integral " + numbers(totals.integral);
}

void describe_conservation(const Conservation& conservation, const std::string& key, const std::string& what,
                           Report& report)
{
    const double common = conservation.common_area;
    const double source = uncovered(conservation.source_area, common);
    const double target = uncovered(conservation.target_area, common);
    ordered_json json{{"common_area", common},
                      {"uncovered_source_area", source},
                      {"uncovered_target_area", target},
                      {"uncovered_" + what, conservation.uncovered},
                      {"fields", ordered_json::array()}};
    report.say("common area " + short_number(common) + "; not covered: " + short_number(source) +
               " of the source, " + short_number(target) + " of the target; " +
               std::to_string(conservation.uncovered) + " " + what + " wholly");
    for (const auto& field : conservation.fields) {
        json["fields"].push_back({{"name", field.field},
                                  {"source_integral", row_json(field.source)},
                                  {"target_integral", row_json(field.target)}});
        report.say("  integral of " + field.field + " over it: " + numbers(field.source) + " before, " +
                   numbers(field.target) + " after");
    }
    report.json[key] = std::move(json);
}

void describe_fields(const RemapResult& result, Report& report)
{
    report.json["fields"] = ordered_json::array();
    report.json["changes"] = ordered_json::array();
    for (const FieldChange& field : result.fields) {
        report.json["fields"].push_back(field.name);
        report.json["changes"].push_back(
            {{"name", field.name},
             {"location", field.location == FieldLocation::vertex ? "vertex" : "element"},
             {"source", totals_json(field.source)},
             {"target", totals_json(field.target)}});
        report.say("field " + field.name + ": " + range(field.source) + "; now " + range(field.target));
    }
}

void describe_targets(const RemapResult& result, Report& report)
{
    const TargetCounts& counts = result.vertices;
    report.json["targets"] = counts.targets;
    report.json["inside"] = counts.targets - counts.outside;
    report.json["outside"] = counts.outside;
    report.json["outside_rule"] = result.outside_rule;
    if (counts.outside > 0)
        report.json["farthest_outside"] = farthest_json(counts);
    report.say(counts.outside == 0 ? "all " + std::to_string(counts.targets) + " targets lie in the source"
                                   : outside_text(counts, "targets") + "; filled by " + result.outside_rule);
    if (!result.elements)
        return;
    const TargetCounts& elements = *result.elements;
    report.json["elements"] = {{"targets", elements.targets},
                               {"inside", elements.targets - elements.outside},
                               {"outside", elements.outside}};
    if (elements.outside > 0)
        report.say(outside_text(elements, "element centres"));
}

} // namespace

std::string outside_warning(const TargetCounts& counts, const std::string& what)
{
    constexpr std::size_t kOneIn = 100;
    return counts.outside * kOneIn > counts.targets ? outside_text(counts, what) : "";
}

void describe(const RemapResult& result, Report& report)
{
    report.json["source"] = result.source;
    report.json["target"] = result.target;
    report.json["output"] = result.output;
    describe_targets(result, report);
    describe_fields(result, report);
    if (result.nodal_conservation)
        describe_conservation(*result.nodal_conservation, "nodal_conservation", "vertices", report);
    if (result.element_conservation)
        describe_conservation(*result.element_conservation, "element_conservation", "elements", report);
    const RemapSeconds& seconds = result.seconds;
    report.json["seconds"] = {{"read", seconds.read},
                              {"locate", seconds.locate},
                              {"interpolate", seconds.interpolate},
                              {"write", seconds.write}};
    report.say("written to " + result.output + " (locate " + short_number(seconds.locate) +
               " s, interpolate " + short_number(seconds.interpolate) + " s)");
}

} // namespace morph::tools
