#pragma once

#include "libmorph/weights/weights.h"
#include "tools/deform/moved_case.h"

#include <string>

namespace morph::tools {

/// Fill the weights by the method that the case names, see spread_methods.h.
Weights solve_weights(const Mesh& mesh, const PlacedCase& placed, const CaseFile& file);

/// Read weights that were saved on this mesh, or remapped to it, and set the boundary rows anew so that
/// boundary nodes land on their curves.
///
/// @throws InputError  the file's vertices are not those of the mesh, or a field is missing
Weights load_weights(const std::string& path, const Mesh& mesh, const PlacedCase& placed);

} // namespace morph::tools
