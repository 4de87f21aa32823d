#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <vector>

namespace morph {

/// Where the values that a Spread carries into the mesh are given.
struct HeldBoundary {
    std::vector<Index> vertices; ///< k distinct vertices: the whole boundary of the mesh and its inner walls
    std::vector<std::array<Index, 2>>
        moving_edges;                        ///< boundary edges that move; the other held vertices stay
    std::vector<std::array<Index, 2>> walls; ///< edges inside the mesh that are held
};

/// A linear way to carry values from the held vertices of a mesh to all of them: harmonic functions, radial
/// basis functions, inverse distances, springs.
///
/// What depends on the mesh alone is computed once, when it is made; spread() can then be called as often as
/// there are values. The weights of control points are the spread of their basis functions.
class Spread {
public:
    Spread() = default;
    Spread(const Spread&) = delete;
    Spread& operator=(const Spread&) = delete;
    virtual ~Spread() = default;

    /// @param values  k x c, row i belongs to HeldBoundary::vertices[i]; columns do not influence each other
    /// @return n x c, equal to @p values at the held vertices; the same bytes for any number of threads
    /// @throws InputError   @p values has another number of rows, is not finite, or gives two copies of a
    ///                      split vertex different values
    /// @throws SolverError  the result is not finite
    virtual Matrix spread(const Matrix& values) const = 0;
};

} // namespace morph
