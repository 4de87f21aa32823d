#pragma once

#include "libmorph/basis/curve.h"
#include "libmorph/deform/controlled_points.h"

namespace morph::test {

/// Dense weights between -1 and 1.
Weights random_weights(Index rows, Index columns);

/// Four weights between -1 and 1 in each row, in neighbouring columns.
SparseWeights random_sparse_weights(Index rows, Index columns);

/// The same weights with only those stored that are not zero.
SparseWeights sparse(const Weights& weights);

/// Nodes at equal steps of u on a closed curve, carried by its control points.
ControlledPoints nodes_on(const Curve& curve, Index count);

/// Closed cubic curve with @p control_points points on the ellipse x^2 + (y / height)^2 = 1.
Curve ellipse_curve(Index control_points, double height);

} // namespace morph::test
