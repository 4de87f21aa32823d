#include "tools/remesh/remesh_report.h"

#include "libmorph/core/names.h"
#include "libmorph/geometry/hausdorff.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/folds.h"
#include "libmorph/remesh/wanted_size.h"
#include "tools/common/quality_json.h"
#include "tools/common/run.h"

#include <algorithm>
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
    if (triangles.is_null())
        return "none";
    return short_number(triangles["min"]) + " (element " +
           std::to_string(triangles["worst_element"].get<Index>()) + " at " + text_of(triangles["worst_at"]) +
           ")";
}

/// The edge whose length is farthest from the one wanted, by its factor.
struct WorstEdge {
    double part = 1; ///< of the length wanted
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    bool held = false; ///< both ends are on the boundary or on kept elements
};

std::vector<bool> held_vertices(const Mesh& mesh)
{
    std::vector<bool> held(static_cast<std::size_t>(vertex_count(mesh)), false);
    const auto hold = [&](Index v) { held[static_cast<std::size_t>(v)] = true; };
    for (const auto vertex : mesh.kernel.vertices())
        if (vertex.is_boundary())
            hold(vertex.idx());
    for (const Marker& marker : mesh.markers)
        for (const Index v : marker_vertices(marker))
            hold(v);
    for (const Element& e : element_table(mesh))
        if (e[3] >= 0)
            for (const Index v : e)
                hold(v);
    return held;
}

WorstEdge worst_edge(const Mesh& mesh, const Eigen::VectorXd& sizes)
{
    const auto place = points(mesh);
    const std::vector<bool> held = held_vertices(mesh);
    const auto is_held = [&](Index v) { return held[static_cast<std::size_t>(v)]; };
    WorstEdge worst;
    for (const auto edge : mesh.kernel.edges()) {
        const Index a = edge.v0().idx(), b = edge.v1().idx();
        const double part = 2 * (place.row(a) - place.row(b)).norm() / (sizes[a] + sizes[b]);
        if (std::max(part, 1 / part) > std::max(worst.part, 1 / worst.part))
            worst = {part, (place.row(a) + place.row(b)) / 2, is_held(a) && is_held(b)};
    }
    return worst;
}

/// What was wished for and could not be had.
void describe_sizes(const Mesh& mesh, const Eigen::VectorXd& sizes, Report& report)
{
    constexpr double kShort = 0.7, kLong = 1.4;
    const double conformity = size_conformity(mesh, sizes);
    const WorstEdge worst = worst_edge(mesh, sizes);
    report.json["size_conformity"] = conformity;
    report.json["worst_edge"] = {{"part_of_size", worst.part}, {"at", coordinates(mesh, worst.middle)}};
    report.say("  " + short_number(100 * conformity) +
               " % of the edges have 0.7 to 1.4 times the length wanted");
    if (worst.part >= kShort && worst.part <= kLong)
        return;
    std::string reason;
    if (worst.held && worst.part < kShort)
        reason = ": what is held there, corners or kept elements, is nearer than that";
    report.say("  the worst at " + text_of(coordinates(mesh, worst.middle)) + " has " +
               short_number(worst.part) + " times that" + reason);
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

void describe_remeshing(const Mesh& old, const Mesh& mesh, const Eigen::VectorXd& sizes,
                        const std::string& output, Report& report)
{
    const QualityReport before = quality_report(old), after = quality_report(mesh);
    report.json["quality"] = {{"before", quality_json(before)}, {"after", quality_json(after)}};
    report.json["triangle_quality"] = {{"before", triangle_json(old)}, {"after", triangle_json(mesh)}};
    report.say(output + ": " + std::to_string(after.vertices) + " vertices, " +
               std::to_string(after.triangles) + " triangles, " + std::to_string(after.quads) +
               " quads (from " + std::to_string(before.vertices) + ", " + std::to_string(before.triangles) +
               ", " + std::to_string(before.quads) + ")");
    describe_sizes(mesh, sizes, report);
    report.say("  worst triangle: quality " + worst_triangle(report.json["triangle_quality"]["after"]) +
               ", was " + worst_triangle(report.json["triangle_quality"]["before"]));
    describe_distance(old, mesh, report);
    describe_folds(old, mesh, output, report);
    for (const std::string& text : quality_summary(after))
        report.say("  " + text);
}

} // namespace morph::tools
