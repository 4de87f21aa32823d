#pragma once

#include "libmorph/quality/quality.h"

#include <string>
#include <vector>

namespace morph {

/// Where the moved boundary, edge by edge, crosses itself, one sentence each: none, or the first place; or
/// the first loop of it that bounds no domain, see find_misplaced_loop(). No valid mesh exists then. Even
/// where curves are simple, the polygon of their nodes need not be.
///
/// A mesh whose boundary is like that before the move already gives no sentence.
/// @param before, after  n x 3
std::vector<std::string> polygon_crossings(const Mesh& mesh, const PositionsView& before,
                                           const PositionsView& after);

} // namespace morph
