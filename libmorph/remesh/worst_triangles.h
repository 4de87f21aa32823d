#pragma once

#include "libmorph/remesh/remesh_state.h"

namespace morph {

/// Improve the triangles below a quality one by one: flip, collapse or split an edge or move a corner,
/// whichever raises the worst of the triangles touched.
/// @return how many are left below it
std::size_t improve_worst(RemeshState& state, double quality);

} // namespace morph
