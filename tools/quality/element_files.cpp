#include "tools/quality/element_files.h"

#include <array>
#include <charconv>
#include <utility>

namespace morph::tools {

namespace {

const Metric kInvertedMetric{"inverted", [](const ElementQuality& q) { return q.inverted ? 1.0 : 0.0; }};

template <std::size_t corner>
double corner_jacobian(const ElementQuality& quality)
{
    return quality.jacobian[corner];
}

/// Add the shortest text that reads back as the same double.
void add_exact(std::string& line, double value)
{
    std::array<char, 32> text{};
    line.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr);
}

void write_header(OutputFile& file, const std::vector<Metric>& metrics)
{
    std::string header = "id,type,x,y,z";
    for (const Metric& metric : metrics)
        header += "," + metric.name;
    file.append(header + '\n');
}

/// Writes one element a line; the line is kept for its memory.
class ElementLines {
public:
    ElementLines(OutputFile& file, const MeshData& data, const std::vector<Metric>& metrics)
        : file_(file), data_(data), metrics_(metrics)
    {
        write_header(file, metrics);
    }

    void write(std::size_t id, const ElementQuality& quality)
    {
        const Element& element = data_.elements[id];
        const int corners = corner_count(element);
        Eigen::RowVector3d centroid = Eigen::RowVector3d::Zero();
        for (int k = 0; k < corners; ++k)
            centroid += data_.points.row(element[static_cast<std::size_t>(k)]) / corners;
        line_ = std::to_string(id) + (corners == 3 ? ",triangle" : ",quad");
        for (const double coordinate : centroid)
            add_exact(line_ += ',', coordinate);
        for (const Metric& metric : metrics_)
            add_exact(line_ += ',', metric.value(quality));
        file_.append(line_ += '\n');
    }

private:
    OutputFile& file_;
    const MeshData& data_;
    const std::vector<Metric>& metrics_;
    std::string line_;
};

void set_field(MeshData& data, const std::string& name, Matrix values)
{
    std::erase_if(data.fields, [&](const Field& field) {
        return field.name == name && field.location == FieldLocation::element;
    });
    data.fields.push_back({name, FieldLocation::element, std::move(values)});
}

} // namespace

std::vector<Metric> element_metrics(bool with_reference)
{
    std::vector<Metric> all{
        {"area", [](const ElementQuality& q) { return q.area; }},
        {"min_corner_jacobian", [](const ElementQuality& q) { return q.min_jacobian; }},
        {"scaled_jacobian", [](const ElementQuality& q) { return q.scaled_jacobian; }},
        {"min_angle", [](const ElementQuality& q) { return q.min_angle; }},
        {"max_angle", [](const ElementQuality& q) { return q.max_angle; }},
        {"aspect_ratio", [](const ElementQuality& q) { return q.aspect_ratio; }},
        {"corner_jacobian_1", corner_jacobian<0>},
        {"corner_jacobian_2", corner_jacobian<1>},
        {"corner_jacobian_3", corner_jacobian<2>},
        {"corner_jacobian_4", corner_jacobian<3>},
    };
    if (with_reference)
        all.push_back({"size_skew", [](const ElementQuality& q) { return q.size_skew; }});
    return all;
}

std::vector<ElementQuality> in_file_order(const Mesh& mesh, const std::vector<ElementQuality>& quality)
{
    std::vector<ElementQuality> ordered(quality.size());
    for (std::size_t f = 0; f < quality.size(); ++f) {
        ElementQuality& q = ordered[static_cast<std::size_t>(mesh.numbering.element[f])];
        q = quality[f];
        if (mesh.numbering.turned[f])
            std::swap(q.jacobian[1], q.jacobian[3]);
    }
    return ordered;
}

void write_inverted(OutputFile& file, const MeshData& data, const std::vector<ElementQuality>& quality,
                    const std::vector<Metric>& metrics)
{
    ElementLines lines(file, data, metrics);
    for (std::size_t id = 0; id < quality.size(); ++id)
        if (quality[id].inverted)
            lines.write(id, quality[id]);
}

void write_all_elements(OutputFile& file, const MeshData& data, const std::vector<ElementQuality>& quality,
                        const std::vector<Metric>& metrics)
{
    std::vector<Metric> columns = metrics;
    columns.push_back(kInvertedMetric);
    ElementLines lines(file, data, columns);
    for (std::size_t id = 0; id < quality.size(); ++id)
        lines.write(id, quality[id]);
}

MeshData with_metric_fields(MeshData data, const std::vector<ElementQuality>& quality,
                            const std::vector<Metric>& metrics)
{
    std::vector<Metric> columns = metrics;
    columns.insert(columns.begin(), kInvertedMetric);
    for (const Metric& metric : columns) {
        Matrix values(static_cast<Index>(quality.size()), 1);
        for (std::size_t id = 0; id < quality.size(); ++id)
            values(static_cast<Index>(id), 0) = metric.value(quality[id]);
        set_field(data, metric.name, std::move(values));
    }
    return data;
}

} // namespace morph::tools
