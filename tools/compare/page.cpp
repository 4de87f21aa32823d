#include "tools/compare/page.h"

#include "libmorph/core/names.h"
#include "tools/common/report.h"
#include "tools/picture/picture.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace morph::tools {

namespace {

constexpr int kPictureWidth = 760; // pixels
constexpr const char* kStyle =
    "body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:1640px;padding:0 "
    "1rem;color:#1d2733}\n"
    "h1{font-size:1.5rem}h2{font-size:1.2rem;margin-top:2.5rem}h3{font-size:1rem;margin:1.5rem 0 .3rem}\n"
    "table{border-collapse:collapse;font-variant-numeric:tabular-nums}\n"
    "th,td{padding:.3rem .7rem;text-align:right;border-bottom:1px solid #d8dee6}\n"
    "th:first-child,td:first-child{text-align:left}tr.bad td{background:#fdecea}\n"
    "div.pair{display:flex;flex-wrap:wrap;gap:12px;align-items:flex-start}img{border:1px solid "
    "#d8dee6;max-width:100%}\n"
    "p.note{color:#5a6675}dt{font-weight:600}dd{margin:0 0 .4rem 1.2rem}\n";

std::string escaped(const std::string& text)
{
    std::string safe;
    for (const char c : text) {
        const std::string_view special = c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : "";
        safe += special.empty() ? std::string(1, c) : std::string(special);
    }
    return safe;
}

std::string base64(const std::string& bytes)
{
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::string image(const Mesh& mesh, const picture::PictureOptions& options, const std::string& caption)
{
    const std::string png = draw_picture({{&mesh, caption}}, options, picture::ImageKind::png);
    return "<img alt=\"" + escaped(caption) + "\" src=\"data:image/png;base64," + base64(png) + "\">\n";
}

/// A window around the worst element that shows some of its neighbours.
picture::Box near_worst(const Mesh& mesh, Index element)
{
    constexpr double kNeighbours = 4; // widths of the element on each side
    Eigen::AlignedBox2d box;
    for (const Index v : element_corners(mesh, element))
        if (v >= 0)
            box.extend(Eigen::Vector2d(points(mesh).row(v).head<2>().transpose()));
    const double reach = (0.5 + kNeighbours) * box.sizes().maxCoeff();
    const Eigen::Vector2d centre = box.center();
    return {centre.x() - reach, centre.y() - reach / 1.6, centre.x() + reach, centre.y() + reach / 1.6};
}

std::string pictures(Mesh& mesh, const ComparisonRow& row)
{
    points(mesh) = row.moved.positions;
    picture::PictureOptions options;
    options.width = kPictureWidth;
    options.field = "scaled_jacobian";
    std::string html = "<h3>" + escaped(row.method) + "</h3>\n<div class=\"pair\">\n";
    html += image(mesh, options, row.method);
    options.zoom = near_worst(mesh, row.worst_element);
    html += image(mesh, options,
                  row.method + ": worst element, " +
                      std::to_string(mesh.numbering.element[static_cast<std::size_t>(row.worst_element)]));
    return html + "</div>\n";
}

std::string table(const ComparedMove& move)
{
    std::string html = "<table>\n<tr><th>method</th>";
    for (const ComparisonColumn& column : comparison_columns())
        html += "<th title=\"" + escaped(column.meaning) + "\">" + escaped(column.title) + "</th>";
    html += "</tr>\n";
    for (const ComparisonRow& row : move.rows) {
        html += std::string(row.quality.inverted > 0 ? "<tr class=\"bad\">" : "<tr>") + "<td>" +
                escaped(row.method) + "</td>";
        for (const ComparisonColumn& column : comparison_columns())
            html += "<td>" + escaped(column.text(row)) + "</td>";
        html += "</tr>\n";
    }
    return html + "</table>\n";
}

std::string legend()
{
    std::string html = "<h2>Columns</h2>\n<dl>\n";
    for (const ComparisonColumn& column : comparison_columns())
        html += "<dt>" + escaped(column.title) + "</dt><dd>" + escaped(column.meaning) + "</dd>\n";
    return html + "</dl>\n";
}

} // namespace

std::string comparison_page(const PageSubject& subject, Mesh& mesh, const std::vector<ComparedMove>& moves)
{
    const Points before = points(mesh);
    std::string html =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<title>" +
        escaped(subject.case_file) + "</title>\n<style>\n" + kStyle + "</style></head><body>\n<h1>" +
        escaped(subject.case_file) + "</h1>\n<p class=\"note\">" + escaped(subject.mesh) + ", " +
        std::to_string(vertex_count(mesh)) + " vertices, " + std::to_string(element_count(mesh)) +
        " elements. The same move of the boundary by each method; rows with inverted elements are "
        "red.</p>\n";
    for (const ComparedMove& move : moves) {
        html += "<h2>" + short_number(move.factor) + " times the move of the case</h2>\n" + table(move);
        for (const ComparisonRow& row : move.rows)
            html += pictures(mesh, row);
        points(mesh) = before;
    }
    return html + legend() + "</body></html>\n";
}

} // namespace morph::tools
