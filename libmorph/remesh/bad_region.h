#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// Quality of each triangle as triangle_quality() has it, m values; 1 for quads, which are never remeshed.
std::vector<double> triangle_qualities(const Mesh& mesh);

/// The elements to keep when only bad triangles are remeshed, for RemeshSettings::kept: all but those below a
/// quality and, @p rings times, those that share a vertex with them.
std::vector<bool> all_but_bad(const Mesh& mesh, double quality, int rings = 2);

/// The same for elements given by number; quads that are not among them are kept in the rings too.
std::vector<bool> all_but(const Mesh& mesh, const std::vector<Index>& elements, int rings);

} // namespace morph
