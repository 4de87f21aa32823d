#include "formats/mesh/element_groups.h"
#include "formats/stl/files.h"
#include "formats/text/names_in_text.h"
#include "formats/text/number_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <limits>

namespace morph {

namespace {

using Triangle = std::array<Index, 3>;

/// Calls visit(triangle, element): triangles as they are, quads cut along the shorter diagonal.
template <class Visit>
void for_each_triangle(const MeshData& mesh, const Visit& visit)
{
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto& [a, b, c, d] = mesh.elements[e];
        if (d < 0) {
            visit(Triangle{a, b, c}, e);
            continue;
        }
        const double first = (mesh.points.row(a) - mesh.points.row(c)).norm();
        const double second = (mesh.points.row(b) - mesh.points.row(d)).norm();
        visit(first <= second ? Triangle{a, b, c} : Triangle{a, b, d}, e);
        visit(first <= second ? Triangle{a, c, d} : Triangle{b, c, d}, e);
    }
}

Eigen::RowVector3d normal_of(const MeshData& mesh, const Triangle& triangle)
{
    const Eigen::RowVector3d u = mesh.points.row(triangle[1]) - mesh.points.row(triangle[0]);
    const Eigen::RowVector3d v = mesh.points.row(triangle[2]) - mesh.points.row(triangle[0]);
    const Eigen::RowVector3d normal = u.normalized().cross(v.normalized()).normalized();
    return normal.allFinite() ? normal : Eigen::RowVector3d::Zero();
}

/// "solid NAME", or of the elements of no group "solid" alone.
void append_solid(OutputFile& out, std::string_view keyword, const MeshData& mesh, Index group)
{
    out.append(keyword);
    if (group > 0)
        out.append(" " + line_name(mesh.groups[static_cast<std::size_t>(group) - 1].name));
    out.append("\n");
}

/// In single precision, since it only repeats what the corners say.
void append_normal(OutputFile& out, const Eigen::RowVector3d& normal)
{
    char* to = out.room(3 * kLongestNumber);
    for (int k = 0; k < 3; ++k) {
        to = std::to_chars(to, to + kLongestNumber, static_cast<float>(normal(k))).ptr;
        *to++ = k < 2 ? ' ' : '\n';
    }
    out.advance_to(to);
}

void append_facet(OutputFile& out, const MeshData& mesh, const Triangle& triangle)
{
    out.append("facet normal ");
    append_normal(out, normal_of(mesh, triangle));
    out.append("outer loop\n");
    for (const Index v : triangle) {
        out.append("vertex ");
        append_point(out, mesh.points, v);
    }
    out.append("endloop\nendfacet\n");
}

void write_ascii(const MeshData& mesh, OutputFile& out)
{
    const std::vector<std::vector<Index>> columns = group_columns(mesh);
    const auto group_of = [&](std::size_t element) { return columns.empty() ? 0 : columns[0][element]; };
    Index open = mesh.elements.empty() ? 0 : group_of(0);
    append_solid(out, "solid", mesh, open);
    for_each_triangle(mesh, [&](const Triangle& triangle, std::size_t element) {
        if (group_of(element) != open) {
            append_solid(out, "endsolid", mesh, open);
            open = group_of(element);
            append_solid(out, "solid", mesh, open);
        }
        append_facet(out, mesh, triangle);
    });
    append_solid(out, "endsolid", mesh, open);
}

char* put_little_endian(char* to, auto value)
{
    auto raw = std::bit_cast<std::array<char, sizeof value>>(value);
    if (std::endian::native != std::endian::little)
        std::reverse(raw.begin(), raw.end());
    return std::copy(raw.begin(), raw.end(), to);
}

char* put_point(char* to, const auto& point)
{
    for (int k = 0; k < 3; ++k)
        to = put_little_endian(to, static_cast<float>(point(k)));
    return to;
}

std::size_t triangle_count(const MeshData& mesh)
{
    std::size_t count = 0;
    for (const Element& element : mesh.elements)
        count += static_cast<std::size_t>(corner_count(element)) - 2;
    return count;
}

void write_binary(const MeshData& mesh, OutputFile& out)
{
    constexpr std::size_t facet_bytes = 50;
    out.append(std::string(80, ' '));
    out.advance_to(put_little_endian(out.room(4), static_cast<std::uint32_t>(triangle_count(mesh))));
    for_each_triangle(mesh, [&](const Triangle& triangle, std::size_t) {
        char* to = put_point(out.room(facet_bytes), normal_of(mesh, triangle));
        for (const Index v : triangle)
            to = put_point(to, mesh.points.row(v));
        out.advance_to(put_little_endian(to, std::uint16_t{0}));
    });
}

void require_single_precision_range(const MeshData& mesh, const OutputFile& out)
{
    constexpr double largest = std::numeric_limits<float>::max();
    if (mesh.points.size() > 0 && mesh.points.cwiseAbs().maxCoeff() > largest)
        throw InputError(out.path() + ": a coordinate is larger than binary STL can hold; write it as text");
}

/// Reading numbers the vertices in the order in which the triangles first name them.
bool is_order_kept(const MeshData& mesh)
{
    Index seen = 0;
    bool kept = true;
    for_each_triangle(mesh, [&](const Triangle& triangle, std::size_t) {
        for (const Index v : triangle) {
            kept = kept && v <= seen;
            seen = std::max(seen, v + 1);
        }
    });
    return kept && seen == mesh.points.rows();
}

std::vector<std::string> group_losses(const MeshData& mesh, bool binary)
{
    if (binary && !mesh.groups.empty()) {
        std::vector<std::string> names;
        for (const ElementGroup& group : mesh.groups)
            names.push_back(group.name);
        return {std::to_string(names.size()) + " group(s) of elements " + joined(names) +
                " in its binary form; write it as text"};
    }
    std::vector<std::string> lost = overlap_losses(mesh);
    for (const ElementGroup& group : mesh.groups) {
        if (group.name.empty())
            lost.emplace_back("a group without a name");
        if (group.elements.empty())
            lost.push_back("the group '" + group.name + "', which has no elements");
    }
    return lost;
}

} // namespace

void write_stl(const MeshData& mesh, const WriteOptions& options, OutputFile& out)
{
    if (!options.binary)
        return write_ascii(mesh, out);
    require_single_precision_range(mesh, out);
    write_binary(mesh, out);
}

std::vector<std::string> stl_losses(const MeshData& mesh, const WriteOptions& options)
{
    std::vector<std::string> lost = group_losses(mesh, options.binary);
    const auto quads = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                     [](const Element& element) { return corner_count(element) == 4; });
    if (quads > 0)
        lost.push_back("quads: " + std::to_string(quads) + " are cut into triangles");
    if (!is_order_kept(mesh))
        lost.emplace_back(
            "the numbers of vertices: they are renumbered when read, without those of no element");
    if (options.binary && mesh.points != mesh.points.cast<float>().cast<double>())
        lost.emplace_back("double precision in its binary form: coordinates are rounded; write it as text");
    return lost;
}

} // namespace morph
