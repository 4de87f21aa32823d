#include "formats/su2/markers.h"

#include "formats/mesh/cell_types.h"

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
    blocks_read_.push_back({name, read_su2_section(in, "MARKER_ELEMS", key)});
    read_lines(in, blocks_read_.back());
}

void Su2Markers::read_lines(TextScanner& in, const Block& block)
{
    Lines lines;
    if (dimension_ == 2)
        lines.edges.reserve(su2_room(in, block.lines, kShortestLine));
    std::size_t vertex_count = 0;
    std::string vertex_lines;
    for (std::size_t i = 0; i < static_cast<std::size_t>(block.lines.count); ++i) {
        in.skip_white();
        const std::size_t line = in.position();
        if (read_line(in, block, i, lines))
            continue;
        in.seek(line);
        vertex_lines.append(in.rest_of_line()).append("\n");
        ++vertex_count;
    }
    if (vertex_count > 0)
        carried_.add_marker_vertices(block.name, vertex_count, vertex_lines);
    if (!lines.faces.empty())
        add_faces(block.name, lines.faces, block.lines.key);
    if ((vertex_count == 0 && lines.faces.empty()) || !lines.edges.empty()) {
        std::vector<std::array<Index, 2>>& all = marker_called(block.name).edges;
        all.insert(all.end(), lines.edges.begin(), lines.edges.end());
    }
}

/// The type of a line, as the number of vertices that follow it.
std::size_t Su2Markers::corner_count_of(TextScanner& in, const Block& block, std::size_t i) const
{
    Index type = 0;
    if (!in.try_index(type))
        fail_su2_short(in, block.lines, i, "the type of " + element_of(block.name, i));
    const bool face = type == kTriangleCell || type == kQuadCell;
    if (type != kEdgeCell && type != kVertexCell && (!face || dimension_ == 2))
        in.fail(
            element_of(block.name, i) + " is " + cell_type_name(type) + "; supported are " +
            (dimension_ == 2 ? "edges (type 3)" : "edges (type 3), triangles (type 5) and quads (type 9)"));
    return type == kVertexCell ? 1 : type == kEdgeCell ? 2 : type == kTriangleCell ? 3 : 4;
}

/// An edge or face is added to @p lines; false for a line that has only a vertex.
bool Su2Markers::read_line(TextScanner& in, const Block& block, std::size_t i, Lines& lines)
{
    const std::size_t count = corner_count_of(in, block, i);
    Element corners{-1, -1, -1, -1};
    for (std::size_t k = 0; k < count; ++k) {
        if (!in.try_index(corners[k]))
            in.fail_expected("vertex " + std::to_string(k + 1) + " of " + element_of(block.name, i));
        largest_vertex_ = std::max(largest_vertex_, corners[k]);
    }
    if (!end_su2_line(in))
        in.fail_expected("a number or the end of the line after " + element_of(block.name, i));
    if (count == 2)
        lines.edges.push_back({corners[0], corners[1]});
    else if (count > 2)
        lines.faces.push_back(corners);
    return count > 1;
}

void Su2Markers::add_faces(const std::string& name, const std::vector<Element>& faces, std::size_t key)
{
    if (faces_.empty())
        first_faces_ = key;
    const auto [entry, is_new] = group_numbers_.try_emplace(name, groups_.size());
    if (is_new)
        groups_.push_back({name, {}});
    for (const Element& face : faces) {
        groups_[entry->second].elements.push_back(static_cast<Index>(faces_.size()));
        faces_.push_back(face);
    }
}

void Su2Markers::check_faces(const TextScanner& in, bool has_cells) const
{
    if (!has_cells && !faces_.empty())
        in.fail_at(first_faces_, "the marker " + groups_[0].name +
                                     " has triangles or quads, but the mesh has no volume cells, whose "
                                     "boundary they could be");
}

void Su2Markers::move_faces_to(MeshData& mesh)
{
    const auto first = static_cast<Index>(mesh.elements.size());
    mesh.elements.insert(mesh.elements.end(), faces_.begin(), faces_.end());
    for (ElementGroup& group : groups_) {
        for (Index& element : group.elements)
            element += first;
        mesh.groups.push_back(std::move(group));
    }
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
    for (const Block& block : blocks_read_) {
        in.seek(block.lines.start);
        for (std::size_t i = 0; i < static_cast<std::size_t>(block.lines.count); ++i, in.skip_line()) {
            in.skip_white();
            Index largest = -1;
            for (std::size_t k = corner_count_of(in, block, i); k > 0; --k)
                largest = std::max(largest, in.index("a vertex"));
            if (largest >= vertices)
                fail_su2_vertex(in, element_of(block.name, i), largest, vertices);
        }
    }
}

} // namespace morph
