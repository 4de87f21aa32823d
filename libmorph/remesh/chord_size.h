#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/features.h"

namespace morph {

/// Edge lengths whose chords are @p error away from what is curved: sqrt(8 error r) for a radius of curvature
/// r, of the feature curves (the boundary of a planar mesh) and, on a surface, of the surface.
///
/// @param features  what is a feature, and curves given
/// @param error     length unit of the mesh, positive
/// @return n values; infinite at vertices of nothing curved
/// @throws InputError  as find_features()
Eigen::VectorXd chord_sizes(const Mesh& mesh, const FeatureSettings& features, double error);

} // namespace morph
