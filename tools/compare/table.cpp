#include "tools/compare/table.h"

#include "libmorph/core/names.h"
#include "tools/common/quality_json.h"
#include "tools/common/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace morph::tools {

namespace {

std::string padded(const std::string& text, std::size_t width, bool left)
{
    const std::string blanks(width - std::min(width, text.size()), ' ');
    return left ? text + blanks : blanks + text;
}

} // namespace

const std::vector<ComparisonColumn>& comparison_columns()
{
    using Row = ComparisonRow;
    static const std::vector<ComparisonColumn> columns{
        {"boundary", "largest distance of a boundary node to where its curve wants it, over the curve's size",
         [](const Row& r) { return short_number(r.boundary_error); }},
        {"inverted", "elements with a corner Jacobian that is not positive",
         [](const Row& r) { return std::to_string(r.quality.inverted); }},
        {"min SJ", "smallest scaled Jacobian",
         [](const Row& r) { return short_number(r.quality.min_scaled_jacobian); }},
        {"mean SJ", "mean scaled Jacobian",
         [](const Row& r) { return short_number(r.quality.mean_scaled_jacobian); }},
        {"min angle", "smallest angle, degrees",
         [](const Row& r) { return short_number(r.quality.min_angle); }},
        {"min f_ss", "smallest size-skew against the undeformed mesh",
         [](const Row& r) { return short_number(r.quality.size_skew->min); }},
        {"mean f_ss", "mean size-skew", [](const Row& r) { return short_number(r.quality.size_skew->mean); }},
        {"energy", "Dirichlet energy of the displacement: its unsmoothness",
         [](const Row& r) { return short_number(r.energy); }},
        {"variables", "numbers an optimiser would set",
         [](const Row& r) { return std::to_string(r.moved.control_variables); }},
        {"weights s", "seconds to prepare, once for a mesh",
         [](const Row& r) { return short_number(r.moved.weights_seconds); }},
        {"move s", "seconds for every move", [](const Row& r) { return short_number(r.moved.move_seconds); }},
        {"MiB", "memory kept between moves",
         [](const Row& r) { return short_number(static_cast<double>(r.moved.weights_bytes) / (1 << 20)); }},
    };
    return columns;
}

nlohmann::ordered_json comparison_json(const ComparedMove& move)
{
    nlohmann::ordered_json json{{"move", move.factor}, {"methods", nlohmann::ordered_json::array()}};
    for (const ComparisonRow& row : move.rows)
        json["methods"].push_back(
            {{"method", row.method},
             {"boundary_error", row.boundary_error},
             {"rms_boundary_error", row.rms_boundary_error},
             {"quality", quality_json(row.quality)},
             {"energy", row.energy},
             {"control_variables", row.moved.control_variables},
             {"memory_bytes", row.moved.weights_bytes},
             {"seconds", {{"weights", row.moved.weights_seconds}, {"move", row.moved.move_seconds}}}});
    return json;
}

std::vector<std::string> comparison_lines(const ComparedMove& move)
{
    std::size_t name_width = 6;
    for (const ComparisonRow& row : move.rows)
        name_width = std::max(name_width, row.method.size());
    constexpr std::size_t kWidth = 10;
    std::vector<std::string> lines{padded("method", name_width, true)};
    for (const ComparisonColumn& column : comparison_columns())
        lines[0] += padded(column.title, kWidth, false);
    for (const ComparisonRow& row : move.rows) {
        lines.push_back(padded(row.method, name_width, true));
        for (const ComparisonColumn& column : comparison_columns())
            lines.back() += padded(column.text(row), kWidth, false);
    }
    return lines;
}

} // namespace morph::tools
