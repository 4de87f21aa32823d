#pragma once

#include "libmorph/numerics/nested_dissection.h"
#include "libmorph/numerics/symmetric_matrix.h"

#include <memory>
#include <vector>

namespace morph {

/// L with L L^T = A for a sparse symmetric positive definite A, computed front by front along a dissection
/// tree [Duff & Reid 1983, ACM Transactions on Mathematical Software 9(3), 302-325].
///
/// Each tree node is one dense front: its own rows, and the border, which are the later rows that
/// eliminating its own couples. What is left for the border, the node's update, goes to the parent. A
/// parent adds its children's updates in their order, and only nodes on different branches run at
/// the same time, so that the result does not depend on the number of threads.
class SparseCholesky {
public:
    /// @throws SolverError  A is not positive definite
    SparseCholesky(const SymmetricMatrix& A, Dissection dissection);

    /// X = A^-1 X, all columns at once.
    /// @param X  n x K, row i belongs to row i of A
    void solve(Matrix& X) const;

    /// Numbers stored for L, zeros in the fronts included.
    std::size_t stored() const { return panel_start_.back(); }

private:
    struct Front;
    using Update = std::unique_ptr<double[]>; // border x border, by columns, only the lower triangle

    Front front(std::size_t node) const;
    std::vector<Index> border_of(std::size_t node, const SymmetricMatrix& A) const;
    void reserve_panels();
    void factor(const SymmetricMatrix& A);
    void factor_front(std::size_t node, const SymmetricMatrix& A, std::vector<Update>& updates);
    void add_matrix(const Front& front, const SymmetricMatrix& A) const;
    void add_update(const Front& front, double* update, std::size_t child, const double* childs) const;
    void eliminate(std::size_t node, Matrix& Y, std::vector<Matrix>& sent) const;
    void substitute(std::size_t node, Matrix& Y) const;

    Dissection tree_;
    std::vector<Index> position_;            // of each row in the order of elimination
    std::vector<std::vector<Index>> border_; // of each node: positions, ascending
    std::vector<std::size_t> panel_start_;   // of each node in panels_, and the end
    std::unique_ptr<double[]> panels_;       // of each node: its columns of L, (own + border) x own
};

} // namespace morph
