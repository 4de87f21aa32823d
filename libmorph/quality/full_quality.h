#pragma once

#include "libmorph/quality/quality.h"
#include "libmorph/quality/wall.h"

#include <Eigen/Core>

#include <string>
#include <vector>

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

/// Everything there is to say about the quality of a mesh.
struct FullQuality {
    QualityReport summary;
    std::vector<ElementPlace> worst_places; ///< of summary.worst
    std::vector<WallQuality> walls;
};

/// Quality of all of a mesh where it is, with the places of its worst elements.
/// @param mesh       where it is now
/// @param reference  positions before the move (n x 3), or null: adds f_ss and the changes next to walls
/// @throws InputError  reference has a wrong number of rows
FullQuality full_quality(const Mesh& mesh, const PositionsView* reference = nullptr);

} // namespace morph
