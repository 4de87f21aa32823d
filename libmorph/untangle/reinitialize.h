#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/untangle/vertex_stars.h"

#include <optional>

namespace morph {

/// The move of the held vertices extended over the mesh before the move: div(g grad d) = 0 with g = 1 / mean
/// area of the elements around, so that large elements give way first.
///
/// A start for untangling that does not depend on where the free vertices had come to lie.
///
/// @param reference  n x 3: before the move
/// @param held       by vertex, see VertexStars for which
/// @param positions  n x 3: after the move, of which the held rows count
/// @return n x 2 displacements from @p reference, 0 for all but the first copy of a split vertex; or nothing
///         where a part of the mesh has no held vertex, so that no move is extended there
std::optional<Matrix> spread_move(const Mesh& mesh, const VertexStars& stars, const PositionsView& reference,
                                  const std::vector<char>& held, const PositionsView& positions);

} // namespace morph
