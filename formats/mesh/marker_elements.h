#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// For each edge, marker by marker, an element that has its first vertex; 0 when none has. For formats in
/// which an element field has values on the edges of markers too.
std::vector<Index> elements_at_markers(const MeshData& mesh);

} // namespace morph
