#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <map>
#include <string>
#include <vector>

namespace morph {

/// What the comments of a PLY header say about names, which its own lines have no place for:
///     comment vertex_field PROPERTY COMPONENTS NAME   properties PROPERTY and those after it are one field
///     comment face_field PROPERTY COMPONENTS NAME
///     comment group NUMBER NAME    faces with this number in a property group, group_1, …
///     comment marker NUMBER NAME   edges with this number in the property marker
/// Names have what would not survive in a line as %XX.
struct PlyNames {
    struct FieldName {
        int components = 1;
        std::string name;
    };
    std::map<std::string, FieldName> vertex_fields; ///< by the first property
    std::map<std::string, FieldName> face_fields;
    std::map<Index, std::string> groups; ///< by number
    std::map<Index, std::string> markers;
};

/// Other comments are passed over, and so are those that only begin like the above.
PlyNames ply_names(const std::vector<std::string>& comments);

/// "group", "group_1", …
bool is_ply_group(const std::string& property);

} // namespace morph
