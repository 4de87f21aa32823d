#pragma once

#include "libmorph/remesh/remesh.h"

namespace morph {

/// Lower wanted sizes where the mesh is curved: on a circle of the local radius r no chord of that length is
/// farther than @p error from its arc, h = sqrt(8 error r). The curvature is that of the turn across the
/// edges of a surface, between the edges of a planar mesh's border; creases and corners, which are features,
/// have none.
/// @param error  positive; length unit of the mesh
void limit_chord_error(const Mesh& mesh, double error, const FeatureSettings& features,
                       Eigen::VectorXd& sizes);

/// Remesh (see remesh()) so that the Hausdorff distance from the input is at most @p distance, as near as
/// that can be met.
///
/// Sizes are limited by the chord error of the longest edges first. Then the distance is measured, sizes are
/// lowered around the places that are farther away, and the mesh is made again, six times at most. What is
/// left beyond the distance is for the caller to find with hausdorff_distance().
///
/// @param distance  positive; length unit of the mesh
/// @param sizes     as for remesh(); on return those that the mesh was made with
/// @throws InputError  as remesh(); a distance that is not positive
RemadeMesh remesh_within(const Mesh& mesh, double distance, Eigen::VectorXd& sizes,
                         const RemeshSettings& settings = {});

} // namespace morph
