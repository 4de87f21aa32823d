#include "formats/medit/write.h"

#include "formats/medit/opaque_sections.h"
#include "formats/medit/sink.h"
#include "formats/mesh/element_groups.h"
#include "formats/text/element_order.h"
#include "formats/text/numbered_names.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::size_t kBytesOfHeads = 4096; // of the sections, and more than that

std::vector<std::int32_t> marker_numbers(const MeshData& mesh)
{
    std::vector<std::string> names;
    for (const Marker& marker : mesh.markers)
        names.push_back(marker.name);
    return numbers_of(names, true);
}

void write_vertices(const MeshData& mesh, const std::vector<std::int64_t>& references, MeditSink& sink)
{
    const auto count = static_cast<std::size_t>(mesh.points.rows());
    sink.section("Vertices", count, {}, static_cast<std::size_t>(mesh.dimension), 1);
    for (std::size_t v = 0; v < count; ++v) {
        const std::int64_t reference = references.empty() ? 0 : references[v];
        sink.line(mesh.points.data() + 3 * v, &reference);
    }
}

void write_edges(const MeshData& mesh, const std::vector<std::int32_t>& numbers, std::size_t count,
                 MeditSink& sink)
{
    if (count == 0)
        return;
    sink.section("Edges", count, {}, 0, 3);
    for (std::size_t m = 0; m < mesh.markers.size(); ++m)
        for (const auto& [from, to] : mesh.markers[m].edges) {
            const std::array<std::int64_t, 3> line{from + std::int64_t{1}, to + std::int64_t{1}, numbers[m]};
            sink.line(nullptr, line.data());
        }
}

void write_faces(const MeshData& mesh, const std::vector<std::int32_t>& references, int corners,
                 MeditSink& sink)
{
    const auto is_one = [&](const Element& element) { return corner_count(element) == corners; };
    const auto count = std::count_if(mesh.elements.begin(), mesh.elements.end(), is_one);
    if (count == 0)
        return;
    const auto size = static_cast<std::size_t>(corners);
    sink.section(corners == 3 ? "Triangles" : "Quadrilaterals", static_cast<std::size_t>(count), {}, 0,
                 size + 1);
    std::array<std::int64_t, 5> line{};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        if (!is_one(mesh.elements[e]))
            continue;
        for (std::size_t k = 0; k < size; ++k)
            line.at(k) = mesh.elements[e][k] + std::int64_t{1};
        line.at(size) = references[e];
        sink.line(nullptr, line.data());
    }
}

void write_list(const MeditNumbers& list, MeditSink& sink)
{
    if (list.numbers.empty())
        return;
    sink.section(list.list.keyword, list.numbers.size(), {}, 0, 1);
    for (const std::int64_t& number : list.numbers)
        sink.line(nullptr, &number);
}

std::string comments(const MeshData& mesh, const std::vector<std::int32_t>& markers,
                     const std::vector<std::int32_t>& groups)
{
    std::vector<NumberedName> names;
    for (std::size_t m = 0; m < markers.size(); ++m)
        names.push_back({"marker", markers[m], markers[m], mesh.markers[m].name});
    for (std::size_t g = 0; g < groups.size(); ++g)
        names.push_back({"group", groups[g], groups[g], mesh.groups[g].name});
    const std::string text = names_text(names) + element_order_text(mesh.elements);
    return text.empty() ? text : "\n" + text;
}

} // namespace

void write_medit(const MeshData& mesh, const WriteOptions& options, OutputFile& out)
{
    const MeditEdges edges = marker_edges(mesh);
    const MeditExtras extras = medit_extras(mesh, edges);
    const std::vector<std::int32_t> markers = marker_numbers(mesh);
    const GroupReferences groups = group_references(mesh);
    std::size_t bytes = kBytesOfHeads + static_cast<std::size_t>(mesh.points.rows()) * 28 +
                        edges.size() * 12 + mesh.elements.size() * 20;
    for (const MeditNumbers& list : extras.lists)
        bytes += list.numbers.size() * 4;
    const auto sink = medit_sink(out, is_binary_medit(out.path(), options.binary), mesh.dimension, bytes);
    write_vertices(mesh, extras.vertex_references, *sink);
    write_edges(mesh, markers, edges.size(), *sink);
    write_faces(mesh, groups.elements, 3, *sink);
    write_faces(mesh, groups.elements, 4, *sink);
    for (const MeditNumbers& list : extras.lists)
        write_list(list, *sink);
    sink->end(comments(mesh, markers, groups.groups));
}

std::vector<std::string> medit_losses(const MeshData& mesh, const WriteOptions&)
{
    std::vector<std::string> lost = overlap_losses(mesh);
    const MeditExtras extras = medit_extras(mesh, marker_edges(mesh));
    lost.insert(lost.end(), extras.lost.begin(), extras.lost.end());
    return lost;
}

} // namespace morph
