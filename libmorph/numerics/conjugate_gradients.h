#pragma once

#include "libmorph/numerics/symmetric_matrix.h"

namespace morph {

/// When conjugate_gradients() stops.
struct ConjugateGradientOptions {
    Index block = 1024;      ///< rows that are factored together
    double tolerance = 0.05; ///< norm of the residual as part of that of the right-hand side
    int iterations = 300;    ///< at most
};

/// Solve A x = b for a symmetric positive definite A to a tolerance, in bounded memory: conjugate gradients,
/// preconditioned by Cholesky factors of the diagonal blocks of consecutive rows [Saad 2003, Iterative
/// Methods for Sparse Linear Systems, sections 9.2 and 12.2]. Rows that follow a space-filling curve make
/// good blocks.
///
/// Every iterate is a descent direction for 1/2 x^T A x - b^T x. The same bytes for any number of threads.
///
/// @param where  n x d, finite: what rows stand for; only the order of elimination depends on it
/// @param x      n x 1: b, becomes x
/// @return the number of iterations
/// @throws SolverError  a block, or A along a direction, is not positive definite
int conjugate_gradients(const SymmetricMatrix& A, const Eigen::Ref<const Matrix>& where,
                        const ConjugateGradientOptions& options, Matrix& x);

} // namespace morph
