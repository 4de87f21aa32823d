#include "libmorph/numerics/dense_cholesky.h"

#include "libmorph/core/error.h"
#include "libmorph/numerics/serial_blas.h"

#include <string>

// LAPACK's names, not ours. NOLINTBEGIN(readability-identifier-naming)
extern "C" {
void dpotrf_(const char* triangle, const int* n, double* a, const int* stride, int* info);
void dpotrs_(const char* triangle, const int* n, const int* columns, const double* a, const int* stride_a,
             double* b, const int* stride_b, int* info);
}
// NOLINTEND(readability-identifier-naming)

namespace morph {

DenseCholesky::DenseCholesky(Eigen::MatrixXd A) : factor_(std::move(A))
{
    keep_blas_serial();
    const auto n = static_cast<int>(factor_.rows());
    int failed = 0;
    if (n > 0)
        dpotrf_("L", &n, factor_.data(), &n, &failed);
    if (failed != 0)
        throw SolverError("the dense matrix of " + std::to_string(n) +
                          " rows is not positive definite to working precision, which shows in row " +
                          std::to_string(failed));
}

double DenseCholesky::least_pivot() const
{
    return factor_.rows() == 0 ? 0 : factor_.diagonal().array().square().minCoeff();
}

void DenseCholesky::solve(Eigen::Ref<Eigen::MatrixXd> b) const
{
    const auto n = static_cast<int>(factor_.rows()), columns = static_cast<int>(b.cols());
    const auto stride = static_cast<int>(b.outerStride());
    int failed = 0;
    if (n > 0 && columns > 0)
        dpotrs_("L", &n, &columns, factor_.data(), &n, b.data(), &stride, &failed);
}

} // namespace morph
