#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <vector>

namespace morph {

/// Where values are prescribed: the boundary of the mesh, and walls inside it.
struct DirichletBoundary {
    /// k distinct vertices. Of a split vertex one copy is enough.
    std::vector<Index> vertices;
    /// Edges that move; all other prescribed vertices stay where they are.
    std::vector<std::array<Index, 2>> moving_edges;
    /// Edges that stay. Those inside the mesh are walls, as moving ones are. An edge in both lists moves.
    std::vector<std::array<Index, 2>> fixed_edges;
};

} // namespace morph
