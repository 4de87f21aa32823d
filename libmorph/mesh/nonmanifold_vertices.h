#pragma once

#include "libmorph/core/types.h"
#include "libmorph/mesh/kernel.h"

#include <vector>

namespace morph {

/// Give each fan of elements a vertex of its own where several meet in one, open or closed.
///
/// The fan of the first element keeps the vertex; each further one gets a copy at the same place, after
/// all vertices there are. Edges and faces stay what they are.
///
/// @param kernel  as fill_kernel() leaves it
/// @return for each copy, the vertex it copies
std::vector<Index> split_nonmanifold_vertices(Kernel& kernel);

} // namespace morph
