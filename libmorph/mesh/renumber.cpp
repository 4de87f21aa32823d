#include "libmorph/mesh/renumber.h"

#include "libmorph/core/parallel.h"
#include "libmorph/core/radix_sort.h"
#include "libmorph/core/space_curve.h"

#include <algorithm>
#include <bit>

namespace morph {

namespace {

constexpr std::size_t kRowsPerBlock = 32768;

std::vector<Index> inverse(const std::vector<Index>& order)
{
    std::vector<Index> place(order.size());
    parallel_for(order.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            place[static_cast<std::size_t>(order[i])] = static_cast<Index>(i);
    });
    return place;
}

void fill_vertices(Mesh& mesh, const Points& file_points)
{
    mesh.kernel.resize(mesh.numbering.vertex.size(), 0, 0);
    Eigen::Map<Points> target = points(mesh);
    parallel_for(mesh.numbering.vertex.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            target.row(static_cast<Index>(v)) = file_points.row(mesh.numbering.vertex[v]);
    });
}

/// Make elements and markers name vertices by their new numbers.
void rename_vertices(MeshData& data, const std::vector<Index>& new_number)
{
    const auto rename = [&](Index& v) { v = new_number[static_cast<std::size_t>(v)]; };
    parallel_for(data.elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            std::for_each(data.elements[f].begin(), data.elements[f].begin() + corner_count(data.elements[f]),
                          rename);
    });
    for (Marker& marker : data.markers)
        for (auto& edge : marker.edges)
            std::for_each(edge.begin(), edge.end(), rename);
}

Index smallest_corner(const Element& element)
{
    return *std::min_element(element.begin(), element.begin() + corner_count(element));
}

} // namespace

void renumber_vertices(Mesh& mesh, MeshData& data)
{
    mesh.numbering.vertex = hilbert_order(data.points, data.dimension);
    mesh.numbering.file_vertices = static_cast<Index>(data.points.rows());
    fill_vertices(mesh, data.points);
    data.points.resize(0, 3);
    rename_vertices(data, inverse(mesh.numbering.vertex));
}

void renumber_elements(Mesh& mesh, std::vector<Element>& elements)
{
    std::vector<Keyed<std::uint32_t>> keyed(elements.size());
    parallel_for(elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            keyed[f] = {static_cast<std::uint32_t>(smallest_corner(elements[f])), static_cast<Index>(f)};
    });
    radix_sort(keyed, std::bit_width(mesh.kernel.n_vertices()));
    std::vector<Element> sorted(elements.size());
    mesh.numbering.element.resize(elements.size());
    parallel_for(elements.size(), kRowsPerBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            mesh.numbering.element[f] = keyed[f].item;
            sorted[f] = elements[static_cast<std::size_t>(keyed[f].item)];
        }
    });
    elements = std::move(sorted);
}

} // namespace morph
