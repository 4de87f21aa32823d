#include "formats/vtk/output.h"

#include "formats/mesh/cell_types.h"
#include "formats/mesh/marker_elements.h"

#include <algorithm>
#include <numeric>

namespace morph {

namespace {

using Put = std::function<void(const NumberSink&)>;

std::size_t line_count(const MeshData& mesh)
{
    return std::accumulate(mesh.markers.begin(), mesh.markers.end(), std::size_t{0},
                           [](std::size_t sum, const Marker& m) { return sum + m.edges.size(); });
}

std::size_t element_corners(const MeshData& mesh)
{
    std::size_t total = 0;
    for (const Element& element : mesh.elements)
        total += static_cast<std::size_t>(corner_count(element));
    return total;
}

template <class T>
void put_vector(NumberType type, const std::vector<T>& numbers, const NumberSink& sink)
{
    sink(view_of(type, numbers.data(), numbers.size()));
}

void put_matrix(const Matrix& values, const NumberSink& sink)
{
    sink(view_of(NumberType::float64, values.data(), static_cast<std::size_t>(values.size())));
}

void put_element_corners(const MeshData& mesh, const NumberSink& sink)
{
    std::vector<std::int64_t> corners(element_corners(mesh));
    auto* at = corners.data();
    for (const Element& element : mesh.elements)
        at = std::copy_n(element.data(), corner_count(element), at);
    put_vector(NumberType::int64, corners, sink);
}

void put_line_corners(const MeshData& mesh, const NumberSink& sink)
{
    std::vector<std::int64_t> corners;
    corners.reserve(2 * line_count(mesh));
    for (const Marker& marker : mesh.markers)
        for (const auto& edge : marker.edges)
            corners.insert(corners.end(), edge.begin(), edge.end());
    put_vector(NumberType::int64, corners, sink);
}

void put_element_ends(const MeshData& mesh, const NumberSink& sink)
{
    std::vector<std::int64_t> ends(mesh.elements.size());
    std::int64_t end = 0;
    for (std::size_t e = 0; e < ends.size(); ++e)
        ends[e] = end += corner_count(mesh.elements[e]);
    put_vector(NumberType::int64, ends, sink);
}

void put_line_ends(const MeshData& mesh, std::size_t first, const NumberSink& sink)
{
    std::vector<std::int64_t> ends(line_count(mesh));
    for (std::size_t i = 0; i < ends.size(); ++i)
        ends[i] = static_cast<std::int64_t>(first + 2 * (i + 1));
    put_vector(NumberType::int64, ends, sink);
}

void put_types(const MeshData& mesh, const NumberSink& sink)
{
    std::vector<std::uint8_t> types(mesh.elements.size());
    std::transform(mesh.elements.begin(), mesh.elements.end(), types.begin(), [](const Element& element) {
        return static_cast<std::uint8_t>(corner_count(element) == 3 ? kTriangleCell : kQuadCell);
    });
    types.insert(types.end(), line_count(mesh), static_cast<std::uint8_t>(kEdgeCell));
    put_vector(NumberType::uint8, types, sink);
}

std::vector<std::int32_t> marker_numbers(const MeshData& mesh)
{
    std::vector<std::int32_t> numbers;
    numbers.reserve(line_count(mesh));
    for (std::size_t m = 0; m < mesh.markers.size(); ++m)
        numbers.insert(numbers.end(), mesh.markers[m].edges.size(), static_cast<std::int32_t>(m + 1));
    return numbers;
}

void put_beside_lines(const MeshData& mesh, const Field& field, const NumberSink& sink)
{
    if (mesh.elements.empty()) // there are only lines
        put_matrix(Matrix::Zero(static_cast<Index>(line_count(mesh)), field.values.cols()), sink);
    else if (!mesh.markers.empty())
        put_matrix(field.values(elements_at_markers(mesh), Eigen::all), sink);
}

/// Makes the arrays of one mesh.
class Output {
public:
    Output(const MeshData& mesh, VtkOrder order) : mesh_(mesh), order_(order), lines_(line_count(mesh)) {}

    VtkOutput output() const
    {
        const std::size_t elements = mesh_.elements.size();
        const std::size_t corners = element_corners(mesh_);
        const MeshData& mesh = mesh_;
        const Put element_corners = [&mesh](const NumberSink& sink) { put_element_corners(mesh, sink); };
        const Put element_ends = [&mesh](const NumberSink& sink) { put_element_ends(mesh, sink); };
        const Put line_corners = [&mesh](const NumberSink& sink) { put_line_corners(mesh, sink); };
        const auto line_ends = [&mesh](std::size_t first) -> Put {
            return [&mesh, first](const NumberSink& sink) { put_line_ends(mesh, first, sink); };
        };
        VtkOutput output{points(),
                         cell_list(corners + 2 * lines_, elements + lines_,
                                   both(element_corners, line_corners),
                                   both(element_ends, line_ends(corners))),
                         cell_list(corners, elements, element_corners, element_ends),
                         cell_list(2 * lines_, lines_, line_corners, line_ends(0)),
                         {"types", NumberType::uint8, elements + lines_, 1,
                          [&mesh](const NumberSink& sink) { put_types(mesh, sink); }},
                         {},
                         {},
                         {}};
        add_markers(output);
        add_groups(output);
        for (const Field& field : mesh_.fields)
            if (field.location == FieldLocation::vertex)
                output.point_data.push_back(vertex_array(field));
            else
                output.cell_data.push_back(element_array(field));
        return output;
    }

private:
    static Put both(const Put& first, const Put& second)
    {
        return [first, second](const NumberSink& sink) {
            first(sink);
            second(sink);
        };
    }

    static VtkCellList cell_list(std::size_t corners, std::size_t cells, const Put& put_corners,
                                 const Put& put_ends)
    {
        return {{"connectivity", NumberType::int64, corners, 1, put_corners},
                {"offsets", NumberType::int64, cells, 1, put_ends}};
    }

    /// One row for each cell.
    VtkArray cell_array(const std::string& name, NumberType type, std::size_t components,
                        const Put& of_elements, const Put& of_lines) const
    {
        return {name, type, mesh_.elements.size() + lines_, components,
                order_ == VtkOrder::elements_first ? both(of_elements, of_lines)
                                                   : both(of_lines, of_elements)};
    }

    /// Numbers of the elements, or of the lines; 0 for the others.
    template <class T>
    VtkArray number_array(const std::string& name, NumberType type, std::vector<T> of_elements,
                          std::vector<T> of_lines) const
    {
        const auto put = [type](std::vector<T> numbers) -> Put {
            return [type, numbers = std::move(numbers)](const NumberSink& sink) {
                put_vector(type, numbers, sink);
            };
        };
        of_elements.resize(mesh_.elements.size(), 0);
        of_lines.resize(lines_, 0);
        return cell_array(name, type, 1, put(std::move(of_elements)), put(std::move(of_lines)));
    }

    VtkArray points() const
    {
        const MeshData& mesh = mesh_;
        const auto rows = static_cast<std::size_t>(mesh.points.rows());
        return {"Points", NumberType::float64, rows, 3, [&mesh, rows](const NumberSink& sink) {
                    sink(view_of(NumberType::float64, mesh.points.data(), 3 * rows));
                }};
    }

    void add_markers(VtkOutput& output) const
    {
        if (mesh_.markers.empty())
            return;
        VtkNames& markers = output.names.emplace_back();
        markers.array = free_array(mesh_, VtkNamed::marker);
        for (const Marker& marker : mesh_.markers)
            markers.names.push_back(marker.name);
        output.cell_data.push_back(
            number_array<std::int32_t>(markers.array, NumberType::int32, {}, marker_numbers(mesh_)));
    }

    void add_groups(VtkOutput& output) const
    {
        if (mesh_.groups.empty())
            return;
        VtkNames& groups = output.names.emplace_back();
        groups.array = free_array(mesh_, VtkNamed::group);
        for (const ElementGroup& group : mesh_.groups)
            groups.names.push_back(group.name);
        GroupNumbers numbers = group_numbers(mesh_);
        output.cell_data.push_back(
            number_array<std::int32_t>(groups.array, NumberType::int32, std::move(numbers.first), {}));
        for (const std::size_t number : numbers.incomplete)
            output.cell_data.push_back(
                number_array<std::uint8_t>(overlap_array(groups.array, number), NumberType::uint8,
                                           membership(mesh_, mesh_.groups[number - 1]), {}));
    }

    static VtkArray vertex_array(const Field& field)
    {
        return {field.name, NumberType::float64, static_cast<std::size_t>(field.values.rows()),
                static_cast<std::size_t>(field.values.cols()),
                [&field](const NumberSink& sink) { put_matrix(field.values, sink); }};
    }

    VtkArray element_array(const Field& field) const
    {
        const MeshData& mesh = mesh_;
        return cell_array(
            field.name, NumberType::float64, static_cast<std::size_t>(field.values.cols()),
            [&field](const NumberSink& sink) { put_matrix(field.values, sink); },
            [&mesh, &field](const NumberSink& sink) { put_beside_lines(mesh, field, sink); });
    }

    const MeshData& mesh_;
    VtkOrder order_;
    std::size_t lines_;
};

} // namespace

VtkOutput vtk_output(const MeshData& mesh, VtkOrder order)
{
    return Output(mesh, order).output();
}

std::vector<std::int32_t> counted_corners(const MeshData& mesh)
{
    std::vector<std::int32_t> numbers;
    numbers.reserve(element_corners(mesh) + mesh.elements.size() + 3 * line_count(mesh));
    for (const Element& element : mesh.elements) {
        numbers.push_back(corner_count(element));
        numbers.insert(numbers.end(), element.begin(), element.begin() + corner_count(element));
    }
    for (const Marker& marker : mesh.markers)
        for (const auto& edge : marker.edges)
            numbers.insert(numbers.end(), {2, edge[0], edge[1]});
    return numbers;
}

} // namespace morph
