#include "formats/su2_read.h"

#include "formats/cell_types.h"
#include "formats/su2_carried.h"
#include "formats/su2_sections.h"
#include "formats/su2_vertex_ids.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <optional>
#include <unordered_map>

namespace morph {

namespace {

constexpr std::size_t kShortestElement = 8; // "5 0 1 2\n"
constexpr std::size_t kShortestEdge = 6;    // "3 0 1\n"
constexpr std::size_t kShortestPoint = 4;   // "0 0\n"

class Su2Reader {
public:
    explicit Su2Reader(const InputBytes& input) : in_(input.path, input.bytes, '%') {}
    MeshData read();

private:
    void read_dimension();
    void read_section();
    bool read_counted(std::string_view key, std::size_t start);
    void begin(std::optional<Su2Section>& section, std::string_view name, std::size_t key);
    void read_one_zone();

    void read_elements();
    Element read_element(std::size_t i);
    void finish_line(const std::string& what);
    void read_points();
    void read_point(std::size_t i);

    void read_marker(std::size_t start);
    void read_marker_lines(const std::string& name, const Su2Section& section);
    bool read_marker_line(const Su2Section& section, std::size_t i, std::vector<std::array<Index, 2>>& edges);
    Marker& marker_called(const std::string& name);

    void check_sections();
    void check_element_vertices();
    void check_marker_vertices();
    void sort_points();
    [[noreturn]] void fail_vertex(const std::string& who, Index vertex);

    TextScanner in_;
    MeshData data_;
    std::size_t dimension_key_ = 0;
    std::optional<Su2Section> elements_;
    std::optional<Su2Section> points_;
    std::optional<Su2Section> marker_count_;
    std::vector<Su2Section> markers_; ///< every block of marker edges
    std::unordered_map<std::string, std::size_t> marker_numbers_;
    Index marker_blocks_ = 0;
    Index largest_in_elements_ = -1;
    Index largest_in_markers_ = -1;
    Su2VertexIds ids_;
    Su2CarriedSections carried_;
};

MeshData Su2Reader::read()
{
    read_dimension();
    while (in_.skip_white())
        read_section();
    check_sections();
    check_element_vertices();
    check_marker_vertices();
    sort_points();
    data_.carried = carried_.texts();
    return std::move(data_);
}

void Su2Reader::read_dimension()
{
    dimension_key_ = find_su2_dimension(in_);
    const std::int64_t dimension = in_.integer("2 or 3 after NDIME=");
    if (dimension != 2 && dimension != 3)
        in_.fail("NDIME= " + std::to_string(dimension) + ", expected 2 or 3");
    in_.end_line("NDIME= " + std::to_string(dimension));
    data_.dimension = static_cast<int>(dimension);
    in_.seek(0);
}

void Su2Reader::read_section()
{
    const std::size_t start = in_.position();
    const std::string_view key = try_su2_key(in_);
    if (key.empty())
        in_.fail("expected a section such as NELEM=, found " + in_.found());
    if (read_counted(key, start))
        return;
    if (key == "MARKER_TAG")
        read_marker(start);
    else if (key == "MARKER_ELEMS")
        in_.fail("MARKER_ELEMS= without a MARKER_TAG= before it");
    else if (key == "NZONE")
        read_one_zone();
    else
        carried_.add_section(key, skip_su2_section(in_, start));
}

/// The sections of which a file has one each.
bool Su2Reader::read_counted(std::string_view key, std::size_t start)
{
    if (key == "NDIME") {
        if (start != dimension_key_)
            in_.fail("NDIME= is given again, after line " + std::to_string(in_.line_of(dimension_key_)));
        in_.skip_line();
    } else if (key == "NELEM") {
        begin(elements_, key, start);
        read_elements();
    } else if (key == "NPOIN") {
        begin(points_, key, start);
        read_points();
    } else if (key == "NMARK") {
        begin(marker_count_, key, start);
    } else {
        return false;
    }
    return true;
}

void Su2Reader::begin(std::optional<Su2Section>& section, std::string_view name, std::size_t key)
{
    if (section)
        in_.fail(std::string(name) + "= is given again, after line " +
                 std::to_string(in_.line_of(section->key)));
    section = read_su2_section(in_, name, key);
    in_.seek(key);
    const std::string_view line = in_.rest_of_line();
    in_.seek(section->start);
    if (line.find_first_of(" \t", line.find_first_of("0123456789")) != std::string_view::npos)
        carried_.add_header(line);
}

void Su2Reader::read_one_zone()
{
    const std::int64_t zones = in_.integer("a number of zones after NZONE=");
    if (zones != 1)
        in_.fail("the file has " + std::to_string(zones) + " zones, but one is supported");
    in_.end_line("NZONE= 1");
}

void Su2Reader::read_elements()
{
    data_.elements.reserve(su2_room(in_, *elements_, kShortestElement));
    for (std::size_t i = 0; i < static_cast<std::size_t>(elements_->count); ++i) {
        in_.skip_white();
        data_.elements.push_back(read_element(i));
    }
}

Element Su2Reader::read_element(std::size_t i)
{
    Index type = 0;
    if (!in_.try_index(type))
        fail_su2_short(in_, *elements_, i, "the type of element " + std::to_string(i));
    if (type != kTriangleCell && type != kQuadCell)
        in_.fail("element " + std::to_string(i) + " is " + cell_type_name(type) +
                 "; supported are triangles (type 5) and quads (type 9)");
    Element element{-1, -1, -1, -1};
    for (std::size_t k = 0; k < (type == kTriangleCell ? 3 : 4); ++k) {
        if (!in_.try_index(element[k]))
            in_.fail_expected("vertex " + std::to_string(k + 1) + " of " + cell_type_name(type) +
                              ", element " + std::to_string(i));
        largest_in_elements_ = std::max(largest_in_elements_, element[k]);
    }
    if (Index id = 0; !in_.at_line_end() && !(in_.try_index(id) && in_.at_line_end()))
        finish_line("element " + std::to_string(i));
    return element;
}

/// Numbers that say nothing here may end a line: ids, the parallel and the recursion level.
void Su2Reader::finish_line(const std::string& what)
{
    while (!in_.at_line_end())
        in_.integer("a number or the end of the line after " + what);
}

void Su2Reader::read_points()
{
    data_.points.resize(static_cast<Eigen::Index>(su2_room(in_, *points_, kShortestPoint)), 3);
    const auto room = static_cast<std::size_t>(data_.points.rows());
    for (std::size_t i = 0; i < room; ++i) {
        in_.skip_white();
        read_point(i);
    }
    if (room < static_cast<std::size_t>(points_->count)) {
        in_.skip_white();
        fail_su2_short(in_, *points_, room, "the end of the file");
    }
}

void Su2Reader::read_point(std::size_t i)
{
    double* const row = data_.points.data() + 3 * i;
    if (!in_.try_real(row[0]))
        fail_su2_short(in_, *points_, i, "x of vertex " + std::to_string(i));
    if (!in_.try_real(row[1]))
        in_.fail_expected("y of vertex " + std::to_string(i));
    row[2] = 0;
    if (data_.dimension == 3 && !in_.try_real(row[2]))
        in_.fail_expected("z of vertex " + std::to_string(i));
    ids_.read(in_, static_cast<Index>(i));
}

void Su2Reader::read_marker(std::size_t start)
{
    ++marker_blocks_;
    const std::string name(in_.rest_of_line());
    if (name.empty())
        in_.fail_expected("a name after MARKER_TAG=");
    if (name == "SEND_RECEIVE") {
        carried_.add_marker(skip_su2_section(in_, start, {"MARKER_ELEMS", "SEND_TO", "SEND_RECV"}));
        return;
    }
    in_.skip_white();
    const std::size_t key = in_.position();
    const std::string found = in_.found();
    if (try_su2_key(in_) != "MARKER_ELEMS")
        in_.fail("expected MARKER_ELEMS= after MARKER_TAG= " + name + ", found " + found);
    markers_.push_back(read_su2_section(in_, "MARKER_ELEMS", key));
    read_marker_lines(name, markers_.back());
}

Marker& Su2Reader::marker_called(const std::string& name)
{
    const auto [entry, is_new] = marker_numbers_.try_emplace(name, data_.markers.size());
    if (is_new)
        data_.markers.push_back({name, {}});
    return data_.markers[entry->second];
}

void Su2Reader::read_marker_lines(const std::string& name, const Su2Section& section)
{
    std::vector<std::array<Index, 2>> edges;
    edges.reserve(su2_room(in_, section, kShortestEdge));
    std::string vertices;
    std::size_t vertex_count = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(section.count); ++i) {
        in_.skip_white();
        const std::size_t line = in_.position();
        if (read_marker_line(section, i, edges))
            continue;
        in_.seek(line);
        vertices.append(in_.rest_of_line()).append("\n");
        ++vertex_count;
    }
    if (vertex_count > 0)
        carried_.add_marker_vertices(name, vertex_count, vertices);
    if (vertex_count == 0 || !edges.empty()) {
        std::vector<std::array<Index, 2>>& all = marker_called(name).edges;
        all.insert(all.end(), edges.begin(), edges.end());
    }
}

/// An edge, or false for a line that has only a vertex.
bool Su2Reader::read_marker_line(const Su2Section& section, std::size_t i,
                                 std::vector<std::array<Index, 2>>& edges)
{
    Index type = 0;
    if (!in_.try_index(type))
        fail_su2_short(in_, section, i, "the type of marker element " + std::to_string(i));
    if (type != kEdgeCell && type != kVertexCell)
        in_.fail("marker element " + std::to_string(i) + " is " + cell_type_name(type) +
                 "; supported are edges (type 3)");
    std::array<Index, 2> edge{0, 0};
    for (std::size_t k = 0; k < (type == kEdgeCell ? 2 : 1); ++k) {
        if (!in_.try_index(edge[k]))
            in_.fail_expected("vertex " + std::to_string(k + 1) + " of marker element " + std::to_string(i));
        largest_in_markers_ = std::max(largest_in_markers_, edge[k]);
    }
    finish_line("marker element " + std::to_string(i));
    if (type == kEdgeCell)
        edges.push_back(edge);
    return type == kEdgeCell;
}

void Su2Reader::check_sections()
{
    if (!elements_)
        throw InputError(in_.path() + ": NELEM= is missing");
    if (!points_)
        throw InputError(in_.path() + ": NPOIN= is missing");
    const Index promised = marker_count_ ? marker_count_->count : 0;
    if (promised != marker_blocks_)
        in_.fail_at(marker_count_ ? marker_count_->key : 0, "NMARK= " + std::to_string(promised) +
                                                                ", but the file has " +
                                                                std::to_string(marker_blocks_) + " markers");
}

/// The vertices may stand behind the elements, so that ids can be checked only when all is read.
void Su2Reader::check_element_vertices()
{
    if (largest_in_elements_ < points_->count)
        return;
    for (std::size_t i = 0; i < data_.elements.size(); ++i) {
        const Element& element = data_.elements[i];
        const Index largest = *std::max_element(element.begin(), element.end());
        if (largest < points_->count)
            continue;
        seek_su2_line(in_, elements_->start, i);
        fail_vertex("element " + std::to_string(i), largest);
    }
}

void Su2Reader::check_marker_vertices()
{
    if (largest_in_markers_ < points_->count)
        return;
    for (const Su2Section& section : markers_) {
        in_.seek(section.start);
        for (Index i = 0; i < section.count; ++i, in_.skip_line()) {
            in_.skip_white();
            const std::size_t line = in_.position();
            const Index type = in_.index("a type");
            Index largest = in_.index("a vertex");
            if (type == kEdgeCell)
                largest = std::max(largest, in_.index("a vertex"));
            in_.seek(line);
            if (largest >= points_->count)
                fail_vertex("marker element " + std::to_string(i), largest);
        }
    }
}

void Su2Reader::fail_vertex(const std::string& who, Index vertex)
{
    in_.fail(who + " names vertex " + std::to_string(vertex) + ", but the mesh has " +
             std::to_string(points_->count));
}

void Su2Reader::sort_points()
{
    const std::vector<Index> ids = ids_.permutation(in_, points_->start, points_->count);
    if (ids.empty())
        return;
    Points sorted(data_.points.rows(), 3);
    for (std::size_t i = 0; i < ids.size(); ++i)
        sorted.row(ids[i]) = data_.points.row(static_cast<Eigen::Index>(i));
    data_.points = std::move(sorted);
}

} // namespace

MeshData read_su2(const InputBytes& input)
{
    return Su2Reader(input).read();
}

} // namespace morph
