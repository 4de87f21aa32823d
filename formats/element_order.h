#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// For formats with all triangles before all quads: the comment "# order 3t1q2t" says how they were mixed.

/// The comment with its line end; empty when triangles come first anyway.
std::string element_order_text(const std::vector<Element>& elements);

/// For each element the number of corners, as the comment in @p text says; empty when there is none, or when
/// it is about another number of triangles or quads.
std::vector<int> read_element_order(std::string_view text, std::size_t triangles, std::size_t quads);

} // namespace morph
