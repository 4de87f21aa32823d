#pragma once

#include "libmorph/deform/boundary_move.h"
#include "libmorph/weights/vector_spread.h"
#include "tools/case/deform_entry.h"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace morph::tools {

/// What carries a boundary's move into the mesh, x and y apart or together.
using AnySpread = std::variant<std::unique_ptr<Spread>, std::unique_ptr<VectorSpread>>;

/// What a method is made from.
struct SpreadSetup {
    const Mesh& mesh;
    const HeldBoundary& held;
    const DeformEntry& deform;
    const Matrix& values; ///< k x c: what will be spread, for methods that choose by it
};

/// A method that carries a boundary's move into the mesh.
struct SpreadMethod {
    std::string name;
    std::string what; ///< a line for people
    AnySpread (*make)(const SpreadSetup& setup);
    bool (*couples)(const DeformEntry& deform); ///< whether x and y influence each other
};

/// All of them. A new method is one more row of the table in the source, and its name in move_methods().
const std::vector<SpreadMethod>& spread_methods();

/// The one that a case names.
const SpreadMethod& spread_method(const DeformEntry& deform);

} // namespace morph::tools
