#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// How far apart two meshes are.
struct HausdorffDistance {
    double value = 0;                                ///< the distance at @p place; length unit of the meshes
    double bound = 0;                                ///< the Hausdorff distance is not more than this
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< point of one mesh, @p value from the other
    bool on_first = true;                            ///< it is the first mesh that the place is a point of
};

/// The Hausdorff distance of two meshes: the largest distance of any point of one from the other, between
/// @c value, which is attained, and @c bound.
///
/// Surfaces: between their triangles (quads cut in two). Planar meshes: between their borders with the edges
/// of their markers. Branch and bound as in [Guthe, Borodin & Klein 2005, Fast and accurate Hausdorff
/// distance calculation between meshes, WSCG]: the distance from one triangle is convex, so that it is
/// largest at the corners of what is cut off in front of that triangle. Triangles without area are their
/// sides. The same bytes for any number of threads.
///
/// @param first      a mesh
/// @param second     another of the same dimension
/// @param tolerance  bound - value is at most this part of the value, or 1e-10 of the larger mesh, unless
///                   one triangle would need more than some thousand pieces
/// @throws InputError  a mesh has no element; one is planar and the other is not
HausdorffDistance hausdorff_distance(const Mesh& first, const Mesh& second, double tolerance = 0.01);

/// A point of a mesh, and how far it is from another.
struct DistantPlace {
    Eigen::Vector3d point;
    double distance = 0;
};

/// One place on each triangle (planar: boundary edge) of either mesh that is farther than @p distance from
/// the other mesh, about the farthest of it; those of the first mesh come first, in its order.
/// @throws InputError  as hausdorff_distance()
std::vector<DistantPlace> places_beyond(const Mesh& first, const Mesh& second, double distance);

} // namespace morph
