#pragma once

#include "libmorph/weights/weights_view.h"

#include <vector>

namespace morph {

/// Weights as nodal fields, one per control point, named h_BOUNDARY_i with i from 1, so that any
/// viewer shows them and any mesh file carries them.
/// @param weights  n x K
std::vector<Field> weight_fields(const Weights& weights);

/// The same for weights of which only those that are not zero are stored, and others.
/// @param columns  K, of the columns of @p weights
/// @param weights  n x K
std::vector<Field> weight_fields(const std::vector<ControlPoint>& columns, WeightsView weights);

/// The inverse of weight_fields().
///
/// @param fields   of the mesh that the weights are for; others are passed over
/// @param columns  the control points, in this order
/// @throws InputError  the field of a control point is missing (names it and those present), has more
///                     than one component, or holds something that is no finite number
Weights weights_from_fields(const std::vector<Field>& fields, const std::vector<ControlPoint>& columns);

} // namespace morph
