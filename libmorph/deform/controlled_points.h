#pragma once

#include "libmorph/weights/weights_view.h"

#include <vector>

namespace morph {

/// A point of a mesh: the mean of some of its vertices with the given shares. One vertex with share 1 is the
/// vertex itself; the corners of an element with their corner_weights() are a point in it.
struct MeshPoint {
    std::vector<Index> vertices;
    std::vector<double> shares; ///< as many, their sum is 1
};

/// Points that follow the control points: moved = positions + weights * displacements. What direct control
/// speaks of, whichever method filled the weights.
struct ControlledPoints {
    Points positions; ///< m x 3, before any displacement, length unit of the mesh
    Eigen::SparseMatrix<double, Eigen::RowMajor, Index> weights; ///< m x K, without the zeros
};

/// Points of a mesh and how they follow its control points.
/// @param weights    n x K
/// @param positions  n x 3, before any displacement
/// @param points     m combinations of vertices
/// @throws InputError  the sizes do not fit, or a point names a vertex that the mesh does not have
ControlledPoints controlled_points(WeightsView weights, const Eigen::Ref<const Points>& positions,
                                   const std::vector<MeshPoint>& points);

/// The same for vertices of the mesh: the nodes of a boundary in order, for instance.
ControlledPoints controlled_vertices(WeightsView weights, const Eigen::Ref<const Points>& positions,
                                     const std::vector<Index>& vertices);

/// Where displacements take the points.
/// @param points         m points and their weights
/// @param displacements  K x 2 (x and y move) or K x 3
/// @return m x 3
Points moved(const ControlledPoints& points, const Matrix& displacements);

} // namespace morph
