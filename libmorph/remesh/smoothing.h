#pragma once

#include "libmorph/remesh/remesh_state.h"

namespace morph {

/// Move every vertex that may move to where its triangles become more alike and of the target sizes, on
/// feature curves along these, on a surface along it. A move that would leave a triangle bad is halved or
/// left.
void smooth_vertices(RemeshState& state, int sweeps);

} // namespace morph
