#pragma once

#include "libmorph/remap/supermesh.h"

#include <Eigen/Core>

namespace morph {

/// Integrals of products of basis functions over what a triangle of the target and one of the source have in
/// common.
struct MixedMass {
    Eigen::Matrix3d own = Eigen::Matrix3d::Zero();   ///< int phi_i phi_j, both of the target
    Eigen::Matrix3d mixed = Eigen::Matrix3d::Zero(); ///< int phi_i psi_s, the second of the source
};

/// Integrate by the midpoints of the sides of the triangles that the common polygon is cut into, which is
/// exact for polynomials of degree 2 [Strang & Fix 1973, An Analysis of the Finite Element Method,
/// table 4.1].
///
/// @param target   triangle, its area not 0
/// @param overlap  of it with a triangle of the source, its area not 0
MixedMass mixed_mass(const ConvexPart& target, const Overlap& overlap);

/// The same lumped, for a source that covers little of the triangle: int phi_i on the diagonal, and each
/// corner x_i gets the source continued linearly to it, mixed(i, s) = psi_s(x_i) int phi_i.
///
/// The integral of the source is the same as without lumping, because sum_i phi_i (x_i - x) = 0, and linear
/// functions stay exact.
MixedMass lumped_mixed_mass(const ConvexPart& target, const Overlap& overlap);

} // namespace morph
