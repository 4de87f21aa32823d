#pragma once

#include "libmorph/weights/weights.h"
#include "tools/deform/placement.h"

#include <string>

namespace morph::tools {

/// Fill the weights by the method that the case names, see extension_methods.h.
Weights solve_weights(const Mesh& mesh, const PlacedBoundaries& placed, const CaseFile& file);

/// Read weights that were saved on this mesh, or remapped to it, and set the boundary rows anew so that
/// boundary nodes land on their curves.
///
/// @throws InputError  the file's vertices are not those of the mesh, or a field is missing
Weights load_weights(const std::string& path, const Mesh& mesh, const PlacedBoundaries& placed);

} // namespace morph::tools
