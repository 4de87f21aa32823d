#pragma once

#include "libmorph/basis/curve.h"
#include "libmorph/weights/harmonic.h"
#include "libmorph/weights/weights.h"

#include <string>
#include <vector>

namespace morph {

/// A curve and the marker it carries.
struct NamedCurve {
    std::string marker;
    Curve curve;
};

/// Harmonic weights of control points in one call: each curve carries its marker, every other marker is
/// held fixed.
///
/// For more say in what is fixed, or for the parameters of the nodes, see boundary.h and harmonic.h.
///
/// @return n x K, the control points of the first curve first
/// @throws InputError, SolverError  as parametrize_marker(), boundary_conditions() and harmonic_weights()
Weights harmonic_curve_weights(const Mesh& mesh, const std::vector<NamedCurve>& curves,
                               Diffusivity diffusivity = Diffusivity::inverse_distance);

/// The names of the markers of a mesh that are not among @p carried, each once.
std::vector<std::string> other_markers(const Mesh& mesh, const std::vector<std::string>& carried);

} // namespace morph
