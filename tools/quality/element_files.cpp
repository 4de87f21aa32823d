#include "tools/quality/element_files.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace morph::tools {

namespace {

/// Add a comma and the shortest text that reads back as the same double, nothing for NaN.
void add_cell(std::string& line, double value)
{
    line += ',';
    if (std::isnan(value))
        return;
    std::array<char, 32> text{};
    line.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

void set_line(std::string& line, Index id, const MeshData& data, const std::vector<Field>& metrics)
{
    const Element& element = data.elements[static_cast<std::size_t>(id)];
    const int corners = corner_count(element);
    Eigen::RowVector3d centroid = Eigen::RowVector3d::Zero();
    for (int k = 0; k < corners; ++k)
        centroid += data.points.row(element[static_cast<std::size_t>(k)]) / corners;
    line = std::to_string(id) + (corners == 3 ? ",triangle" : ",quad");
    for (const double coordinate : centroid)
        add_cell(line, coordinate);
    for (const Field& metric : metrics)
        add_cell(line, metric.values(id, 0));
    line += '\n';
}

} // namespace

void write_elements(OutputFile& file, const MeshData& data, const std::vector<Field>& metrics,
                    bool inverted_only)
{
    const Field* inverted = find_field(metrics, "inverted", FieldLocation::element);
    std::string line = "id,type,x,y,z";
    for (const Field& metric : metrics)
        line += ',' + metric.name;
    file.append(line + '\n');
    for (Index id = 0; id < static_cast<Index>(data.elements.size()); ++id) {
        if (inverted_only && inverted->values(id, 0) == 0)
            continue;
        set_line(line, id, data, metrics);
        file.append(line);
    }
}

void add_metric_fields(MeshData& data, std::vector<Field> metrics)
{
    for (Field& metric : metrics)
        set_field(data.fields, std::move(metric));
}

} // namespace morph::tools
