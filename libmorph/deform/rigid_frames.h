#pragma once

#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/boundary_extension.h"

#include <vector>

namespace morph {

/// How a boundary moves around each of its vertices: a turn by the angle about the pivot of the vertex's
/// body, then a shift by the translation.
struct BoundaryFrames {
    std::vector<double> angle; ///< k, radians, may exceed half a turn; 0 where nothing moves
    Points2 translation;       ///< k x 2, length unit of the mesh
    std::vector<Index> body;   ///< k: which body; -1: not on a moving edge
    Points2 pivot;             ///< of each body
};

/// Reach of the angles of boundary_frames(): a tenth of the chord for an airfoil. The angles of single edges
/// invert elements at the trailing edge of airfoils in tests/data when they become thrice as thick; from 0.02
/// on none is inverted, and up to 0.2 waves of the length of the chord are followed.
inline constexpr double kFrameReach = 0.05;

/// The local rigid motion of a boundary.
///
/// A body is a connected piece of the moving edges, its pivot their centroid. The angle at a vertex is that
/// of the rotation which fits the edges around it, before and after, best in the least-squares sense [Kabsch
/// 1976, Acta Crystallographica A32, 922-923; in the plane the argument of one complex sum]: those within
/// @p reach along the boundary, an edge by its length and the less the farther away. Without reach the mesh
/// would fold over dents and sharp edges, where the angle jumps; with too much of it parts of a body that
/// bends would not be followed.
///
/// Angles are followed from vertex to vertex without jumps, and their mean is within half a turn of the
/// rotation that fits the whole body: a rigid turn by 120 degrees is 120 degrees at every vertex. From where
/// things end a turn by 200 degrees cannot be distinguished from one by -160: a body turns by less than half a turn
/// here, its parts by any angle against it. The translation is what the turn leaves of the vertex's
/// displacement; away from moving edges it is the displacement.
///
/// @param displacement  k x 2, row i moves held.vertices[i]; length unit of the mesh
/// @param reach         part of the length of the body, in [0, 1]
/// @throws InputError  another number of rows or columns, not finite, or different for two copies of a split
///                     vertex; a bad reach; a moving edge ends at a vertex that is not held; the mesh is a
///                     surface in space
BoundaryFrames boundary_frames(const DomainView& domain, const DirichletBoundary& held,
                               const Matrix& displacement, double reach = kFrameReach);

/// Extend a boundary's displacement into the mesh together with its rotation.
///
/// Angle theta and translation t of boundary_frames() are extended like any other values, and each vertex moves
/// to
///
///     x' = x + t(x) + (R(theta(x)) - I) (x - p(x)),
///
/// where p blends the pivots by how much of each body arrives at x. Near a body that moves rigidly the mesh
/// moves rigidly with it, and what lies between bodies that move as one is carried along. The displacement
/// itself, extended linearly, would shrink the mesh where rotations of different angle meet. Extending
/// rotations of a boundary is due to Samareh [2002, NASA/TM-2002-211646], in the plane his quaternions are
/// angles.
///
/// Not linear: half the displacement does not give half the result.
///
/// @param extension  made of @p domain and @p held
/// @return n x 2, equal to @p displacement at the held vertices; the same bytes for any number of threads
/// @throws InputError, SolverError  as boundary_frames() and BoundaryExtension::extend()
Matrix extend_with_rotations(const BoundaryExtension& extension, const DomainView& domain,
                             const DirichletBoundary& held, const Matrix& displacement,
                             double reach = kFrameReach);

} // namespace morph
