#pragma once

#include "libmorph/core/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace morph {

/// Entry of a symmetric matrix.
struct MassEntry {
    Index column = 0;
    double value = 0;
};

/// Sparse symmetric positive definite matrix by rows, such as the mass matrix of finite elements, whose
/// condition does not grow with the number of rows.
class MassMatrix {
public:
    /// Append the next row; its diagonal is among the entries.
    void add_row(std::span<const MassEntry> entries);

    Index rows() const { return static_cast<Index>(start_.size()) - 1; }

    /// X with this X = B by conjugate gradients, preconditioned by the diagonal, all columns at once
    /// [Hestenes & Stiefel 1952, Journal of Research of the National Bureau of Standards 49(6), 409-436].
    ///
    /// Rows whose diagonal is 0 are left out and 0 in the result. Equal bytes for any thread count.
    /// @param B      n x K
    /// @param start  n x K, a first guess
    /// @throws SolverError  the residual did not fall to 1e-14 of where it began, or to rounding
    Matrix solve(const Matrix& B, Matrix start) const;

private:
    void multiply(const Matrix& X, Matrix& result) const;

    std::vector<std::size_t> start_{0};
    std::vector<MassEntry> entries_;
    std::vector<double> diagonal_;
};

} // namespace morph
