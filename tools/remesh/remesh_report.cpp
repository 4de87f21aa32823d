#include "tools/remesh/remesh_report.h"

#include "libmorph/core/names.h"
#include "tools/common/quality_json.h"
#include "tools/common/run.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <optional>
#include <vector>

namespace morph::tools {

namespace {

nlohmann::ordered_json coordinates(const Mesh& mesh, const Eigen::Vector3d& point)
{
    nlohmann::ordered_json all{point.x(), point.y()};
    if (mesh.dimension == 3)
        all.push_back(point.z());
    return all;
}

/// (x, y) or (x, y, z).
std::string text_of(const nlohmann::ordered_json& coordinates)
{
    std::string text;
    for (const auto& x : coordinates)
        text += (text.empty() ? "(" : ", ") + short_number(x);
    return text + ")";
}

Eigen::Vector3d centroid(const Mesh& mesh, Index triangle)
{
    const Element e = element_corners(mesh, triangle);
    const auto place = points(mesh);
    return (place.row(e[0]) + place.row(e[1]) + place.row(e[2])) / 3;
}

/// Smallest, mean and worst of the triangles: the measure that remeshing aims at.
nlohmann::ordered_json triangle_json(const Mesh& mesh, const std::optional<TriangleSummary>& triangles)
{
    if (!triangles)
        return nullptr;
    return {{"min", triangles->min},
            {"mean", triangles->mean},
            {"worst_element", file_element(mesh, triangles->worst)},
            {"worst_at", coordinates(mesh, centroid(mesh, triangles->worst))}};
}

std::string worst_triangle(const nlohmann::ordered_json& triangles)
{
    if (triangles.is_null()) // only inverted quads, which were cut out
        return "none";
    return short_number(triangles["min"]) + " (element " +
           std::to_string(triangles["worst_element"].get<Index>()) + " at " + text_of(triangles["worst_at"]) +
           ")";
}

/// Why an edge does not have its target length, as far as that is known.
std::string cause_text(const SizeCheck& sizes)
{
    switch (sizes.cause) {
    case ShortEdgeCause::limited:
        return ": a boundary that is curved there, or a kept element, asks for " +
               short_number(sizes.possible_part) + " of it";
    case ShortEdgeCause::held:
        return ": what is held there is nearer than that";
    default:
        return "";
    }
}

void describe_count(const Mesh& mesh, Index target, Report& report)
{
    constexpr double kNear = 0.02;
    const auto count = static_cast<double>(vertex_count(mesh));
    if (target == 0 || std::abs(count / target - 1) <= kNear)
        return;
    report.say("  " + std::to_string(target) + " vertices were asked for: " +
               (count > target ? "boundaries, corners and kept elements ask for more"
                               : "sizes cannot be lowered that evenly"));
}

/// The target sizes, and how well they are met.
void describe_sizes(const Mesh& mesh, const SizeCheck& sizes, Report& report)
{
    constexpr double kShort = 0.7, kLong = 1.4;
    report.json["size_conformity"] = sizes.share;
    report.json["possible_size_conformity"] = sizes.possible_share;
    report.say("  " + short_number(100 * sizes.share) +
               " % of the edges have 0.7 to 1.4 times the target length" +
               (sizes.possible_share > sizes.share ? ", " + short_number(100 * sizes.possible_share) +
                                                         " % of them what boundaries and kept elements allow"
                                                   : ""));
    if (sizes.worst[0] < 0) // all have exactly the target length
        return;
    const nlohmann::ordered_json at = coordinates(mesh, sizes.middle);
    report.json["worst_edge"] = {{"part_of_size", sizes.relative_length}, {"at", at}};
    if (sizes.relative_length < kShort || sizes.relative_length > kLong)
        report.say("  the worst at " + text_of(at) + " has " + short_number(sizes.relative_length) +
                   " times that" + cause_text(sizes));
}

void describe_distance(const Mesh& mesh, const HausdorffDistance& found, Report& report)
{
    const nlohmann::ordered_json at = coordinates(mesh, found.place);
    report.json["hausdorff"] = {{"distance", found.value},
                                {"bound", found.bound},
                                {"at", at},
                                {"of", found.on_first ? "input" : "output"}};
    report.say("  distance from the input: " + short_number(found.value) + " at " + text_of(at) + " of the " +
               (found.on_first ? "input" : "output") + (mesh.dimension == 2 ? " (boundaries)" : ""));
}

/// Count the folds of a surface and warn of the first.
void describe_folds(const Mesh& mesh, const std::vector<Index>& folded, const std::string& output,
                    Report& report)
{
    if (mesh.dimension == 2)
        return;
    report.json["folds"] = folded.size();
    if (folded.empty())
        return;
    warn("morph-remesh", output + ": " + std::to_string(folded.size()) +
                             " triangles are folded over, such as element " +
                             std::to_string(file_element(mesh, folded.front())) + " at " +
                             text_of(coordinates(mesh, centroid(mesh, folded.front()))));
}

void describe_isolated(Index left_out, Report& report)
{
    if (left_out > 0)
        report.say(
            "  " + std::to_string(left_out) +
            (left_out == 1 ? " vertex of no element was left out" : " vertices of no element were left out"));
}

void describe_cut_out(const CutOut& cut_out, Report& report)
{
    report.json["cut_out"] = {{"inverted", cut_out.inverted},
                              {"elements", cut_out.elements},
                              {"vertices_left_out", cut_out.vertices_left_out}};
    report.say(std::to_string(cut_out.inverted) + " inverted elements were cut out, with " +
               std::to_string(cut_out.elements - cut_out.inverted) + " around them, and remeshed");
}

} // namespace

void describe_remeshing(const Mesh& old, const RemeshedMesh& remeshed, const RemeshCheck& check,
                        const std::string& output, Report& report)
{
    const Mesh& mesh = remeshed.mesh;
    const QualityReport &before = check.before, &after = check.after;
    if (remeshed.cut_out)
        describe_cut_out(*remeshed.cut_out, report);
    report.json["quality"] = {{"before", quality_json(before)}, {"after", quality_json(after)}};
    report.json["triangle_quality"] = {{"before", triangle_json(old, check.triangles_before)},
                                       {"after", triangle_json(mesh, check.triangles_after)}};
    report.say(output + ": " + std::to_string(after.vertices) + " vertices, " +
               std::to_string(after.triangles) + " triangles, " + std::to_string(after.quads) +
               " quads (from " + std::to_string(before.vertices) + ", " + std::to_string(before.triangles) +
               ", " + std::to_string(before.quads) + ")");
    describe_isolated(check.isolated_left_out, report);
    if (!check.sizes) {
        report.say(
            "  there is no triangle to remake, and quads stay; morph-convert --triangulate splits them");
    } else {
        describe_count(mesh, remeshed.targets.vertices, report);
        describe_sizes(mesh, *check.sizes, report);
        report.say("  worst triangle: quality " + worst_triangle(report.json["triangle_quality"]["after"]) +
                   ", was " + worst_triangle(report.json["triangle_quality"]["before"]));
    }
    describe_distance(mesh, check.distance, report);
    describe_folds(mesh, check.folded, output, report);
    for (const std::string& text : quality_summary(after))
        report.say("  " + text);
}

} // namespace morph::tools
