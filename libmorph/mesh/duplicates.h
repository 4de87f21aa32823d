#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// Check that no two elements have the same vertices, in whatever order.
///
/// @param elements   sorted by their smallest vertex
/// @param numbering  file numbers for the messages
/// @throws InputError  two elements are the same
void require_distinct_elements(const std::vector<Element>& elements, const Numbering& numbering);

} // namespace morph
