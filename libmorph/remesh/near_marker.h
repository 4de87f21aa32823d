#pragma once

#include "libmorph/mesh/mesh.h"

#include <string>
#include <vector>

namespace morph {

/// The elements with a vertex within a distance of the edges of a marker, for RemeshSettings::kept: m marks,
/// all false for a marker without edges. With distance 0 they are those that touch the marker.
/// @param mesh      m elements
/// @param marker    of the mesh
/// @param distance  length unit of the mesh, 0 or more
std::vector<bool> elements_near(const Mesh& mesh, const Marker& marker, double distance);

/// Elements near a marker, to be kept as they are.
struct KeptZone {
    std::string marker;
    double distance = 0; ///< as for elements_near()
};

/// Mark the elements in the zones, too, in @p kept, which is empty or has m marks.
/// @throws InputError  no such marker (names the nearest)
void keep_zones(const Mesh& mesh, const std::vector<KeptZone>& zones, std::vector<bool>& kept);

} // namespace morph
