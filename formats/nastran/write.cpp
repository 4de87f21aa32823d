#include "formats/nastran/write.h"

#include "formats/mesh/element_groups.h"
#include "formats/text/names_in_text.h"
#include "formats/text/number_text.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace morph {

namespace {

constexpr std::size_t kLarge = 16;
constexpr std::size_t kSmall = 8;
constexpr std::int64_t kLargestSmall = 99999999;
constexpr Index kUngrouped = 1; // property of elements in no group; groups and then markers follow

/// As Nastran writes it: with a point, no 'e' and no needless zeros.
std::size_t to_nastran(char* to, std::string_view number)
{
    char* end = to;
    std::string_view mantissa = number.substr(0, number.find('e'));
    std::string_view exponent = number.substr(std::min(mantissa.size() + 1, number.size()));
    if (mantissa.starts_with('-')) {
        *end++ = '-';
        mantissa.remove_prefix(1);
    }
    if (mantissa.size() > 2 && mantissa.starts_with("0."))
        mantissa.remove_prefix(1);
    end = std::copy(mantissa.begin(), mantissa.end(), end);
    if (mantissa.find('.') == std::string_view::npos)
        *end++ = '.';
    if (!exponent.empty()) {
        *end++ = exponent[0];
        exponent.remove_prefix(1);
        while (exponent.size() > 1 && exponent[0] == '0')
            exponent.remove_prefix(1);
        end = std::copy(exponent.begin(), exponent.end(), end);
    }
    return static_cast<std::size_t>(end - to);
}

/// Property of each element: that of the first group that has it.
std::vector<Index> properties_of(const MeshData& mesh)
{
    std::vector<std::vector<Index>> columns = group_columns(mesh);
    if (columns.empty())
        return std::vector<Index>(mesh.elements.size(), kUngrouped);
    for (Index& group : columns.front())
        group += kUngrouped; // 0: none
    return std::move(columns.front());
}

/// A number in a field of that width, right-aligned.
char* put_right(char* to, std::int64_t number, std::size_t width)
{
    std::array<char, kLongestNumber> text{};
    const auto length = static_cast<std::size_t>(number_text(text.data(), number) - text.data());
    std::memset(to, ' ', width - length);
    std::memcpy(to + width - length, text.data(), length);
    return to + width;
}

void append_card(OutputFile& out, std::string_view name, const std::array<std::int64_t, 6>& fields,
                 std::size_t count)
{
    const bool large = *std::max_element(fields.begin(), fields.end()) > kLargestSmall;
    const std::size_t width = large ? kLarge : kSmall;
    char* to = out.room(kSmall * 2 + kLarge * 6 + 3);
    to = std::copy(name.begin(), name.end(), to);
    if (large)
        *to++ = '*';
    to = std::fill_n(to, kSmall - name.size() - (large ? 1 : 0), ' ');
    for (std::size_t i = 0; i < count; ++i) {
        if (large && i == 4)
            to = std::copy_n("\n*       ", 9, to);
        to = put_right(to, fields[i], width);
    }
    *to++ = '\n';
    out.advance_to(to);
}

void append_point(OutputFile& out, const Points& points, Eigen::Index v)
{
    char* to = out.room(7 * kLarge);
    to = std::copy_n("GRID*   ", kSmall, to);
    to = put_right(to, v + 1, kLarge);
    to = std::fill_n(to, kLarge, ' '); // the basic coordinate system
    bool exact = put_nastran_real(to, points(v, 0));
    exact = put_nastran_real(to + kLarge, points(v, 1)) && exact;
    to = std::copy_n("\n*       ", 9, to + 2 * kLarge);
    exact = put_nastran_real(to, points(v, 2)) && exact;
    to[kLarge] = '\n';
    out.advance_to(to + kLarge + 1);
    if (exact)
        return;
    out.append("$ exact ");
    to = number_text(out.room(4 * kLongestNumber), v + 1, ' ');
    for (int k = 0; k < 3; ++k)
        to = number_text(to, points(v, k), k < 2 ? ' ' : '\n');
    out.advance_to(to);
}

void append_names(const MeshData& mesh, OutputFile& out)
{
    Index property = kUngrouped;
    out.append("$ ungrouped " + std::to_string(property++) + "\n");
    for (const ElementGroup& group : mesh.groups)
        out.append("$ group " + std::to_string(property++) + " " + line_name(group.name) + "\n");
    for (const Marker& marker : mesh.markers)
        out.append("$ marker " + std::to_string(property++) + " " + line_name(marker.name) + "\n");
}

} // namespace

bool put_nastran_real(char* to, double value)
{
    std::array<char, 2 * kLongestNumber> text{};
    std::array<char, kLongestNumber> number{};
    const auto fill = [&](const char* end) {
        return to_nastran(text.data(), {number.data(), static_cast<std::size_t>(end - number.data())});
    };
    std::size_t length = fill(number_text(number.data(), value));
    const bool exact = length <= kLarge;
    for (int digits = 15; length > kLarge; --digits)
        length = fill(std::to_chars(number.data(), number.data() + number.size(), value,
                                    std::chars_format::general, digits)
                          .ptr);
    std::memset(to, ' ', kLarge - length);
    std::memcpy(to + kLarge - length, text.data(), length);
    return exact;
}

void write_nastran(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    out.append("CEND\nBEGIN BULK\n");
    append_names(mesh, out);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        append_point(out, mesh.points, v);
    const std::vector<Index> properties = properties_of(mesh);
    std::int64_t id = 0;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const Element& c = mesh.elements[e];
        append_card(out, c[3] < 0 ? "CTRIA3" : "CQUAD4",
                    {++id, properties[e], std::int64_t{c[0]} + 1, std::int64_t{c[1]} + 1,
                     std::int64_t{c[2]} + 1, std::int64_t{c[3]} + 1},
                    c[3] < 0 ? 5 : 6);
    }
    auto property = static_cast<std::int64_t>(mesh.groups.size()) + kUngrouped;
    for (const Marker& marker : mesh.markers) {
        ++property;
        for (const auto& [from, to] : marker.edges)
            append_card(out, "CROD", {++id, property, std::int64_t{from} + 1, std::int64_t{to} + 1, 0, 0}, 4);
    }
    out.append("ENDDATA\n");
}

} // namespace morph
