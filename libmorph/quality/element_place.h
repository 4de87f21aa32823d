#pragma once

#include "libmorph/mesh/mesh.h"

#include <Eigen/Core>

#include <string>

namespace morph {

/// Where an element lies.
struct ElementPlace {
    int corners = 3;                                    ///< 3 or 4
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero(); ///< mean of its corners
    std::string nearest_marker;                         ///< by distance from the centroid; empty: no markers
    double marker_distance = 0;                         ///< length unit of the mesh
};

/// Where element @p face of the mesh lies with the vertices at @p positions. The first of equally near
/// markers is named. Looks at every edge of every marker: for a few elements.
/// @throws InputError  positions has another number of rows than the mesh has vertices
ElementPlace element_place(const Mesh& mesh, const PositionsView& positions, Index face);

} // namespace morph
