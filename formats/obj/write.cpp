#include "formats/mesh/element_groups.h"
#include "formats/obj/files.h"
#include "formats/text/names_in_text.h"
#include "formats/text/number_text.h"
#include "formats/text/surface_text.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <set>

namespace morph {

namespace {

bool is_color(const Field& field)
{
    return field.name == kObjColor && field.location == FieldLocation::vertex && field.values.cols() == 3;
}

void append_vertices(const MeshData& mesh, OutputFile& out)
{
    const auto color = std::find_if(mesh.fields.begin(), mesh.fields.end(), is_color);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
        char* to = out.room(8 * kLongestNumber);
        to = std::copy_n("v ", 2, to);
        for (int k = 0; k < 3; ++k)
            to = number_text(to, mesh.points(v, k), ' ');
        for (int k = 0; k < 3 && color != mesh.fields.end(); ++k)
            to = number_text(to, color->values(v, k), ' ');
        to[-1] = '\n';
        out.advance_to(to);
    }
}

/// A name of a `g` statement: one word.
std::string group_word(const std::string& name)
{
    return name.empty() ? "%" : line_name(name, " #\\");
}

/// `g` with the names of the groups that element @p e is in; without any, the end of those before.
void append_groups(const MeshData& mesh, const std::vector<std::vector<Index>>& columns, std::size_t e,
                   OutputFile& out)
{
    std::string line = "g";
    for (std::size_t k = 0; k < std::min(columns.size(), kMostObjGroups); ++k)
        if (columns[k][e] > 0)
            line += " " + group_word(mesh.groups[static_cast<std::size_t>(columns[k][e]) - 1].name);
    out.append(line + "\n");
}

void append_faces(const MeshData& mesh, OutputFile& out)
{
    const std::vector<std::vector<Index>> columns = group_columns(mesh);
    const auto is_other_group = [&](std::size_t e) {
        return std::any_of(columns.begin(), columns.end(), [&](const std::vector<Index>& column) {
            return e == 0 ? column[e] > 0 : column[e] != column[e - 1];
        });
    };
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        if (is_other_group(e))
            append_groups(mesh, columns, e, out);
        out.append("f ");
        append_corners(out, mesh.elements[e], 1);
    }
}

void append_lines(const Marker& marker, OutputFile& out)
{
    out.append("g " + group_word(marker.name) + "\n");
    for (const auto& [from, to_vertex] : marker.edges) {
        char* to = out.room(3 * kLongestNumber);
        to = std::copy_n("l ", 2, to);
        to = number_text(to, from + 1, ' ');
        out.advance_to(number_text(to, to_vertex + 1, '\n'));
    }
}

/// Names that would be one when read, and things that would not be there at all.
void add_name_losses(const std::string& what, const auto& named, const auto& is_empty,
                     std::vector<std::string>& lost)
{
    std::set<std::string> seen;
    for (const auto& one : named) {
        if (is_empty(one))
            lost.push_back("the " + what + " '" + one.name + "', which is empty");
        else if (!seen.insert(one.name).second)
            lost.push_back("two " + what + "s of the name '" + one.name + "' apart");
    }
}

} // namespace

void write_obj(const MeshData& mesh, const WriteOptions&, OutputFile& out)
{
    append_vertices(mesh, out);
    append_faces(mesh, out);
    for (const Marker& marker : mesh.markers)
        append_lines(marker, out);
}

std::vector<std::string> obj_losses(const MeshData& mesh, const WriteOptions&)
{
    std::vector<std::string> lost;
    std::vector<std::string> fields;
    for (const Field& field : mesh.fields)
        if (field.location == FieldLocation::vertex && !is_color(field))
            fields.push_back(field.name);
    if (!fields.empty())
        lost.push_back(std::to_string(fields.size()) + " nodal field(s) " + joined(fields) +
                       ", only one of 3 components called color");
    if (group_columns(mesh).size() > kMostObjGroups)
        lost.push_back("more than " + std::to_string(kMostObjGroups) + " groups of an element");
    add_name_losses(
        "marker", mesh.markers, [](const Marker& marker) { return marker.edges.empty(); }, lost);
    add_name_losses(
        "group", mesh.groups, [](const ElementGroup& group) { return group.elements.empty(); }, lost);
    return lost;
}

} // namespace morph
