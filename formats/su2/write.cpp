#include "formats/su2/write.h"

#include "formats/mesh/cell_types.h"
#include "formats/su2/groups.h"
#include "formats/text/number_text.h"
#include "formats/text/text_scanner.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cstdlib>

namespace morph {

namespace {

void append_count(OutputFile& out, std::string_view key, std::size_t count)
{
    out.append(std::string(key) + "= " + std::to_string(count) + "\n");
}

/// Carried text that starts with this key, or null.
const OpaqueSection* carried_section(const MeshData& data, std::string_view key)
{
    const auto found =
        std::find_if(data.sections.begin(), data.sections.end(), [&](const OpaqueSection& carried) {
            return carried.format == "su2" && carried.text.starts_with(key);
        });
    return found == data.sections.end() ? nullptr : &*found;
}

/// The number after the '=' of a carried line such as "NPOIN= 16009 15715".
std::size_t carried_count(const std::string& line)
{
    return std::strtoull(line.c_str() + line.find('=') + 1, nullptr, 10);
}

/// "NPOIN= 16009", or the line of the file with its further numbers when the count is still the same.
void append_header(const MeshData& data, OutputFile& out, std::string_view key, std::size_t count)
{
    const OpaqueSection* const carried = carried_section(data, key);
    if (carried && carried_count(carried->text) == count)
        out.append(carried->text);
    else
        append_count(out, key, count);
}

void append_elements(const MeshData& data, OutputFile& out)
{
    append_header(data, out, "NELEM", data.elements.size());
    for (std::size_t i = 0; i < data.elements.size(); ++i) {
        const Element& element = data.elements[i];
        const std::size_t corners = element[3] < 0 ? 3 : 4;
        char* to = out.room(6 * kLongestNumber);
        to = number_text(to, corners == 3 ? kTriangleCell : kQuadCell, '\t');
        for (std::size_t k = 0; k < corners; ++k)
            to = number_text(to, element[k], '\t');
        out.advance_to(number_text(to, i, '\n'));
    }
}

void append_points(const MeshData& data, OutputFile& out)
{
    append_header(data, out, "NPOIN", static_cast<std::size_t>(data.points.rows()));
    for (Eigen::Index i = 0; i < data.points.rows(); ++i) {
        char* to = out.room(4 * kLongestNumber);
        for (int k = 0; k < data.dimension; ++k)
            to = number_text(to, data.points(i, k), '\t');
        out.advance_to(number_text(to, i, '\n'));
    }
}

void require_legible(const Marker& marker, const OutputFile& out)
{
    const std::string& name = marker.name;
    const bool outer_blanks = name.empty() || name.front() <= ' ' || name.back() <= ' ';
    if (outer_blanks || name.find_first_of("%\r\n") != std::string::npos || name == "SEND_RECEIVE")
        throw InputError(out.path() + ": su2 cannot hold a marker of the name '" + name + "'; rename it");
}

void append_marker(const Marker& marker, OutputFile& out)
{
    require_legible(marker, out);
    out.append("MARKER_TAG= " + marker.name + "\n");
    append_count(out, "MARKER_ELEMS", marker.edges.size());
    for (const auto& [from, to_vertex] : marker.edges) {
        char* to = out.room(3 * kLongestNumber);
        to = number_text(to, kEdgeCell, '\t');
        to = number_text(to, from, '\t');
        out.advance_to(number_text(to, to_vertex, '\n'));
    }
}

bool is_header(const OpaqueSection& carried)
{
    return carried.text.starts_with("NELEM") || carried.text.starts_with("NPOIN");
}

/// How many markers there are in a carried text: SU2 reads as many as NMARK says.
std::size_t marker_count(const OpaqueSection& carried)
{
    std::size_t count = 0;
    TextScanner in("", carried.text, '%');
    for (; carried.format == "su2" && in.skip_white(); in.skip_line())
        count += in.rest().starts_with("MARKER_TAG") ? 1 : 0;
    return count;
}

void append_markers(const MeshData& data, OutputFile& out)
{
    std::size_t count = data.markers.size();
    for (const OpaqueSection& carried : data.sections)
        count += marker_count(carried);
    append_count(out, "NMARK", count);
    for (const Marker& marker : data.markers)
        append_marker(marker, out);
}

/// Markers among the carried text first: SU2 looks for all markers right behind NMARK.
void append_carried(const MeshData& data, OutputFile& out)
{
    for (const bool markers : {true, false})
        for (const OpaqueSection& carried : data.sections)
            if (carried.format == "su2" && !is_header(carried) && (marker_count(carried) > 0) == markers)
                out.append(carried.text);
}

} // namespace

void write_su2(const MeshData& data, const WriteOptions&, OutputFile& out)
{
    append_count(out, "NDIME", static_cast<std::size_t>(data.dimension));
    append_elements(data, out);
    append_points(data, out);
    append_su2_groups(data.groups, out); // SU2 wants nothing between NMARK and the markers
    append_markers(data, out);
    append_carried(data, out);
}

} // namespace morph
