#pragma once

#include "libmorph/weights/boundary.h"
#include "libmorph/weights/harmonic.h"

#include <vector>

namespace morph {

/// Harmonic weights of control points in one call: each marker follows its curve, every other marker is
/// held fixed.
///
/// For other methods, and for more say in what is fixed, see boundary_conditions() and extended_weights().
///
/// @return n x K, the control points of the first curve first
/// @throws InputError, SolverError  as boundary_conditions(), harmonic_extension() and extended_weights()
Weights harmonic_curve_weights(const Mesh& mesh, const std::vector<NamedCurve>& curves,
                               Diffusivity diffusivity = Diffusivity::inverse_distance);

} // namespace morph
