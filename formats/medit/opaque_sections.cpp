#include "formats/medit/opaque_sections.h"

#include "formats/text/text_scanner.h"

#include <algorithm>

namespace morph {

namespace {

constexpr std::string_view kVertexReferences = "Vertices";

bool fits_reference(std::int64_t number)
{
    return number == static_cast<std::int32_t>(number);
}

bool is_face_of(MeditListed listed, const Element& element)
{
    return corner_count(element) == (listed == MeditListed::triangles ? 3 : 4);
}

/// The elements of one number of corners, in order.
std::vector<Index> faces_of(MeditListed listed, const MeshData& mesh)
{
    std::vector<Index> faces;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        if (is_face_of(listed, mesh.elements[e]))
            faces.push_back(static_cast<Index>(e));
    return faces;
}

/// Finds the number of an edge by its two vertices, in either direction.
class EdgeNumbers {
public:
    explicit EdgeNumbers(const MeditEdges& edges)
    {
        for (std::size_t i = 0; i < edges.size(); ++i)
            rows_.push_back({std::minmax(edges[i][0], edges[i][1]), static_cast<std::int64_t>(i + 1)});
        std::sort(rows_.begin(), rows_.end());
    }

    /// From 1; 0: there is no such edge.
    std::int64_t find(Index a, Index b) const
    {
        const std::pair<Index, Index> ends = std::minmax(a, b);
        const auto row = std::lower_bound(rows_.begin(), rows_.end(), Row{ends, 0});
        return row != rows_.end() && row->first == ends ? row->second : 0;
    }

private:
    using Row = std::pair<std::pair<Index, Index>, std::int64_t>;
    std::vector<Row> rows_;
};

std::vector<std::int64_t> rest_of(TextScanner& in)
{
    std::vector<std::int64_t> numbers;
    while (in.skip_white())
        numbers.push_back(in.integer("a number"));
    return numbers;
}

/// The number in a file of each thing that a carried list names; 0: it is there no more.
std::vector<std::int64_t> file_numbers(MeditListed listed, const std::vector<std::int64_t>& carried,
                                       const MeshData& mesh, const EdgeNumbers& edges)
{
    std::vector<std::int64_t> numbers;
    if (listed == MeditListed::vertices) {
        for (const std::int64_t vertex : carried)
            numbers.push_back(vertex < mesh.points.rows() ? vertex + 1 : 0);
    } else if (listed == MeditListed::edges) {
        for (std::size_t i = 0; i + 1 < carried.size(); i += 2)
            numbers.push_back(edges.find(static_cast<Index>(carried[i]), static_cast<Index>(carried[i + 1])));
    } else {
        const std::vector<Index> faces = faces_of(listed, mesh);
        for (const std::int64_t element : carried) {
            const auto found = std::lower_bound(faces.begin(), faces.end(), element);
            numbers.push_back(found != faces.end() && *found == element ? found - faces.begin() + 1 : 0);
        }
    }
    return numbers;
}

} // namespace

std::size_t listed_medit_things(MeditListed listed, const MeditEdges& edges, const MeshData& mesh)
{
    if (listed == MeditListed::vertices)
        return static_cast<std::size_t>(mesh.points.rows());
    if (listed == MeditListed::edges)
        return edges.size();
    return static_cast<std::size_t>(
        std::count_if(mesh.elements.begin(), mesh.elements.end(),
                      [&](const Element& element) { return is_face_of(listed, element); }));
}

OpaqueSection vertex_reference_section(const std::vector<std::int64_t>& references)
{
    std::string text = std::string(kVertexReferences) + "\n";
    for (const std::int64_t reference : references)
        text += std::to_string(reference) + "\n";
    return {"medit", "the references of " + std::to_string(references.size()) + " vertices", text};
}

OpaqueSection list_section(const MeditNumbers& list, const MeditEdges& edges, const MeshData& mesh)
{
    std::string text = std::string(list.list.keyword) + "\n";
    const std::vector<Index> faces = faces_of(list.list.listed, mesh);
    for (const std::int64_t number : list.numbers) {
        const auto i = static_cast<std::size_t>(number - 1);
        if (list.list.listed == MeditListed::vertices)
            text += std::to_string(i) + "\n";
        else if (list.list.listed == MeditListed::edges)
            text += std::to_string(edges[i][0]) + " " + std::to_string(edges[i][1]) + "\n";
        else
            text += std::to_string(faces[i]) + "\n";
    }
    return {"medit", std::to_string(list.numbers.size()) + " " + std::string(list.list.keyword), text};
}

MeditExtras medit_extras(const MeshData& mesh, const MeditEdges& edges)
{
    MeditExtras extras;
    const EdgeNumbers edge_numbers(edges);
    const auto vertices = static_cast<std::size_t>(mesh.points.rows());
    for (const OpaqueSection& carried : mesh.sections) {
        if (carried.format != "medit")
            continue;
        TextScanner in("", carried.text);
        const std::string_view keyword = in.word("a keyword");
        std::vector<std::int64_t> numbers = rest_of(in);
        if (keyword == kVertexReferences) {
            const bool fit =
                numbers.size() == vertices && std::all_of(numbers.begin(), numbers.end(), fits_reference);
            if (fit)
                extras.vertex_references = std::move(numbers);
            else
                extras.lost.push_back(carried.what + ": the mesh has " + std::to_string(vertices) +
                                      " vertices, and references are below 2^31");
            continue;
        }
        const auto& lists = medit_lists();
        const auto list = std::find_if(lists.begin(), lists.end(),
                                       [&](const MeditList& known) { return known.keyword == keyword; });
        if (list == lists.end())
            continue;
        numbers = file_numbers(list->listed, numbers, mesh, edge_numbers);
        const auto gone = std::erase(numbers, 0);
        if (gone > 0)
            extras.lost.push_back(std::to_string(gone) + " of the " + carried.what +
                                  ", which are in the mesh no more");
        extras.lists.push_back({*list, std::move(numbers)});
    }
    return extras;
}

MeditEdges marker_edges(const MeshData& mesh)
{
    MeditEdges edges;
    for (const Marker& marker : mesh.markers)
        edges.insert(edges.end(), marker.edges.begin(), marker.edges.end());
    return edges;
}

} // namespace morph
