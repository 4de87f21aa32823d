#include "tools/convert/file_info.h"

#include "libmorph/core/names.h"
#include "tools/common/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace morph::tools {

namespace {

using Json = nlohmann::ordered_json;

Json row(const Eigen::RowVector3d& point)
{
    return {point(0), point(1), point(2)};
}

Json bounding_box(const Points& points)
{
    if (points.rows() == 0)
        return nullptr;
    return {{"min", row(points.colwise().minCoeff())}, {"max", row(points.colwise().maxCoeff())}};
}

/// Smallest and largest of the numbers that are finite; null when none is.
Json range(const Eigen::Ref<const Eigen::VectorXd>& values)
{
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    for (const double value : values)
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (low > high)
        return nullptr;
    return {low, high};
}

Json field_info(const Field& field)
{
    Json info{{"name", field.name},
              {"location", field.location == FieldLocation::vertex ? "vertex" : "element"},
              {"components", field.values.cols()},
              {"ranges", Json::array()}};
    for (Eigen::Index c = 0; c < field.values.cols(); ++c)
        info["ranges"].push_back(range(field.values.col(c)));
    return info;
}

std::string range_text(const Json& range)
{
    if (range.is_null())
        return "no finite value";
    return short_number(range[0]) + " to " + short_number(range[1]);
}

std::string field_line(const Json& field)
{
    std::string line =
        "  " + std::string(field["location"]) + " field '" + std::string(field["name"]) + "': ";
    const Json& ranges = field["ranges"];
    for (std::size_t c = 0; c < ranges.size(); ++c)
        line += (c == 0 ? "" : "; ") + range_text(ranges[c]);
    return line;
}

std::string counted(const Json& count, const std::string& what)
{
    return std::to_string(count.get<std::size_t>()) + " " + what;
}

std::string corner_text(const Json& corner, bool planar)
{
    std::string text = "(" + short_number(corner[0]) + ", " + short_number(corner[1]);
    return text + (planar ? ")" : ", " + short_number(corner[2]) + ")");
}

std::string capabilities(const Format& format)
{
    const FormatCapabilities& holds = format.holds;
    std::string text = holds.surface ? "planar and surface" : "planar";
    if (!holds.elements)
        text += " points";
    else
        text += holds.quads ? " triangles and quads" : " triangles";
    for (const auto& [held, name] : {std::pair{holds.markers, ", markers"},
                                     {holds.groups, ", groups"},
                                     {holds.vertex_fields, ", nodal fields"},
                                     {holds.element_fields, ", element fields"},
                                     {holds.volume, ", surface of volumes"}})
        text += held ? name : "";
    if (!format.write)
        return text + "; read only";
    text += holds.ascii && holds.binary ? "; text or binary" : holds.binary ? "; binary" : "; text";
    return text + (holds.compressed ? ", compressed" : "");
}

std::string padded(std::string text, std::size_t width)
{
    text.resize(std::max(width, text.size() + 1), ' ');
    return text;
}

} // namespace

Json file_info(const std::string& path, const Format& format, const MeshData& mesh, const ReadNotes& notes)
{
    const auto triangles = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                         [](const Element& element) { return corner_count(element) == 3; });
    Json info{{"file", path},
              {"format", format.name},
              {"version", notes.version},
              {"dimension", mesh.dimension},
              {"vertices", mesh.points.rows()},
              {"triangles", triangles},
              {"quads", static_cast<std::ptrdiff_t>(mesh.elements.size()) - triangles},
              {"bounding_box", bounding_box(mesh.points)},
              {"markers", Json::array()},
              {"groups", Json::array()},
              {"fields", Json::array()},
              {"carried", Json::array()}};
    for (const Marker& marker : mesh.markers)
        info["markers"].push_back({{"name", marker.name}, {"edges", marker.edges.size()}});
    for (const ElementGroup& group : mesh.groups)
        info["groups"].push_back({{"name", group.name}, {"elements", group.elements.size()}});
    for (const Field& field : mesh.fields)
        info["fields"].push_back(field_info(field));
    for (const OpaqueSection& carried : mesh.sections)
        info["carried"].push_back(carried.what);
    return info;
}

std::vector<std::string> info_lines(const Json& info)
{
    const bool planar = info["dimension"] == 2;
    const std::string version = info["version"];
    std::vector<std::string> lines;
    lines.push_back(std::string(info["file"]) + ": " + std::string(info["format"]) +
                    (version.empty() ? "" : " " + version) + ", " + (planar ? "planar" : "surface in space"));
    lines.push_back("  " + counted(info["vertices"], "vertices") + ", " +
                    counted(info["triangles"], "triangles") + ", " + counted(info["quads"], "quads"));
    if (const Json& box = info["bounding_box"]; !box.is_null())
        lines.push_back("  from " + corner_text(box["min"], planar) + " to " +
                        corner_text(box["max"], planar));
    for (const Json& marker : info["markers"])
        lines.push_back("  marker '" + std::string(marker["name"]) +
                        "': " + counted(marker["edges"], "edges"));
    for (const Json& group : info["groups"])
        lines.push_back("  group '" + std::string(group["name"]) +
                        "': " + counted(group["elements"], "elements"));
    for (const Json& field : info["fields"])
        lines.push_back(field_line(field));
    for (const Json& carried : info["carried"])
        lines.push_back("  also " + std::string(carried));
    return lines;
}

std::vector<std::string> format_list()
{
    std::vector<std::string> lines;
    for (const Format* format : all_formats()) {
        std::string extensions;
        for (const std::string_view extension : format->extensions)
            extensions += (extensions.empty() ? "" : " ") + std::string(extension);
        lines.push_back(padded(std::string(format->name), 12) + padded(extensions, 14) +
                        std::string(format->description));
        lines.push_back(padded("", 12) + capabilities(*format));
    }
    return lines;
}

Json format_table()
{
    Json table = Json::array();
    for (const Format* format : all_formats()) {
        const FormatCapabilities& holds = format->holds;
        table.push_back({{"name", format->name},
                         {"extensions", format->extensions},
                         {"description", format->description},
                         {"surface", holds.surface},
                         {"elements", holds.elements},
                         {"quads", holds.quads},
                         {"markers", holds.markers},
                         {"groups", holds.groups},
                         {"vertex_fields", holds.vertex_fields},
                         {"element_fields", holds.element_fields},
                         {"volume", holds.volume},
                         {"ascii", holds.ascii},
                         {"binary", holds.binary},
                         {"compressed", holds.compressed},
                         {"writes", format->write != nullptr}});
    }
    return table;
}

} // namespace morph::tools
