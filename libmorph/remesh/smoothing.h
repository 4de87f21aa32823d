#pragma once

#include "libmorph/remesh/remesh_state.h"

namespace morph {

/// Move every vertex that may move to where its triangles become more alike and of the sizes wanted, on
/// feature curves along these, on a surface along it. A move that would leave a triangle bad is halved or
/// left.
void relax_vertices(RemeshState& made, int sweeps);

/// Mend the triangles below a quality one by one: flip, collapse or split an edge, move a corner, whichever
/// raises the worst of the triangles touched.
/// @return how many are left below it
std::size_t mend_worst(RemeshState& made, double quality);

} // namespace morph
