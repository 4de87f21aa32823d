#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/pipeline/deform_settings.h"

#include <memory>
#include <variant>

namespace morph {

/// What carries a boundary's move into the mesh, x and y apart or together.
using AnyExtension = std::variant<std::unique_ptr<BoundaryExtension>, std::unique_ptr<CoupledExtension>>;

/// The extension that the settings choose. A new method is one more value of Method, and one more line here and
/// in couples_directions().
/// @param values  k x c: what will be extended, for methods that choose by it
/// @throws InputError, SolverError  as the extension; Method::ffd extends nothing
AnyExtension make_extension(const Mesh& mesh, const DirichletBoundary& boundary, const DeformSettings& deform,
                            const Matrix& values);

/// Whether x and y influence each other in that extension.
bool couples_directions(const DeformSettings& deform);

} // namespace morph
