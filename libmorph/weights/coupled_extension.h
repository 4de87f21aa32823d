#pragma once

#include "libmorph/core/types.h"

namespace morph {

/// A linear way to carry displacements from the held vertices of a mesh to all of them in which x and y
/// influence each other: a body that is pulled in x gets thinner in y, and the cells beside a wall that turns
/// move along with it. A BoundaryExtension has one number for each pair of mesh vertex and held vertex, the same for x
/// and y; here it is a 2 x 2 block of numbers, and the weights of a control point are such blocks as well.
///
/// What depends on the mesh alone is computed once, when it is made; extend() can then be called as often as
/// there are moves.
class CoupledExtension {
public:
    CoupledExtension() = default;
    CoupledExtension(const CoupledExtension&) = delete;
    CoupledExtension& operator=(const CoupledExtension&) = delete;
    virtual ~CoupledExtension() = default;

    /// @param displacements  k x 2, row i belongs to DirichletBoundary::vertices[i]; length unit of the mesh
    /// @return n x 2, equal to @p displacements at the held vertices; the same bytes for any number of
    /// threads
    /// @throws InputError   @p displacements has another number of rows, is not finite, or moves two copies
    /// of
    ///                      a split vertex apart
    /// @throws SolverError  the result is not finite
    virtual Points2 extend(const Points2& displacements) const = 0;
};

} // namespace morph
