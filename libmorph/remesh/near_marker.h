#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// The elements with a vertex within a distance of the edges of a marker, for RemeshSettings::kept: m marks,
/// all false for a marker without edges. With distance 0 they are those that touch the marker.
/// @param distance  length unit of the mesh, 0 or more
std::vector<bool> elements_near(const Mesh& mesh, const Marker& marker, double distance);

} // namespace morph
