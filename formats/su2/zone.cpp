#include "formats/su2/zone.h"

#include "formats/mesh/cell_types.h"
#include "formats/su2/groups.h"
#include "formats/su2/markers.h"
#include "formats/su2/opaque_sections.h"
#include "formats/su2/sections.h"
#include "formats/su2/vertex_ids.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <array>
#include <optional>

namespace morph {

namespace {

constexpr std::size_t kShortestElement = 8; // "5 0 1 2\n"
constexpr std::size_t kShortestPoint = 4;   // "0 0\n"

std::optional<VolumeShape> volume_shape(Index type)
{
    switch (type) {
    case 10:
        return VolumeShape::tetrahedron;
    case 12:
        return VolumeShape::hexahedron;
    case 13:
        return VolumeShape::prism;
    case 14:
        return VolumeShape::pyramid;
    default:
        return std::nullopt;
    }
}

class Su2Reader {
public:
    Su2Reader(const std::string& path, std::string_view text, std::size_t begin)
        : in_(path, text, '%'), begin_(begin)
    {
    }
    VolumeFile read();

private:
    void read_dimension();
    void read_section();
    bool read_counted(std::string_view key, std::size_t start);
    void begin(std::optional<Su2Section>& section, std::string_view name, std::size_t key);
    void skip_zone_header(std::string_view key);
    void read_elements();
    void read_element(std::size_t i);
    std::array<Index, 8> read_corners(std::size_t i, Index type, std::size_t count);
    void read_points();
    void read_point(std::size_t i);

    void check_sections() const;
    void check_element_vertices();
    void sort_points();

    TextScanner in_;
    std::size_t begin_;
    VolumeFile file_;
    MeshData& data_ = file_.mesh;
    std::size_t dimension_key_ = 0;
    std::optional<Su2Section> elements_;
    std::optional<Su2Section> points_;
    std::optional<Su2Section> marker_count_;
    Index largest_vertex_ = -1; ///< that an element names
    Su2VertexIds ids_;
    Su2OpaqueSections carried_;
    Su2Markers markers_{carried_};
    Su2Groups groups_;
};

VolumeFile Su2Reader::read()
{
    read_dimension();
    markers_.set_dimension(data_.dimension);
    while (groups_.skip_to_section(in_))
        read_section();
    check_sections();
    check_element_vertices();
    markers_.check_vertices(in_, points_->count);
    markers_.check_faces(in_, !file_.cells.empty());
    groups_.check_elements(in_, data_.elements.size());
    sort_points();
    data_.groups = groups_.take();
    data_.markers = markers_.take();
    markers_.move_faces_to(data_);
    data_.sections = carried_.texts();
    return std::move(file_);
}

void Su2Reader::read_dimension()
{
    dimension_key_ = find_su2_dimension(in_, begin_);
    const std::int64_t dimension = in_.integer("2 or 3 after NDIME=");
    if (dimension != 2 && dimension != 3)
        in_.fail("NDIME= " + std::to_string(dimension) + ", expected 2 or 3");
    in_.end_line("NDIME= " + std::to_string(dimension));
    data_.dimension = static_cast<int>(dimension);
    in_.seek(begin_);
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
    else if (key == "NZONE" || key == "IZONE")
        skip_zone_header(key);
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

/// Of a file with a single zone; those of several are cut off before.
void Su2Reader::skip_zone_header(std::string_view key)
{
    const std::string name(key);
    const std::int64_t number = in_.integer("a number after " + name + "=");
    if (number != 1)
        in_.fail(name + "= " + std::to_string(number) +
                 ", but no NZONE= above NDIME= says that the file has zones");
    in_.end_line(name + "= 1");
}

void Su2Reader::read_elements()
{
    data_.elements.reserve(su2_room(in_, *elements_, kShortestElement));
    for (std::size_t i = 0; i < static_cast<std::size_t>(elements_->count); ++i) {
        in_.skip_white();
        read_element(i);
    }
}

void Su2Reader::read_element(std::size_t i)
{
    Index type = 0;
    if (!in_.try_index(type))
        fail_su2_short(in_, *elements_, i, "the type of element " + std::to_string(i));
    if (type == kTriangleCell || type == kQuadCell) {
        const auto corners = read_corners(i, type, type == kTriangleCell ? 3 : 4);
        data_.elements.push_back(
            {corners[0], corners[1], corners[2], type == kTriangleCell ? -1 : corners[3]});
    } else if (const auto shape = volume_shape(type); shape && data_.dimension == 3) {
        file_.cells.push_back(
            {*shape, read_corners(i, type, static_cast<std::size_t>(corner_count(*shape)))});
    } else {
        const std::string volumes =
            ", tetrahedra (type 10), hexahedra (type 12), prisms (type 13) and pyramids (type 14)";
        in_.fail(
            "element " + std::to_string(i) + " is " + cell_type_name(type) + "; supported are triangles " +
            (data_.dimension == 2 ? "(type 5) and quads (type 9)" : "(type 5), quads (type 9)" + volumes));
    }
    if (!end_su2_line(in_))
        in_.fail_expected("a number or the end of the line after element " + std::to_string(i));
}

std::array<Index, 8> Su2Reader::read_corners(std::size_t i, Index type, std::size_t count)
{
    std::array<Index, 8> corners{};
    for (std::size_t k = 0; k < count; ++k) {
        if (!in_.try_index(corners[k]))
            in_.fail_expected("vertex " + std::to_string(k + 1) + " of " + cell_type_name(type) +
                              ", element " + std::to_string(i));
        largest_vertex_ = std::max(largest_vertex_, corners[k]);
    }
    return corners;
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
    in_.seek(elements_->start);
    for (std::size_t i = 0; i < static_cast<std::size_t>(elements_->count); ++i, in_.skip_line()) {
        in_.skip_white();
        const Index type = in_.index("a type");
        const auto shape = volume_shape(type);
        const int corners = shape ? corner_count(*shape) : type == kTriangleCell ? 3 : 4;
        for (int k = 0; k < corners; ++k)
            if (const Index vertex = in_.index("a vertex"); vertex >= points_->count)
                fail_su2_vertex(in_, "element " + std::to_string(i), vertex, points_->count);
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

VolumeFile read_su2_zone(const std::string& path, std::string_view text, std::size_t begin)
{
    return Su2Reader(path, text, begin).read();
}

} // namespace morph
