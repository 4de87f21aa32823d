#pragma once

#include "libmorph/core/types.h"

#include <vector>

namespace morph {

/// Numbers 0, 1, 2, ... for things, each the one it wishes for where that is below their count and not
/// taken; the others get what is left, in order.
/// @param wishes  of each thing, -1: none
std::vector<Index> kept_numbers(const std::vector<Index>& wishes);

} // namespace morph
