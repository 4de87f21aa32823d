// morph-quality: what is wrong with this mesh.
//   morph-quality deformed.su2 --reference naca0012.su2 --list bad.csv
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tools/common/quality_json.h"
#include "tools/common/report.h"
#include "tools/common/run.h"

#include <array>
#include <charconv>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace morph::tools {
namespace {

constexpr const char* kTool = "morph-quality";

struct Options {
    std::string mesh;
    std::string reference;
    std::string list;
    std::string vtu;
    std::string from;
};

/// One metric as a column of the list and a field of the VTU file.
struct Metric {
    const char* name;
    std::function<double(const ElementQuality&)> value;
};

std::vector<Metric> metrics(bool with_reference)
{
    std::vector<Metric> all{
        {"area", [](const ElementQuality& q) { return q.area; }},
        {"min_corner_jacobian", [](const ElementQuality& q) { return q.min_jacobian; }},
        {"scaled_jacobian", [](const ElementQuality& q) { return q.scaled_jacobian; }},
        {"min_angle", [](const ElementQuality& q) { return q.min_angle; }},
        {"max_angle", [](const ElementQuality& q) { return q.max_angle; }},
        {"aspect_ratio", [](const ElementQuality& q) { return q.aspect_ratio; }},
    };
    if (with_reference)
        all.push_back({"size_skew", [](const ElementQuality& q) { return q.size_skew; }});
    return all;
}

std::string counts(const MeshData& data)
{
    return std::to_string(data.points.rows()) + " vertices and " + std::to_string(data.elements.size()) +
           " elements";
}

void require_same_mesh(const Options& options, const MeshData& data, const MeshData& reference)
{
    if (data.points.rows() != reference.points.rows() || data.elements.size() != reference.elements.size())
        throw InputError(options.reference + " has " + counts(reference) + ", but " + options.mesh + " has " +
                         counts(data) + "; the reference must be the same mesh before it was moved");
    if (data.dimension != reference.dimension)
        throw InputError(options.reference + " and " + options.mesh +
                         " are not the same mesh: one is planar, the other a surface in space");
    for (std::size_t e = 0; e < data.elements.size(); ++e)
        if (data.elements[e] != reference.elements[e])
            throw InputError(options.reference + " and " + options.mesh + " are not the same mesh: element " +
                             std::to_string(e) + " has other vertices");
}

/// Positions of the reference file in the order of the mesh.
Points reference_points(const Options& options, const Mesh& mesh, const MeshData& data)
{
    const MeshData reference = read_mesh_data(options.reference, options.from);
    require_same_mesh(options, data, reference);
    Points ordered(vertex_count(mesh), 3);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        ordered.row(v) = reference.points.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    return ordered;
}

/// The shortest text that reads back as the same double.
std::string exact_number(double value)
{
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

std::string list_line(const MeshData& data, std::size_t id, const ElementQuality& quality,
                      const std::vector<Metric>& columns)
{
    const Element& element = data.elements[id];
    const int corners = corner_count(element);
    Eigen::RowVector3d centroid = Eigen::RowVector3d::Zero();
    for (int k = 0; k < corners; ++k)
        centroid += data.points.row(element[static_cast<std::size_t>(k)]) / corners;
    std::string line = std::to_string(id) + (corners == 3 ? ",triangle" : ",quad");
    for (const double coordinate : centroid)
        line += ',' + exact_number(coordinate);
    for (const Metric& metric : columns)
        line += ',' + exact_number(metric.value(quality));
    return line + '\n';
}

/// The inverted elements with their metrics, one a line.
void write_list(OutputFile& file, const MeshData& data, const std::vector<ElementQuality>& quality,
                const std::vector<Metric>& columns)
{
    std::string header = "id,type,x,y,z";
    for (const Metric& metric : columns)
        header += std::string(",") + metric.name;
    file.append(header + '\n');
    for (std::size_t id = 0; id < quality.size(); ++id)
        if (quality[id].inverted)
            file.append(list_line(data, id, quality[id], columns));
}

void set_field(MeshData& data, const std::string& name, Matrix values)
{
    std::erase_if(data.fields, [&](const Field& field) {
        return field.name == name && field.location == FieldLocation::element;
    });
    data.fields.push_back({name, FieldLocation::element, std::move(values)});
}

/// The mesh with each metric as an element field.
void write_metrics(const std::string& path, OutputFiles& outputs, MeshData data,
                   const std::vector<ElementQuality>& quality, std::vector<Metric> columns)
{
    columns.insert(columns.begin(),
                   {"inverted", [](const ElementQuality& q) { return q.inverted ? 1.0 : 0.0; }});
    for (const Metric& metric : columns) {
        Matrix values(static_cast<Index>(quality.size()), 1);
        for (std::size_t id = 0; id < quality.size(); ++id)
            values(static_cast<Index>(id), 0) = metric.value(quality[id]);
        set_field(data, metric.name, std::move(values));
    }
    for (const std::string& warning : write_mesh_data(data, path, outputs, "vtu"))
        warn(kTool, warning);
}

/// Metrics of every element in the order of the file.
std::vector<ElementQuality> in_file_order(const Mesh& mesh, const std::vector<ElementQuality>& quality)
{
    std::vector<ElementQuality> ordered(quality.size());
    for (std::size_t f = 0; f < quality.size(); ++f)
        ordered[static_cast<std::size_t>(mesh.numbering.element[f])] = quality[f];
    return ordered;
}

void write_elements(const Options& options, OutputFiles& outputs, const Mesh& mesh, const MeshData& data,
                    const PositionsView* reference)
{
    if (options.list.empty() && options.vtu.empty())
        return;
    const auto quality = in_file_order(mesh, element_quality(mesh, points(mesh), reference));
    const auto columns = metrics(reference != nullptr);
    if (!options.list.empty())
        write_list(outputs.open(options.list), data, quality, columns);
    if (!options.vtu.empty())
        write_metrics(options.vtu, outputs, data, quality, columns);
}

QualityReport check(const Options& options, OutputFiles& outputs)
{
    for (const std::string& path : {options.list, options.vtu})
        if (!path.empty())
            OutputFiles::require_writable(path);
    const Mesh mesh = read_mesh(options.mesh, options.from);
    if (options.list.empty() && options.vtu.empty() && options.reference.empty())
        return quality_report(mesh);
    const MeshData data = to_data(mesh);
    if (options.reference.empty()) {
        write_elements(options, outputs, mesh, data, nullptr);
        return quality_report(mesh);
    }
    const Points reference = reference_points(options, mesh, data);
    const PositionsView view = reference;
    write_elements(options, outputs, mesh, data, &view);
    return quality_report(mesh, points(mesh), view);
}

int quality(int argc, char** argv)
{
    CommandLine line(
        kTool, "What is wrong with this mesh: inverted elements, scaled Jacobian, angles",
        "  morph-quality deformed.su2 --reference naca0012.su2 --list bad.csv\n"
        "counts the inverted elements of deformed.su2, compares every element with what it was in\n"
        "naca0012.su2, and lists the inverted ones with their centroids in bad.csv.");
    Options options;
    line.app().add_option("mesh", options.mesh, "Mesh file")->required()->type_name("MESH");
    line.app()
        .add_option("--reference", options.reference, "The same mesh before it was moved: adds size-skew")
        ->type_name("UNDEFORMED");
    line.app()
        .add_option("--list", options.list, "Write the inverted elements as CSV")
        ->type_name("FILE.csv");
    line.app()
        .add_option("--vtu", options.vtu, "Write the mesh with every metric as an element field")
        ->type_name("FILE.vtu");
    line.add_from(options.from);
    if (!line.parse(argc, argv))
        return kDone;

    Report report(line.common());
    OutputFiles outputs;
    const QualityReport result = check(options, outputs);
    report.json = quality_json(result);
    for (const std::string& text : quality_summary(result))
        report.say(text);
    report.finish(outputs);
    return result.inverted > 0 ? kInverted : kDone;
}

} // namespace
} // namespace morph::tools

int main(int argc, char** argv)
{
    return morph::tools::run("morph-quality", [&] { return morph::tools::quality(argc, argv); });
}
