#pragma once

#include "libmorph/remesh/corner_table.h"

#include <Eigen/Core>

namespace morph {

/// Larger of the absolute principal curvatures of a surface at each vertex of a corner table, 1 / length.
///
/// The second fundamental form of each triangle is fitted to how the normals of its corners differ along its
/// sides [Rusinkiewicz 2004, Estimating curvatures and their derivatives on triangle meshes, 3DPVT]; those
/// around a vertex are averaged by area, as 3 x 3 matrices. Tagged edges (creases, markers) end what counts
/// as one smooth surface; of the parts around a vertex the most curved counts.
///
/// @param table  with its features found
Eigen::VectorXd largest_curvature(const CornerTable& table);

} // namespace morph
