#include "libmorph/mesh/builder.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/duplicates.h"
#include "libmorph/mesh/halfedges.h"
#include "libmorph/mesh/input_check.h"
#include "libmorph/mesh/nonmanifold_vertices.h"
#include "libmorph/mesh/orientation.h"
#include "libmorph/mesh/renumber.h"

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 32768;

/// Make the edges of markers halfedges of the kernel, while each edge is still identified by its two vertices.
void markers_to_halfedges(Mesh& mesh, const EdgeTable& edges)
{
    for (Marker& marker : mesh.markers)
        for (auto& [from, to] : marker.edges) {
            const Index halfedge = find_halfedge(mesh.kernel, edges, from, to);
            if (halfedge < 0)
                throw InputError("marker '" + marker.name + "' names the edge from vertex " +
                                 std::to_string(mesh.numbering.vertex[static_cast<std::size_t>(from)]) +
                                 " to " +
                                 std::to_string(mesh.numbering.vertex[static_cast<std::size_t>(to)]) +
                                 ", but no element has it");
            from = halfedge;
        }
}

/// And back, once vertices are split: each to the copy that its own elements got.
void halfedges_to_markers(Mesh& mesh)
{
    for (Marker& marker : mesh.markers)
        for (auto& [from, to] : marker.edges) {
            const HalfedgeHandle halfedge(from);
            from = mesh.kernel.from_vertex_handle(halfedge).idx();
            to = mesh.kernel.to_vertex_handle(halfedge).idx();
        }
}

void split_vertices(Mesh& mesh)
{
    for (const Index original : split_nonmanifold_vertices(mesh.kernel))
        mesh.numbering.vertex.push_back(mesh.numbering.vertex[static_cast<std::size_t>(original)]);
}

/// Row i of the result is row rows[i] of @p values.
Matrix gathered(const Matrix& values, const std::vector<Index>& rows)
{
    Matrix result(static_cast<Eigen::Index>(rows.size()), values.cols());
    parallel_for(rows.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            result.row(static_cast<Eigen::Index>(i)) = values.row(rows[i]);
    });
    return result;
}

/// Row rows[i] of the result is row i of @p values, for the first @p count rows, which name each once.
template <typename Dense, typename Values>
Dense scattered(const Values& values, const std::vector<Index>& rows, std::size_t count)
{
    Dense result(static_cast<Eigen::Index>(count), values.cols());
    parallel_for(count, kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            result.row(rows[i]) = values.row(static_cast<Eigen::Index>(i));
    });
    return result;
}

std::vector<Element> elements_of_file(const Mesh& mesh)
{
    std::vector<Element> elements(mesh.numbering.element.size());
    parallel_for(elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            Element element = element_corners(mesh, static_cast<Index>(f));
            for (Index& v : element)
                v = v < 0 ? v : mesh.numbering.vertex[static_cast<std::size_t>(v)];
            const auto place = static_cast<std::size_t>(mesh.numbering.element[f]);
            elements[place] = mesh.numbering.reversed[f] ? reversed(element) : element;
        }
    });
    return elements;
}

std::vector<Marker> markers_of_file(const Mesh& mesh)
{
    std::vector<Marker> markers = mesh.markers;
    for (Marker& marker : markers)
        for (auto& edge : marker.edges)
            for (Index& v : edge)
                v = mesh.numbering.vertex[static_cast<std::size_t>(v)];
    return markers;
}

/// The groups with each element number f replaced by numbers[f].
std::vector<ElementGroup> renumbered(std::vector<ElementGroup> groups, const std::vector<Index>& numbers)
{
    for (ElementGroup& group : groups)
        for (Index& element : group.elements)
            element = numbers[static_cast<std::size_t>(element)];
    return groups;
}

std::vector<Index> inverse(const std::vector<Index>& permutation)
{
    std::vector<Index> result(permutation.size());
    for (std::size_t i = 0; i < permutation.size(); ++i)
        result[static_cast<std::size_t>(permutation[i])] = static_cast<Index>(i);
    return result;
}

} // namespace

Mesh build_mesh(MeshData data)
{
    check_input(data);
    Mesh mesh;
    mesh.dimension = data.dimension;
    renumber_vertices(mesh, data);
    renumber_elements(mesh, data.elements);
    require_distinct_elements(data.elements, mesh.numbering);
    EdgeTable edges = match_edges(data.elements, vertex_count(mesh), mesh.numbering);
    mesh.numbering.reversed = orient_elements(mesh, data.elements, edges);
    fill_kernel(mesh.kernel, data.elements, edges);

    mesh.markers = std::move(data.markers);
    markers_to_halfedges(mesh, edges);
    split_vertices(mesh);
    halfedges_to_markers(mesh);
    if (!data.groups.empty())
        mesh.groups = renumbered(std::move(data.groups), inverse(mesh.numbering.element));
    mesh.fields = std::move(data.fields);
    for (Field& field : mesh.fields)
        field.values =
            gathered(field.values, field.location == FieldLocation::vertex ? mesh.numbering.vertex
                                                                           : mesh.numbering.element);
    mesh.sections = std::move(data.sections);
    return mesh;
}

MeshData to_mesh_data(const Mesh& mesh)
{
    const auto vertices = static_cast<std::size_t>(mesh.numbering.file_vertices);
    const std::size_t elements = mesh.numbering.element.size();
    MeshData data;
    data.dimension = mesh.dimension;
    data.points = scattered<Points>(points(mesh), mesh.numbering.vertex, vertices);
    data.elements = elements_of_file(mesh);
    data.markers = markers_of_file(mesh);
    data.groups = renumbered(mesh.groups, mesh.numbering.element);
    for (const Field& field : mesh.fields)
        data.fields.push_back({field.name, field.location,
                               field.location == FieldLocation::vertex
                                   ? scattered<Matrix>(field.values, mesh.numbering.vertex, vertices)
                                   : scattered<Matrix>(field.values, mesh.numbering.element, elements)});
    data.sections = mesh.sections;
    return data;
}

} // namespace morph
