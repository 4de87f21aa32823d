#include "tools/quality/full_report.h"

#include "libmorph/core/names.h"
#include "tools/common/quality_json.h"
#include "tools/quality/text_table.h"

#include <nlohmann/json.hpp>

namespace morph::tools {

namespace {

using nlohmann::ordered_json;

ordered_json point_json(const Eigen::Vector3d& point)
{
    return {point.x(), point.y(), point.z()};
}

template <std::size_t bins>
ordered_json histogram_json(const std::array<Index, bins>& counts, double end)
{
    std::vector<double> edges;
    for (std::size_t i = 0; i <= bins; ++i)
        edges.push_back(end * static_cast<double>(i) / bins);
    return {{"edges", edges}, {"counts", counts}};
}

const char* type_name(const ElementPlace& place)
{
    return place.corners == 3 ? "triangle" : "quad";
}

ordered_json worst_json(const WorstElement& worst, const ElementPlace& place, bool with_reference)
{
    const ElementQuality& q = worst.quality;
    const std::vector<double> jacobians(q.jacobian.begin(), q.jacobian.begin() + place.corners);
    ordered_json json{{"id", worst.element},
                      {"type", type_name(place)},
                      {"centroid", point_json(place.centroid)},
                      {"nearest_marker", nullptr},
                      {"inverted", q.inverted},
                      {"area", q.area},
                      {"corner_jacobians", jacobians},
                      {"scaled_jacobian", q.scaled_jacobian},
                      {"min_angle", q.min_angle},
                      {"max_angle", q.max_angle},
                      {"aspect_ratio", q.aspect_ratio}};
    if (!place.nearest_marker.empty()) {
        json["nearest_marker"] = place.nearest_marker;
        json["marker_distance"] = place.marker_distance;
    }
    if (with_reference)
        json["size_skew"] = q.size_skew;
    return json;
}

ordered_json range_json(const ValueRange& range)
{
    return {{"min", range.min}, {"mean", range.mean}, {"max", range.max}};
}

ordered_json change_json(const WallPlace& change)
{
    return {{"max", change.value}, {"element", change.element}, {"at", point_json(change.middle)}};
}

ordered_json wall_json(const WallQuality& wall)
{
    ordered_json json{{"marker", wall.marker},
                      {"cells", wall.cells},
                      {"first_cell_height", range_json(wall.height)},
                      {"orthogonality", range_json(wall.angle)}};
    if (wall.change) {
        json["height_change"] = change_json(wall.change->height);
        json["orthogonality_change"] = change_json(wall.change->angle);
    }
    return json;
}

void say_histograms(const QualityReport& summary, Report& report)
{
    const std::vector<Index> jacobians(summary.scaled_jacobian_counts.begin(),
                                       summary.scaled_jacobian_counts.end());
    const std::vector<Index> angles(summary.min_angle_counts.begin(), summary.min_angle_counts.end());
    for (const std::string& line : bar_lines("elements by scaled Jacobian:", summary.inverted, jacobians, 1))
        report.say(line);
    for (const std::string& line : bar_lines("elements by smallest angle:", summary.inverted, angles, 90))
        report.say(line);
}

std::string place_text(const Eigen::Vector3d& point)
{
    const std::string plane = short_number(point.x()) + ", " + short_number(point.y());
    return "(" + plane + (point.z() != 0 ? ", " + short_number(point.z()) : "") + ")";
}

void say_worst(const FullQuality& quality, Report& report)
{
    std::vector<std::vector<std::string>> rows{
        {"worst element", "type", "scaled Jacobian", "angles", "centroid", "nearest marker"}};
    for (std::size_t i = 0; i < quality.worst_places.size(); ++i) {
        const WorstElement& worst = quality.summary.worst[i];
        const ElementPlace& place = quality.worst_places[i];
        const ElementQuality& q = worst.quality;
        const std::string marker =
            place.nearest_marker.empty()
                ? "none"
                : place.nearest_marker + ", " + short_number(place.marker_distance) + " away";
        rows.push_back({std::to_string(worst.element), type_name(place), short_number(q.scaled_jacobian),
                        short_number(q.min_angle) + " to " + short_number(q.max_angle),
                        place_text(place.centroid), marker});
    }
    for (const std::string& line : table_lines(rows))
        report.say(line);
}

std::string change_text(const WallPlace& change, double factor, const char* unit)
{
    return short_number(factor * change.value) + unit + " (element " + std::to_string(change.element) +
           " at " + place_text(change.middle) + ")";
}

void say_wall(const WallQuality& wall, Report& report)
{
    report.say("next to " + wall.marker + ": first cells " + short_number(wall.height.min) + " to " +
               short_number(wall.height.max) + " high, mean " + short_number(wall.height.mean) + "; " +
               short_number(wall.angle.min) + " to " + short_number(wall.angle.max) +
               " degrees off the normal, mean " + short_number(wall.angle.mean));
    if (wall.change)
        report.say("  changed at most by " + change_text(wall.change->height, 100, " %") + " and " +
                   change_text(wall.change->angle, 1, " degrees"));
}

} // namespace

void describe(const FullQuality& quality, Report& report)
{
    const QualityReport& summary = quality.summary;
    report.json = quality_json(summary);
    report.json["histograms"] = {{"scaled_jacobian", histogram_json(summary.scaled_jacobian_counts, 1)},
                                 {"min_angle", histogram_json(summary.min_angle_counts, 90)}};
    report.json["worst"] = ordered_json::array();
    for (std::size_t i = 0; i < summary.worst.size(); ++i)
        report.json["worst"].push_back(
            worst_json(summary.worst[i], quality.worst_places[i], summary.size_skew.has_value()));
    report.json["walls"] = ordered_json::array();
    for (const WallQuality& wall : quality.walls)
        report.json["walls"].push_back(wall_json(wall));
    for (const std::string& text : quality_summary(summary))
        report.say(text);
    say_histograms(summary, report);
    say_worst(quality, report);
    for (const WallQuality& wall : quality.walls)
        say_wall(wall, report);
}

} // namespace morph::tools
