#pragma once

#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <memory>

namespace morph {

/// Algebraic damping: each vertex takes the value of the nearest point of the moving boundary, the less of it
/// the nearer the fixed boundary is [after Zhao and Forhad 2003, Computer Methods in Applied Mechanics and
/// Engineering 192, 4439-4466],
///
///     v(x) = f v_moving + (1 - f) v_fixed,   f = d_fixed^2 / (d_fixed^2 + d_moving^2),
///
/// where v_moving is the value at the nearest point of the moving edges, at distance d_moving, linear along
/// its edge, and v_fixed the same for all other held boundary, where it usually is zero. f is 1 on the moving
/// boundary and 0 on the fixed one, both with no slope, so that the first layers keep their heights.
///
/// No system to solve, O(log k) for each vertex, and every value is a mean of held ones. But where two points
/// of the moving boundary are equally near, as inside a dent or between two bodies, v jumps if their
/// values differ.
///
/// @throws InputError  as UniqueDirichletVertices; nothing is held; a moving edge ends at a vertex that is
///                     not held
std::unique_ptr<BoundaryExtension> damping_extension(const DomainView& domain,
                                                     const DirichletBoundary& boundary);

} // namespace morph
