#include "libmorph/mesh/edits.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/mesh/merge_vertices.h"
#include "libmorph/mesh/triangulate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace morph {

namespace {

/// Names of the markers, then of the groups.
std::vector<std::string*> part_names(MeshData& mesh)
{
    std::vector<std::string*> names;
    for (Marker& marker : mesh.markers)
        names.push_back(&marker.name);
    for (ElementGroup& group : mesh.groups)
        names.push_back(&group.name);
    return names;
}

std::vector<std::string> copies(const std::vector<std::string*>& names)
{
    std::vector<std::string> result;
    result.reserve(names.size());
    for (const std::string* name : names)
        result.push_back(*name);
    return result;
}

/// All renames at once, so that two names can be exchanged.
void rename_parts(const std::vector<Rename>& renames, MeshData& mesh)
{
    const std::vector<std::string*> names = part_names(mesh);
    const std::vector<std::string> old_names = copies(names);
    for (const auto& [from, to] : renames) {
        const auto found = std::find(old_names.begin(), old_names.end(), from);
        if (found == old_names.end())
            throw InputError("has no marker or group '" + from + "' to rename, but " +
                             (old_names.empty() ? "none at all" : joined(old_names)) +
                             did_you_mean(from, old_names));
        *names[static_cast<std::size_t>(found - old_names.begin())] = to;
    }
    std::vector<std::string> markers;
    for (const Marker& marker : mesh.markers)
        markers.push_back(marker.name);
    std::sort(markers.begin(), markers.end());
    const auto twice = std::adjacent_find(markers.begin(), markers.end());
    if (!renames.empty() && twice != markers.end())
        throw InputError("would have two markers '" + *twice + "' after renaming");
}

void drop_fields(const Edits& edits, MeshData& mesh)
{
    if (edits.drop_all_fields)
        mesh.fields.clear();
    std::vector<std::string> names;
    for (const Field& field : mesh.fields)
        names.push_back(field.name);
    for (const std::string& name : edits.drop_fields)
        if (std::erase_if(mesh.fields, [&](const Field& field) { return field.name == name; }) == 0)
            throw InputError("has no field '" + name + "' to drop, but " +
                             (names.empty() ? "none at all" : joined(names)) + did_you_mean(name, names));
}

std::vector<std::string> merge(double tolerance, MeshData& mesh)
{
    std::vector<std::string> warnings;
    if (!(tolerance > 0))
        return warnings;
    const Merged merged = merge_vertices(mesh, tolerance);
    const std::string within = " within the merge tolerance of " + number_text(tolerance);
    if (merged.elements > 0)
        warnings.push_back(std::to_string(merged.elements) + " element(s) lay" + within +
                           " and were left out");
    if (merged.edges > 0)
        warnings.push_back(std::to_string(merged.edges) + " marker edge(s) lay" + within +
                           " and were left out");
    return warnings;
}

/// Cosine and sine, exact at quarter turns so that a mesh turned by 90 degrees stays planar and aligned.
std::array<double, 2> direction(double degrees)
{
    const double quarters = degrees / 90;
    if (quarters == std::floor(quarters)) {
        constexpr std::array<std::array<double, 2>, 4> exact{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        return exact.at(static_cast<std::size_t>(quarters - 4 * std::floor(quarters / 4)));
    }
    const double angle = degrees * std::numbers::pi / 180;
    return {std::cos(angle), std::sin(angle)};
}

} // namespace

Eigen::Matrix3d rotation(int axis, double degrees)
{
    const auto [cosine, sine] = direction(degrees);
    const int first = (axis + 1) % 3;
    const int second = (axis + 2) % 3;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn(first, first) = turn(second, second) = cosine;
    turn(second, first) = sine;
    turn(first, second) = -sine;
    return turn;
}

void apply_transform(const Transform& transform, MeshData& mesh)
{
    mesh.points = ((mesh.points * transform.linear.transpose()).rowwise() + transform.shift).eval();
    mesh.dimension = dimension_of(mesh.points);
}

std::vector<std::string> apply_edits(const Edits& edits, MeshData& mesh)
{
    rename_parts(edits.renames, mesh);
    drop_fields(edits, mesh);
    std::vector<std::string> warnings = merge(edits.merge_tolerance, mesh);
    if (edits.transform)
        apply_transform(*edits.transform, mesh);
    if (edits.triangulate)
        mesh = triangulated(std::move(mesh));
    return warnings;
}

} // namespace morph
