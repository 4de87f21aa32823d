#pragma once

#include "libmorph/deform/boundary_move.h"
#include "tools/case/deform_entry.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace morph::tools {

/// A method that carries a boundary's move into the mesh.
struct SpreadMethod {
    std::string name;
    std::string what; ///< a line for people
    std::function<std::unique_ptr<Spread>(const Mesh&, const HeldBoundary&, const DeformEntry&)> make;
};

/// All of them. A new method is one more row of the table in the source, and its name in move_methods().
const std::vector<SpreadMethod>& spread_methods();

/// The one that a case names.
const SpreadMethod& spread_method(const DeformEntry& deform);

} // namespace morph::tools
