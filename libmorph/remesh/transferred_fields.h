#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remap/locate.h"

#include <vector>

namespace morph {

/// Fields of a mesh as they are on the one it was remeshed to: nodal ones interpolated, element fields of
/// planar meshes with their integrals kept.
/// @param fields  of locator.source()
std::vector<Field> transferred_fields(const Locator& locator, const Mesh& mesh,
                                      const std::vector<Field>& fields);

} // namespace morph
