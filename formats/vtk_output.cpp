#include "formats/vtk_cells.h"

#include <algorithm>
#include <numeric>

namespace morph {

namespace {

std::size_t line_count(const MeshData& mesh)
{
    return std::accumulate(mesh.markers.begin(), mesh.markers.end(), std::size_t{0},
                           [](std::size_t sum, const Marker& m) { return sum + m.edges.size(); });
}

std::size_t corner_total(const MeshData& mesh)
{
    std::size_t total = 2 * line_count(mesh);
    for (const Element& element : mesh.elements)
        total += static_cast<std::size_t>(corner_count(element));
    return total;
}

/// Calls visit(corners, count) for each cell: the elements, then the edges of each marker.
template <class Visit>
void for_each_cell(const MeshData& mesh, const Visit& visit)
{
    for (const Element& element : mesh.elements)
        visit(element.data(), corner_count(element));
    for (const Marker& marker : mesh.markers)
        for (const auto& edge : marker.edges)
            visit(edge.data(), 2);
}

void put_corners(const MeshData& mesh, const NumberSink& sink)
{
    std::vector<std::int64_t> corners;
    corners.reserve(corner_total(mesh));
    for_each_cell(mesh,
                  [&](const Index* cell, int count) { corners.insert(corners.end(), cell, cell + count); });
    sink(view_of(NumberType::int64, corners.data(), corners.size()));
}

void put_ends(const MeshData& mesh, const NumberSink& sink)
{
    std::vector<std::int64_t> ends;
    ends.reserve(mesh.elements.size() + line_count(mesh));
    std::int64_t end = 0;
    for_each_cell(mesh, [&](const Index*, int count) { ends.push_back(end += count); });
    sink(view_of(NumberType::int64, ends.data(), ends.size()));
}

void put_types(const MeshData& mesh, const NumberSink& sink)
{
    constexpr std::array<std::uint8_t, 5> type_of_count{0, 0, 3, 5, 9};
    std::vector<std::uint8_t> types;
    types.reserve(mesh.elements.size() + line_count(mesh));
    for_each_cell(
        mesh, [&](const Index*, int count) { types.push_back(type_of_count[static_cast<unsigned>(count)]); });
    sink(view_of(NumberType::uint8, types.data(), types.size()));
}

void put_marker_numbers(const MeshData& mesh, const NumberSink& sink)
{
    std::vector<std::int32_t> numbers(mesh.elements.size(), 0);
    for (std::size_t m = 0; m < mesh.markers.size(); ++m)
        numbers.insert(numbers.end(), mesh.markers[m].edges.size(), static_cast<std::int32_t>(m + 1));
    sink(view_of(NumberType::int32, numbers.data(), numbers.size()));
}

/// For each line cell an element that has its first vertex.
std::vector<Index> elements_beside_lines(const MeshData& mesh)
{
    std::vector<Index> element_at(static_cast<std::size_t>(mesh.points.rows()), 0);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (int i = 0; i < corner_count(mesh.elements[e]); ++i)
            element_at[static_cast<std::size_t>(mesh.elements[e][static_cast<std::size_t>(i)])] =
                static_cast<Index>(e);
    std::vector<Index> beside;
    beside.reserve(line_count(mesh));
    for (const Marker& marker : mesh.markers)
        for (const auto& edge : marker.edges)
            beside.push_back(element_at[static_cast<std::size_t>(edge[0])]);
    return beside;
}

void put_matrix(const Matrix& values, const NumberSink& sink)
{
    sink(view_of(NumberType::float64, values.data(), static_cast<std::size_t>(values.size())));
}

void put_cell_field(const MeshData& mesh, const Field& field, const NumberSink& sink)
{
    put_matrix(field.values, sink);
    if (mesh.elements.empty()) // nothing is beside the lines
        put_matrix(Matrix::Zero(static_cast<Index>(line_count(mesh)), field.values.cols()), sink);
    else if (!mesh.markers.empty())
        put_matrix(field.values(elements_beside_lines(mesh), Eigen::all), sink);
}

VtkArray field_array(const MeshData& mesh, const Field& field)
{
    const auto components = static_cast<std::size_t>(field.values.cols());
    const auto rows = static_cast<std::size_t>(field.values.rows());
    if (field.location == FieldLocation::vertex)
        return {field.name, NumberType::float64, rows, components,
                [&field](const NumberSink& sink) { put_matrix(field.values, sink); }};
    return {field.name, NumberType::float64, rows + line_count(mesh), components,
            [&mesh, &field](const NumberSink& sink) { put_cell_field(mesh, field, sink); }};
}

std::string free_marker_array(const MeshData& mesh)
{
    std::string name = "marker";
    while (find_field(mesh.fields, name, FieldLocation::element))
        name += '_';
    return name;
}

} // namespace

VtkOutput vtk_output(const MeshData& mesh)
{
    const std::size_t cells = mesh.elements.size() + line_count(mesh);
    const auto points = static_cast<std::size_t>(mesh.points.rows());
    const auto bound = [&mesh](auto put) {
        return [&mesh, put](const NumberSink& sink) { put(mesh, sink); };
    };
    VtkOutput output{{"Points", NumberType::float64, points, 3,
                      [&mesh, points](const NumberSink& sink) {
                          sink(view_of(NumberType::float64, mesh.points.data(), 3 * points));
                      }},
                     {"connectivity", NumberType::int64, corner_total(mesh), 1, bound(put_corners)},
                     {"offsets", NumberType::int64, cells, 1, bound(put_ends)},
                     {"types", NumberType::uint8, cells, 1, bound(put_types)},
                     {},
                     {},
                     {}};
    if (!mesh.markers.empty()) {
        output.marker_array = free_marker_array(mesh);
        output.cell_data.push_back(
            {output.marker_array, NumberType::int32, cells, 1, bound(put_marker_numbers)});
    }
    for (const Field& field : mesh.fields)
        (field.location == FieldLocation::vertex ? output.point_data : output.cell_data)
            .push_back(field_array(mesh, field));
    return output;
}

std::vector<std::int32_t> counted_corners(const MeshData& mesh)
{
    std::vector<std::int32_t> numbers;
    numbers.reserve(corner_total(mesh) + mesh.elements.size() + line_count(mesh));
    for_each_cell(mesh, [&](const Index* cell, int count) {
        numbers.push_back(count);
        numbers.insert(numbers.end(), cell, cell + count);
    });
    return numbers;
}

} // namespace morph
