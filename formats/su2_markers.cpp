#include "formats/su2_markers.h"

#include "formats/cell_types.h"

#include <algorithm>
#include <array>

namespace morph {

namespace {

constexpr std::size_t kShortestLine = 4; // "1 0\n"

std::string element_of(const std::string& marker, std::size_t i)
{
    return "element " + std::to_string(i) + " of the marker " + marker;
}

} // namespace

void Su2Markers::read(TextScanner& in, std::size_t start)
{
    ++blocks_;
    const std::string name(in.rest_of_line());
    if (name.empty())
        in.fail_expected("a name after MARKER_TAG=");
    if (name == "SEND_RECEIVE") {
        carried_.add_marker(skip_su2_section(in, start, {"MARKER_ELEMS", "SEND_TO", "SEND_RECV"}));
        return;
    }
    in.skip_white();
    const std::size_t key = in.position();
    const std::string found = in.found();
    if (try_su2_key(in) != "MARKER_ELEMS")
        in.fail("expected MARKER_ELEMS= after MARKER_TAG= " + name + ", found " + found);
    blocks_with_edges_.push_back({name, read_su2_section(in, "MARKER_ELEMS", key)});
    read_lines(in, blocks_with_edges_.back());
}

void Su2Markers::read_lines(TextScanner& in, const Block& block)
{
    std::vector<std::array<Index, 2>> edges;
    edges.reserve(su2_room(in, block.lines, kShortestLine));
    std::size_t vertex_count = 0;
    std::string vertex_lines;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.lines.count); ++i) {
        in.skip_white();
        const std::size_t line = in.position();
        if (read_line(in, block, i, edges))
            continue;
        in.seek(line);
        vertex_lines.append(in.rest_of_line()).append("\n");
        ++vertex_count;
    }
    if (vertex_count > 0)
        carried_.add_marker_vertices(block.name, vertex_count, vertex_lines);
    if (vertex_count == 0 || !edges.empty()) {
        std::vector<std::array<Index, 2>>& all = marker_called(block.name).edges;
        all.insert(all.end(), edges.begin(), edges.end());
    }
}

/// An edge is added to @p edges; false for a line that has only a vertex.
bool Su2Markers::read_line(TextScanner& in, const Block& block, std::size_t i,
                           std::vector<std::array<Index, 2>>& edges)
{
    Index type = 0;
    if (!in.try_index(type))
        fail_su2_short(in, block.lines, i, "the type of " + element_of(block.name, i));
    if (type != kEdgeCell && type != kVertexCell)
        in.fail(element_of(block.name, i) + " is " + cell_type_name(type) + "; supported are edges (type 3)");
    std::array<Index, 2> edge{0, 0};
    for (std::size_t k = 0; k < (type == kEdgeCell ? 2 : 1); ++k) {
        if (!in.try_index(edge[k]))
            in.fail_expected("vertex " + std::to_string(k + 1) + " of " + element_of(block.name, i));
        largest_vertex_ = std::max(largest_vertex_, edge[k]);
    }
    if (!end_su2_line(in))
        in.fail_expected("a number or the end of the line after " + element_of(block.name, i));
    if (type == kEdgeCell)
        edges.push_back(edge);
    return type == kEdgeCell;
}

Marker& Su2Markers::marker_called(const std::string& name)
{
    const auto [entry, is_new] = numbers_.try_emplace(name, markers_.size());
    if (is_new)
        markers_.push_back({name, {}});
    return markers_[entry->second];
}

void Su2Markers::check_vertices(TextScanner& in, Index vertices) const
{
    if (largest_vertex_ < vertices)
        return;
    for (const Block& block : blocks_with_edges_) {
        in.seek(block.lines.start);
        for (std::size_t i = 0; i < static_cast<std::size_t>(block.lines.count); ++i, in.skip_line()) {
            in.skip_white();
            const bool edge = in.index("a type") == kEdgeCell;
            const Index first = in.index("a vertex");
            const Index largest = edge ? std::max(first, in.index("a vertex")) : first;
            if (largest >= vertices)
                fail_su2_vertex(in, element_of(block.name, i), largest, vertices);
        }
    }
}

} // namespace morph
