#pragma once

#include "libmorph/numerics/nested_dissection.h"

#include <cstddef>
#include <functional>

namespace morph {

/// Call visit(node) for every node of the tree, children before their parent, branches in parallel. A
/// visit that writes only what belongs to its node gives the same result for any number of threads.
void walk_up(const Dissection& tree, const std::function<void(std::size_t)>& visit);

/// The same with every parent before its children.
void walk_down(const Dissection& tree, const std::function<void(std::size_t)>& visit);

} // namespace morph
