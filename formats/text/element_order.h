#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace morph {

/// For formats with all triangles before all quads: the comment "# order 3t1q2t" says how they were mixed.

/// The comment with its line end; empty when triangles come first anyway.
std::string element_order_text(const std::vector<Element>& elements);

/// Triangles ([0]) and quads ([1]) in one list, mixed as the comment in @p text says; triangles first when
/// there is none, or when it is about another number of triangles or quads.
/// @param references  one for each face, in the order of @p faces
/// @param elements    is filled
/// @return the references in the order of @p elements
std::vector<std::int64_t> join_faces(std::array<std::vector<Element>, 2>& faces,
                                     std::array<std::vector<std::int64_t>, 2>& references,
                                     std::string_view text, std::vector<Element>& elements);

} // namespace morph
