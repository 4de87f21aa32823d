#pragma once

#include "libmorph/weights/weights.h"

namespace morph {

/// Move points by weights: X += W D, one product that reads the weights once.
///
/// Linear in @p displacements; equal bytes for any thread count.
///
/// @param weights        n x K
/// @param displacements  K x 2 (x and y move) or K x 3, length unit of the mesh, rows as weights.columns
/// @param positions      n x 3, moved in place: points(mesh) moves the mesh
/// @throws InputError    the sizes do not fit
void apply_weights(const Weights& weights, const Matrix& displacements, Eigen::Map<Points> positions);

/// The same for weights of which only those that are not zero are stored.
void apply_weights(const SparseWeights& weights, const Matrix& displacements, Eigen::Map<Points> positions);

} // namespace morph
