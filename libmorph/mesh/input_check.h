#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <cstddef>

namespace morph {

/// Check all that can be seen without knowing which elements are neighbours: counts, ranges, finite
/// coordinates, z = 0 in the plane, elements with a repeated vertex, shapes of fields.
/// @throws InputError  names the first offender by its file number
void check_input(const MeshData& data);

/// Check that a mesh of this size can be numbered: an element has at most four sides of its own, each
/// of two halfedges, and each halfedge needs an Index.
/// @throws InputError  it cannot
void require_countable(std::size_t vertices, std::size_t elements);

} // namespace morph
