#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Core>

namespace morph {

/// A = L L^T of a dense symmetric positive definite matrix, by LAPACK.
class DenseCholesky {
public:
    /// @param A  n x n; its lower triangle is read. Pass it as an rvalue: it is factored in place.
    /// @throws SolverError  A is not positive definite to working precision (names the row where it shows)
    explicit DenseCholesky(Eigen::MatrixXd A);

    Index rows() const { return static_cast<Index>(factor_.rows()); }

    /// Smallest square of a diagonal entry of L; about 1e-16 times the trace of A where A is singular.
    double least_pivot() const;

    /// @param b  n x c, becomes A^-1 b
    void solve(Eigen::Ref<Eigen::MatrixXd> b) const;

private:
    Eigen::MatrixXd factor_;
};

} // namespace morph
