#pragma once

#include "libmorph/numerics/stiffness.h"

#include <memory>
#include <vector>

namespace morph {

/// K h = 0 at every free vertex of a graph of weighted edges, for prescribed values at the held ones.
///
/// Factors once, solves for as many right-hand sides as asked, as often as asked.
class DirichletLaplacian {
public:
    /// @param points  n x d: where the vertices are; only the order of elimination depends on it
    /// @param edges   weights not negative
    /// @param held    distinct vertices in [0, n)
    /// @throws InputError   a held vertex is out of range or given twice, or a part of the graph has no
    ///                      held vertex: the solution there would be arbitrary
    /// @throws SolverError  the matrix is not positive definite: a part hangs on by weights of zero
    DirichletLaplacian(const Eigen::Ref<const Matrix>& points, const std::vector<WeightedEdge>& edges,
                       const std::vector<Index>& held);
    ~DirichletLaplacian();
    DirichletLaplacian(DirichletLaplacian&&) noexcept;
    DirichletLaplacian& operator=(DirichletLaplacian&&) noexcept;

    /// One more column, 1 at every held vertex, is solved for and divides the others: exactly it is 1, and
    /// in floating point it has lost what they have lost to the rounding of the diagonal (each entry is a
    /// sum over edges whose weights may differ 1e12 times at slivers). Elimination only adds numbers of one
    /// sign here, so that the quotients keep the bounds of the held values, and columns that sum to 1 there
    /// sum to 1, to some 1e-14 whatever the condition of the matrix.
    ///
    /// @param values  k x K, row i belongs to held[i]
    /// @return n x K: equal to @p values at the held vertices, 0 at vertices without an edge
    /// @throws SolverError  the result is not finite
    Matrix solve(const Matrix& values) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace morph
