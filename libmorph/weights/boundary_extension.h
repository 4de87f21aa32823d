#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <vector>

namespace morph {

/// Where the values that a BoundaryExtension carries into the mesh are given.
struct DirichletBoundary {
    std::vector<Index> vertices; ///< k distinct vertices: the whole boundary of the mesh and its inner walls
    std::vector<std::array<Index, 2>>
        moving_edges;                        ///< boundary edges that move; the other held vertices stay
    std::vector<std::array<Index, 2>> walls; ///< edges inside the mesh that are held
};

/// A linear way to carry values from the held vertices of a mesh to all of them: harmonic functions, radial
/// basis functions, inverse distances, springs.
///
/// What depends on the mesh alone is computed once, when it is made; extend() can then be called as often as
/// there are values. The weights of control points are the spread of their basis functions.
class BoundaryExtension {
public:
    BoundaryExtension() = default;
    BoundaryExtension(const BoundaryExtension&) = delete;
    BoundaryExtension& operator=(const BoundaryExtension&) = delete;
    virtual ~BoundaryExtension() = default;

    /// @param values  k x c, row i belongs to DirichletBoundary::vertices[i]; columns do not influence each other
    /// @return n x c, equal to @p values at the held vertices; the same bytes for any number of threads
    /// @throws InputError   @p values has another number of rows, is not finite, or gives two copies of a
    ///                      split vertex different values
    /// @throws SolverError  the result is not finite
    virtual Matrix extend(const Matrix& values) const = 0;
};

} // namespace morph
