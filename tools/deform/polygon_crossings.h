#pragma once

#include "libmorph/mesh/mesh.h"

#include <string>
#include <vector>

namespace morph::tools {

/// Where the moved boundary, edge by edge, crosses itself, one sentence each: none, or the first place; or
/// the first part of it that bounds no domain, see find_misplaced_loop(). No valid mesh exists then. Even
/// where curves are simple, the polygon of their nodes need not be.
///
/// Nothing is said of a mesh whose boundary is like that before the move already.
/// @param before  n x 3
std::vector<std::string> polygon_crossings(const Mesh& moved, const PositionsView& before);

} // namespace morph::tools
