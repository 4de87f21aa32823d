#pragma once

#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/unique_dirichlet_vertices.h"

namespace morph {

/// A linear way to extend values from a DirichletBoundary into the mesh: harmonic functions, radial basis
/// functions, inverse distances, springs, elasticity.
///
/// What depends on the mesh alone is computed once, when it is made; extend() can then be called as often as
/// there are values. The weights of control points are the extension of their basis functions.
///
/// A method derives from it and computes in solve() what the values inside are. Joining the copies of split
/// vertices before, meeting the prescribed values exactly and checking the result after is done here.
class BoundaryExtension {
public:
    BoundaryExtension(const BoundaryExtension&) = delete;
    BoundaryExtension& operator=(const BoundaryExtension&) = delete;
    virtual ~BoundaryExtension() = default;

    /// 1: the columns of values do not influence each other, and there is one weight for each pair of mesh
    /// vertex and prescribed vertex. 2 or 3: the values are vectors whose components do: a body that is
    /// pulled in x gets thinner in y, the cells next to a wall that turns move along with it. Such weights
    /// are blocks.
    int components() const { return components_; }

    /// @param values  k x c, row i belongs to DirichletBoundary::vertices[i]; c is components(), or any
    ///                number where that is 1
    /// @return n x c, equal to @p values at the prescribed vertices; the same bytes for any number of threads
    /// @throws InputError   @p values has another number of rows or columns, is not finite, or gives two
    ///                      copies of a split vertex different values
    /// @throws SolverError  the result is not finite
    Matrix extend(const Matrix& values) const;

protected:
    /// @throws InputError  as UniqueDirichletVertices
    BoundaryExtension(const DomainView& domain, const DirichletBoundary& boundary, int components = 1);

    const UniqueDirichletVertices& held() const { return held_; }

private:
    /// @param joined  h x c, finite: values at held().vertices()
    /// @return n x c; rows of prescribed vertices, and of all copies but the first, are not looked at
    virtual Matrix solve(const Matrix& joined) const = 0;

    UniqueDirichletVertices held_;
    int components_;
};

} // namespace morph
