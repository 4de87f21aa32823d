#pragma once

#include "libmorph/weights/weights_view.h"

namespace morph {

/// How an objective changes with the control points, from how it changes with the vertices: dJ/dP = W^T
/// dJ/dX. With an adjoint solver's dJ/dX, the sensitivities of all control points cost one product.
///
/// The transpose of apply_weights(), so exact for every linear method; equal bytes for any thread count.
///
/// @param weights   n x K
/// @param gradient  n x 2 (x and y) or n x 3, dJ/dX in the unit of J per length unit of the mesh
/// @return K x 2 or K x 3, the same unit, rows as the columns of the weights
/// @throws InputError  the sizes do not fit
Matrix control_point_gradient(WeightsView weights, const Matrix& gradient);

} // namespace morph
