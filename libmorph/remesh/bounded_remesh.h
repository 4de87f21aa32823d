#pragma once

#include "libmorph/remesh/remesh.h"

namespace morph {

/// Remesh (see remesh()) so that the Hausdorff distance from the input is at most @p distance, as near as
/// that can be met.
///
/// Sizes are limited by the chord error of the longest edges first (chord_sizes()). Then the distance is
/// measured, sizes are lowered around the places that are farther away, and the mesh is made again, ten times
/// at most. What is left beyond the distance is for the caller to find with hausdorff_distance().
///
/// @param distance  positive; length unit of the mesh
/// @param sizes     as for remesh(); on return those that the mesh was made with
/// @throws InputError  as remesh(); a distance that is not positive
RemeshResult remesh_within(const Mesh& mesh, double distance, Eigen::VectorXd& sizes,
                           const RemeshSettings& settings = {});

} // namespace morph
