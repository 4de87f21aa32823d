#pragma once

#include "formats/format.h"
#include "formats/text/numbered_names.h"

#include <string>
#include <vector>

namespace morph {

/// The file x.mapbc next to x.lb8.ugrid, which FUN3D reads: a count, then for each surface its number, the
/// number of its boundary condition and its name. Conditions are carried; 0 is written for a surface without
/// one. Behind the last surface a comment may say how triangles and quads were mixed (element_order.h).

/// What the file says.
struct UgridNames {
    std::vector<NumberedName> groups;
    std::string text;                    ///< all of the file, for its comments
    std::vector<OpaqueSection> sections; ///< boundary conditions
};

/// Read the file next to the mesh file at @p mesh_path; nothing when there is none.
/// @throws InputError  "path:line: …"
UgridNames read_ugrid_names_beside(const std::string& mesh_path);

/// @param path  for messages
/// @throws InputError  "path:line: …"
UgridNames read_ugrid_names(const std::string& path, std::string_view text);

/// The file for the groups of @p mesh; none when there is nothing to say.
std::vector<Companion> ugrid_names(const MeshData& mesh);

} // namespace morph
