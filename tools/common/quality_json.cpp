#include "tools/common/quality_json.h"

#include "libmorph/core/names.h"
#include "tools/common/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace morph::tools {

namespace {

std::string inverted_line(const QualityReport& report)
{
    if (report.inverted == 0)
        return "no inverted elements";
    constexpr std::size_t kNamed = 8;
    const auto& listed = report.inverted_elements;
    std::string ids;
    for (std::size_t i = 0; i < std::min(kNamed, listed.size()); ++i)
        ids += (i > 0 ? ", " : "") + std::to_string(listed[i]);
    if (static_cast<std::size_t>(report.inverted) > kNamed)
        ids += ", ...";
    return std::to_string(report.inverted) + " inverted elements, " + std::to_string(report.negative_area) +
           " of negative area (" + ids + ")";
}

} // namespace

nlohmann::ordered_json quality_json(const QualityReport& report)
{
    nlohmann::ordered_json json;
    json["vertices"] = report.vertices;
    json["triangles"] = report.triangles;
    json["quads"] = report.quads;
    json["inverted"] = report.inverted;
    json["negative_area"] = report.negative_area;
    json["inverted_elements"] = report.inverted_elements;
    json["min_scaled_jacobian"] = report.min_scaled_jacobian;
    json["mean_scaled_jacobian"] = report.mean_scaled_jacobian;
    json["min_angle"] = report.min_angle;
    json["max_angle"] = report.max_angle;
    json["max_aspect_ratio"] = report.max_aspect_ratio;
    if (report.size_skew) {
        json["min_size_skew"] = report.size_skew->min;
        json["mean_size_skew"] = report.size_skew->mean;
    }
    return json;
}

std::vector<std::string> quality_summary(const QualityReport& report)
{
    std::vector<std::string> lines;
    lines.push_back(std::to_string(report.vertices) + " vertices, " + std::to_string(report.triangles) +
                    " triangles, " + std::to_string(report.quads) + " quads");
    lines.push_back(inverted_line(report));
    lines.push_back("scaled Jacobian: min " + short_number(report.min_scaled_jacobian) + ", mean " +
                    short_number(report.mean_scaled_jacobian));
    lines.push_back("angles: " + short_number(report.min_angle) + " to " + short_number(report.max_angle) +
                    " degrees; largest aspect ratio " + short_number(report.max_aspect_ratio));
    if (report.size_skew)
        lines.push_back("size-skew against the reference: min " + short_number(report.size_skew->min) +
                        ", mean " + short_number(report.size_skew->mean));
    return lines;
}

} // namespace morph::tools
