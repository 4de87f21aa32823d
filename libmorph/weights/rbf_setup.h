#pragma once

#include "libmorph/weights/radial_interpolant.h"
#include "libmorph/weights/rbf.h"

#include <vector>

namespace morph {

/// The support radius that @p options mean, which are checked.
/// @throws InputError  as rbf_extension()
double support_radius(const DomainView& domain, const DirichletBoundary& boundary, const RbfOptions& options);

/// The interpolant with its centres at the given vertices.
/// @throws InputError, SolverError  as RadialInterpolant; two vertices at the same place
RadialInterpolant radial_interpolant(const DomainView& domain, const std::vector<Index>& vertices,
                                     const RbfOptions& options, double support);

} // namespace morph
