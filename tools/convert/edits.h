#pragma once

#include "libmorph/mesh/mesh_data.h"
#include "tools/convert/transform.h"

#include <string>
#include <vector>

namespace morph::tools {

/// What to change of a mesh between reading and writing.
struct Edits {
    std::vector<std::string> renames; ///< "old=new", of markers and groups
    bool drop_all_fields = false;
    std::vector<std::string> drop_fields; ///< names
    double merge_tolerance = 0;           ///< 0: vertices stay as they are
    Transform transform;
    bool triangulate = false;
};

/// Apply the edits, in the order above.
/// @return what was taken away, a warning each
/// @throws InputError  a marker or field to rename or drop does not exist; a new name is taken
std::vector<std::string> apply_edits(const Edits& edits, MeshData& mesh);

} // namespace morph::tools
