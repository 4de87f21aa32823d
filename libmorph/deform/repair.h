#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/untangle/untangle.h"

namespace morph {

/// Repair the inverted elements of a moved mesh by untangle(), every vertex of its boundary and its markers
/// held where the move put it.
///
/// Whether the search ends in a valid mesh depends on where it starts. Where it does not from the mesh as it
/// was moved, and nothing proves that there is none, it starts again from the boundary's move extended into
/// the mesh by conformal_biharmonic_extension(), and then from what repair_in_steps() comes to; the best end
/// counts.
///
/// @param mesh    planar, moved; repaired in place
/// @param before  n x 3: the shape that elements aim for
/// @return elements in the numbering of the mesh; vertices and iterations of all searches together
/// @throws InputError  as untangle()
UntangleResult repair(Mesh& mesh, const PositionsView& before);

} // namespace morph
