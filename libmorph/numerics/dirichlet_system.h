#pragma once

#include "libmorph/numerics/symmetric_matrix.h"

#include <memory>
#include <vector>

namespace morph {

/// A u = 0 at the free vertices of a mesh for prescribed u at the held ones, where A may couple c unknowns at
/// each vertex, and vertices that are not neighbours.
///
/// DirichletLaplacian is the special case of one unknown and weighted edges, and keeps bounds there; this one
/// has no bounds to keep. Factors once, solves as often as asked.
class DirichletSystem {
public:
    /// @param points      n x d: where the vertices are; only the order of elimination depends on it
    /// @param A           c n rows, positive semidefinite; unknown k of vertex v is row c v + k
    /// @param components  c
    /// @param held        distinct vertices in [0, n)
    /// @throws InputError   a held vertex is out of range or given twice, or a part of the mesh has fewer
    /// than
    ///                      c held vertices: the solution there would be arbitrary
    /// @throws SolverError  the matrix is not positive definite
    DirichletSystem(const Eigen::Ref<const Matrix>& points, const SymmetricMatrix& A, Index components,
                    const std::vector<Index>& held);
    ~DirichletSystem();

    /// @param values  k x c m, row i belongs to held[i]; component k of right-hand side j is in column k m +
    /// j
    /// @return n x c m: equal to @p values at the held vertices, 0 at vertices that nothing is joined to
    /// @throws InputError   another number of rows, or of columns that c does not divide
    /// @throws SolverError  the result is not finite
    Matrix solve(const Matrix& values) const;

    /// The same with A u = @p load at the free vertices.
    /// @param load  n x c m; the rows of held vertices are not looked at
    Matrix solve(const Matrix& values, const Matrix& load) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace morph
