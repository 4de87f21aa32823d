#include "formats/su2_read.h"

#include "formats/cell_types.h"
#include "formats/su2_carried.h"
#include "formats/su2_markers.h"
#include "formats/su2_sections.h"
#include "formats/su2_vertex_ids.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <optional>

namespace morph {

namespace {

constexpr std::size_t kShortestElement = 8; // "5 0 1 2\n"
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
    void read_points();
    void read_point(std::size_t i);

    void check_sections() const;
    void check_element_vertices();
    void sort_points();

    TextScanner in_;
    MeshData data_;
    std::size_t dimension_key_ = 0;
    std::optional<Su2Section> elements_;
    std::optional<Su2Section> points_;
    std::optional<Su2Section> marker_count_;
    Index largest_vertex_ = -1; ///< that an element names
    Su2VertexIds ids_;
    Su2CarriedSections carried_;
    Su2Markers markers_{carried_};
};

MeshData Su2Reader::read()
{
    read_dimension();
    while (in_.skip_white())
        read_section();
    check_sections();
    check_element_vertices();
    markers_.check_vertices(in_, points_->count);
    sort_points();
    data_.markers = markers_.take();
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
        markers_.read(in_, start);
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

/// Read the count behind a key; a line with further numbers is carried.
void Su2Reader::begin(std::optional<Su2Section>& section, std::string_view name, std::size_t key)
{
    if (section)
        in_.fail(std::string(name) + "= is given again, after line " +
                 std::to_string(in_.line_of(section->key)));
    section = read_su2_section(in_, name, key);
    in_.seek(key);
    const std::string_view line = in_.rest_of_line();
    if (line.find_first_of(" \t", line.find_first_of("0123456789")) != std::string_view::npos)
        carried_.add_header(line);
    in_.seek(section->start);
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
        largest_vertex_ = std::max(largest_vertex_, element[k]);
    }
    if (!end_su2_line(in_))
        in_.fail_expected("a number or the end of the line after element " + std::to_string(i));
    return element;
}

void Su2Reader::read_points()
{
    const std::size_t room = su2_room(in_, *points_, kShortestPoint);
    data_.points.resize(static_cast<Eigen::Index>(room), 3);
    for (std::size_t i = 0; i < room; ++i) {
        in_.skip_white();
        read_point(i);
    }
    if (room < static_cast<std::size_t>(points_->count))
        fail_su2_short(in_, *points_, room, "the end of the file");
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

void Su2Reader::check_sections() const
{
    if (!elements_ || !points_)
        throw InputError(in_.path() + (elements_ ? ": NPOIN= is missing" : ": NELEM= is missing"));
    const std::string found = ", but the file has " + std::to_string(markers_.blocks()) + " marker(s)";
    if (marker_count_ && marker_count_->count != markers_.blocks())
        in_.fail_at(marker_count_->key, "NMARK= " + std::to_string(marker_count_->count) + found);
    if (!marker_count_ && markers_.blocks() > 0)
        throw InputError(in_.path() + ": NMARK= is missing" + found);
}

/// The vertices may stand behind the elements, so that this waits until all is read.
void Su2Reader::check_element_vertices()
{
    if (largest_vertex_ < points_->count)
        return;
    for (std::size_t i = 0; i < data_.elements.size(); ++i) {
        const Element& element = data_.elements[i];
        const Index largest = *std::max_element(element.begin(), element.end());
        if (largest < points_->count)
            continue;
        seek_su2_line(in_, elements_->start, i);
        fail_su2_vertex(in_, "element " + std::to_string(i), largest, points_->count);
    }
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
