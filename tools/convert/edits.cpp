#include "tools/convert/edits.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/mesh/merge_vertices.h"
#include "libmorph/mesh/triangulate.h"

#include <algorithm>

namespace morph::tools {

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
void rename_parts(const std::vector<std::string>& renames, MeshData& mesh)
{
    const std::vector<std::string*> names = part_names(mesh);
    const std::vector<std::string> old_names = copies(names);
    for (const std::string& rename : renames) {
        const std::size_t equals = rename.find('=');
        const std::string from = rename.substr(0, equals);
        const auto found = std::find(old_names.begin(), old_names.end(), from);
        if (found == old_names.end())
            throw InputError("has no marker or group '" + from + "' to rename, but " +
                             (old_names.empty() ? "none at all" : joined(old_names)) +
                             did_you_mean(from, old_names));
        *names[static_cast<std::size_t>(found - old_names.begin())] = rename.substr(equals + 1);
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

} // namespace

std::vector<std::string> apply_edits(const Edits& edits, MeshData& mesh)
{
    rename_parts(edits.renames, mesh);
    drop_fields(edits, mesh);
    std::vector<std::string> warnings = merge(edits.merge_tolerance, mesh);
    edits.transform.apply(mesh);
    if (edits.triangulate)
        mesh = triangulated(std::move(mesh));
    return warnings;
}

} // namespace morph::tools
