#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/pipeline/deform_settings.h"

#include <memory>

namespace morph {

/// The extension that the settings choose. A new method is one more value of Method, and one more line here
/// and in couples_directions().
/// @param values  k x c: what will be extended, for methods that choose by it
/// @throws InputError, SolverError  as the extension; Method::ffd extends nothing
std::unique_ptr<BoundaryExtension> make_extension(const Mesh& mesh, const DirichletBoundary& boundary,
                                                  const DeformSettings& deform, const Matrix& values);

/// Whether that extension has more than one component, known before it is made: x and y influence each other.
bool couples_directions(const DeformSettings& deform);

} // namespace morph
