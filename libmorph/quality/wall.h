#pragma once

#include "libmorph/mesh/mesh.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace morph {

/// An element next to an edge of a marker.
struct WallCell {
    std::array<Index, 2> edge{}; ///< vertices, the element to the left
    Index face = 0;
    double height =
        0; ///< length unit of the mesh: mean distance of the other corners from the line of the edge
    double angle = 0; ///< degrees between wall normal and side of the element, 0 when it stands upright
};

/// The elements next to the edges of a marker, in the order of the edges; two for an edge inside the mesh.
///
/// Distances count along the normal of the edge into the element, in a surface that in the plane of the
/// element, and are negative beyond the wall. The angle of a quad is the larger one of its two sides; that of
/// a triangle, of which one side at most can stand upright, is the smaller one. It is above 90 when the side
/// runs through the wall. An edge without length has height and angle 0.
/// @throws InputError  positions has another number of rows than the mesh has vertices
std::vector<WallCell> wall_cells(const Mesh& mesh, const Marker& marker, const PositionsView& positions);

/// |height / height before - 1|; the largest double where it was 0 and is not.
double height_change(const WallCell& before, const WallCell& after);

/// Change of the angle, degrees.
double angle_change(const WallCell& before, const WallCell& after);

/// Least, mean and largest of some values.
struct ValueRange {
    double min = 0;
    double mean = 0;
    double max = 0;
};

/// A value and the element next to a wall that has it.
struct WallPlace {
    double value = 0;
    Index element = 0;                                ///< file number
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(); ///< of the edge of the wall
};

/// What a move did to the elements next to a wall.
struct WallChange {
    WallPlace height; ///< largest height_change()
    WallPlace angle;  ///< largest angle_change()
};

/// The elements next to one marker.
struct WallQuality {
    std::string marker;
    Index cells = 0;
    ValueRange height;                ///< see WallCell
    ValueRange angle;                 ///< see WallCell
    std::optional<WallChange> change; ///< with a reference only
};

/// The elements next to each marker that has edges, in the order of the markers.
/// @param mesh       with markers
/// @param positions  n x 3, where the vertices are
/// @param reference  positions before the move (n x 3), or null
/// @throws InputError  positions or reference has a wrong number of rows
std::vector<WallQuality> wall_quality(const Mesh& mesh, const PositionsView& positions,
                                      const PositionsView* reference = nullptr);

} // namespace morph
