#pragma once

#include "libmorph/quality/quality.h"
#include "libmorph/untangle/untangle.h"

namespace morph::tools {

/// guard = "untangle": repair the inverted elements of a moved mesh, every vertex of its boundary and its
/// markers held where the move put it.
/// @param mesh    moved; repaired in place
/// @param before  n x 3: the shape that elements aim for
UntangleResult untangle_moved(Mesh& mesh, const PositionsView& before);

} // namespace morph::tools
