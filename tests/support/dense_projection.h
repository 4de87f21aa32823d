#pragma once

#include "libmorph/mesh/mesh.h"

#include <Eigen/Core>

namespace morph::test {

/// The matrices of the L2 projection from one planar mesh onto another: M u = B f.
struct DenseProjection {
    Eigen::MatrixXd M; ///< target x target: int phi_i phi_j over the common region
    Eigen::MatrixXd B; ///< target x source: int phi_i psi_s
};

/// The matrices from exact intersections of all pairs of triangles. Convex quads are cut from their first to
/// their third corner; in the meshes' own numbering.
DenseProjection dense_projection(const Mesh& source, const Mesh& target);

} // namespace morph::test
