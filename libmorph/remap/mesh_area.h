#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph {

/// Area of a planar mesh, every element counted as positive.
double mesh_area(const Mesh& mesh);

} // namespace morph
