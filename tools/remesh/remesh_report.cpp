#include "tools/remesh/remesh_report.h"

#include "libmorph/core/names.h"
#include "libmorph/geometry/hausdorff.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/folds.h"
#include "libmorph/remesh/target_size.h"
#include "tools/common/quality_json.h"
#include "tools/common/run.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numeric>
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
nlohmann::ordered_json triangle_json(const Mesh& mesh)
{
    const std::vector<double> quality = triangle_qualities(mesh);
    std::vector<double> of_triangles;
    Index worst = -1;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const auto place = static_cast<std::size_t>(f);
        if (element_corners(mesh, f)[3] >= 0)
            continue;
        of_triangles.push_back(quality[place]);
        if (worst < 0 || quality[place] < quality[static_cast<std::size_t>(worst)])
            worst = f;
    }
    if (worst < 0)
        return nullptr;
    const double sum = std::accumulate(of_triangles.begin(), of_triangles.end(), 0.0);
    return {{"min", quality[static_cast<std::size_t>(worst)]},
            {"mean", sum / static_cast<double>(of_triangles.size())},
            {"worst_element", mesh.numbering.element[static_cast<std::size_t>(worst)]},
            {"worst_at", coordinates(mesh, centroid(mesh, worst))}};
}

std::string worst_triangle(const nlohmann::ordered_json& triangles)
{
    if (triangles.is_null()) // only inverted quads, which were cut out
        return "none";
    return short_number(triangles["min"]) + " (element " +
           std::to_string(triangles["worst_element"].get<Index>()) + " at " + text_of(triangles["worst_at"]) +
           ")";
}

bool is_held(const Mesh& mesh, Index vertex)
{
    const VertexHandle v(vertex);
    if (mesh.kernel.is_boundary(v))
        return true;
    for (auto face = mesh.kernel.cvf_begin(v); face.is_valid(); ++face)
        if (element_corners(mesh, face->idx())[3] >= 0)
            return true;
    return false;
}

/// Why an edge does not have the target length, as far as that is known.
std::string reason_of(const Mesh& mesh, const SizeConformity& found, const RemeshWishes& wishes)
{
    constexpr double kShort = 0.7;
    const auto [a, b] = found.worst;
    const double part = (wishes.possible[a] + wishes.possible[b]) / (wishes.sizes[a] + wishes.sizes[b]);
    if (found.relative_length > kShort)
        return "";
    if (part < kShort)
        return ": a boundary that is curved there, or a kept element, asks for " + short_number(part) +
               " of it";
    return is_held(mesh, a) && is_held(mesh, b) ? ": what is held there is nearer than that" : "";
}

Index isolated_vertices(const Mesh& mesh)
{
    Index count = 0;
    for (const auto vertex : mesh.kernel.vertices())
        count += mesh.kernel.is_isolated(vertex) ? 1 : 0;
    return count;
}

void describe_count(const Mesh& mesh, Index wanted, Report& report)
{
    constexpr double kNear = 0.02;
    const auto count = static_cast<double>(vertex_count(mesh));
    if (wanted == 0 || std::abs(count / wanted - 1) <= kNear)
        return;
    report.say("  " + std::to_string(wanted) + " vertices were asked for: " +
               (count > wanted ? "boundaries, corners and kept elements ask for more"
                               : "sizes cannot be lowered that evenly"));
}

/// What was wished for, and what of it could not be had.
void describe_sizes(const Mesh& mesh, const RemeshWishes& wishes, Report& report)
{
    constexpr double kShort = 0.7, kLong = 1.4;
    const SizeConformity found = edge_conformity(mesh, wishes.sizes);
    const double of_possible = size_conformity(mesh, wishes.possible);
    report.json["size_conformity"] = found.share;
    report.json["possible_size_conformity"] = of_possible;
    report.say(
        "  " + short_number(100 * found.share) + " % of the edges have 0.7 to 1.4 times the target length" +
        (of_possible > found.share
             ? ", " + short_number(100 * of_possible) + " % of them what boundaries and kept elements allow"
             : ""));
    if (found.worst[0] < 0) // all have exactly the target length
        return;
    const auto place = points(mesh);
    const nlohmann::ordered_json at =
        coordinates(mesh, (place.row(found.worst[0]) + place.row(found.worst[1])) / 2);
    report.json["worst_edge"] = {{"part_of_size", found.relative_length}, {"at", at}};
    if (found.relative_length < kShort || found.relative_length > kLong)
        report.say("  the worst at " + text_of(at) + " has " + short_number(found.relative_length) +
                   " times that" + reason_of(mesh, found, wishes));
}

void describe_distance(const Mesh& old, const Mesh& mesh, Report& report)
{
    const HausdorffDistance found = hausdorff_distance(old, mesh);
    const nlohmann::ordered_json at = coordinates(mesh, found.place);
    report.json["hausdorff"] = {{"distance", found.value},
                                {"bound", found.bound},
                                {"at", at},
                                {"of", found.on_first ? "input" : "output"}};
    report.say("  distance from the input: " + short_number(found.value) + " at " + text_of(at) + " of the " +
               (found.on_first ? "input" : "output") + (mesh.dimension == 2 ? " (boundaries)" : ""));
}

/// Count the folds of a surface and warn of the first.
void describe_folds(const Mesh& old, const Mesh& mesh, const std::string& output, Report& report)
{
    if (mesh.dimension == 2)
        return;
    const std::vector<Index> folded = folded_triangles(old, mesh);
    report.json["folds"] = folded.size();
    if (folded.empty())
        return;
    warn("morph-remesh",
         output + ": " + std::to_string(folded.size()) + " triangles are folded over, such as element " +
             std::to_string(mesh.numbering.element[static_cast<std::size_t>(folded.front())]) + " at " +
             text_of(coordinates(mesh, centroid(mesh, folded.front()))));
}

} // namespace

void describe_remeshing(const Mesh& old, const Mesh& mesh, const RemeshWishes& wishes,
                        const std::string& output, Report& report)
{
    const QualityReport before = quality_report(old), after = quality_report(mesh);
    report.json["quality"] = {{"before", quality_json(before)}, {"after", quality_json(after)}};
    report.json["triangle_quality"] = {{"before", triangle_json(old)}, {"after", triangle_json(mesh)}};
    report.say(output + ": " + std::to_string(after.vertices) + " vertices, " +
               std::to_string(after.triangles) + " triangles, " + std::to_string(after.quads) +
               " quads (from " + std::to_string(before.vertices) + ", " + std::to_string(before.triangles) +
               ", " + std::to_string(before.quads) + ")");
    const Index isolated = isolated_vertices(old) - isolated_vertices(mesh);
    if (isolated > 0)
        report.say(
            "  " + std::to_string(isolated) +
            (isolated == 1 ? " vertex of no element was left out" : " vertices of no element were left out"));
    if (after.triangles == 0) {
        report.say(
            "  there is no triangle to remake, and quads stay; morph-convert --triangulate splits them");
    } else {
        describe_count(mesh, wishes.vertices, report);
        describe_sizes(mesh, wishes, report);
        report.say("  worst triangle: quality " + worst_triangle(report.json["triangle_quality"]["after"]) +
                   ", was " + worst_triangle(report.json["triangle_quality"]["before"]));
    }
    describe_distance(old, mesh, report);
    describe_folds(old, mesh, output, report);
    for (const std::string& text : quality_summary(after))
        report.say("  " + text);
}

} // namespace morph::tools
