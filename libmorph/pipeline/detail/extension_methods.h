#pragma once

#include "libmorph/deform/boundary_move.h"
#include "libmorph/weights/coupled_extension.h"
#include "tools/case/deform_entry.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace morph::tools {

/// What carries a boundary's move into the mesh, x and y apart or together.
using AnyExtension = std::variant<std::unique_ptr<BoundaryExtension>, std::unique_ptr<CoupledExtension>>;

/// What a method is made from.
struct ExtensionSetup {
    const Mesh& mesh;
    const DirichletBoundary& held;
    const DeformEntry& deform;
    const Matrix& values; ///< k x c: what will be spread, for methods that choose by it
};

/// A method that carries a boundary's move into the mesh.
struct ExtensionMethod {
    std::string name;
    std::string what; ///< a line for people
    AnyExtension (*make)(const ExtensionSetup& setup);
    bool (*couples)(const DeformEntry& deform); ///< whether x and y influence each other
};

/// All of them. A new method is one more row of the table in the source, and its name in move_methods().
const std::vector<ExtensionMethod>& extension_methods();

/// The one that a case names.
const ExtensionMethod& extension_method(const DeformEntry& deform);

} // namespace morph::tools
