#pragma once

#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <memory>

namespace morph {

/// How idw_extension() weighs the boundary; the defaults are those of IDWarp [Secco et al. 2021, AIAA Journal
/// 59(4)], which uses the same weights.
struct IdwOptions {
    double far_exponent = 3;  ///< a
    double near_exponent = 5; ///< b, at least a
    double reach = 0;         ///< L_def, length unit of the mesh; 0: default_reach()
    double stiffness = 0.25;  ///< alpha: near the boundary means nearer than about alpha L_def
};

/// L_def of IdwOptions unless it is given: the largest distance of a vertex of the mesh from their mean.
double default_reach(const DomainView& domain);

/// Inverse distance weighting of the whole boundary [Luke, Collins and Blades 2012, Journal of Computational
/// Physics 231, 586-601]: the mean of all held values with the weights
///
///     w_i(x) = A_i ((L_def / r_i)^a + (alpha L_def / r_i)^b),   r_i = |x - x_i|,
///
/// where A_i is half the length of the boundary edges at held vertex i. Every value is a mean of held ones,
/// so that bounds and constants are kept. With extend_with_rotations() each point of the boundary has its
/// frame along as in that article; angles are blended where the article blends matrices.
///
/// Each vertex sums over the whole boundary: n k terms, in blocks on every core, so that twice as fine a mesh
/// in the plane takes 8 times as long. Memory beyond the result does not grow with n.
///
/// @throws InputError  as UniqueDirichletVertices; nothing is held; an exponent, reach or stiffness that is
///                     not positive (stiffness may be 0), or b below a
std::unique_ptr<BoundaryExtension> idw_extension(const DomainView& domain, const DirichletBoundary& boundary,
                                                 const IdwOptions& options = {});

} // namespace morph
