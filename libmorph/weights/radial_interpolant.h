#pragma once

#include "libmorph/core/types.h"
#include "libmorph/numerics/dense_cholesky.h"
#include "libmorph/weights/radial.h"

#include <Eigen/QR>

#include <optional>

namespace morph {

/// Interpolation by radial functions at centres in the plane,
///
///     s(x) = sum_i lambda_i phi(|x - x_i| / support) + beta_0 + beta_1 x + beta_2 y,
///
/// where lambda is orthogonal to 1, x and y [Wendland 2004, Scattered Data Approximation, chapters 6 and 8].
///
/// The linear terms are split off by Householder reflections. What is left of the matrix is positive definite
/// for every RadialFunction and is factored by Cholesky's method: O(m^3 / 3) once, O(m^2) for each column.
/// Where it is singular to working precision, as with smooth functions that reach over many centres, a
/// small multiple of the identity is added: an approximation that misses smooth values by some 1e-7 of the
/// largest.
class RadialInterpolant {
public:
    /// @param centres  m x 3, distinct; z is ignored
    /// @param support  length unit of the centres
    /// @param linear   with beta; without, lambda is free
    /// @throws InputError   fewer than 3 centres, or all on a line, with linear terms
    /// @throws SolverError  the system is singular even so
    RadialInterpolant(const Points& centres, RadialFunction function, double support, bool linear);

    /// lambda and beta of values at the centres.
    /// @param values  m x c
    /// @return (m + 3) x c, or m x c without linear terms
    /// @throws SolverError  the values are missed by a quarter of the largest: they jump
    Matrix coefficients(const Matrix& values) const;

    /// s at points: O(q m c), in blocks on every core; memory beyond the result does not depend on q.
    /// @param at            q x 3, z is ignored; along a space-filling curve blocks out of reach are left out
    /// @param coefficients  from coefficients()
    /// @return q x c, the same bytes for any number of threads
    Matrix evaluate(const Eigen::Ref<const Points>& at, const Matrix& coefficients) const;

private:
    Eigen::MatrixXd matrix() const;
    Matrix solve(const Matrix& values) const;
    void add_block(const Eigen::Ref<const Points>& at, const Matrix& coefficients,
                   Eigen::Ref<Matrix> result) const;
    /// Rows 1, x, y in units in which the centres fill about [-1, 1].
    Eigen::MatrixX3d linear_terms(const Eigen::Ref<const Points>& at) const;

    Points centres_;
    RadialFunction function_;
    double support_;
    Eigen::RowVector2d middle_;
    double scale_;
    std::optional<Eigen::HouseholderQR<Eigen::MatrixXd>> terms_; ///< of linear_terms(centres)
    Eigen::MatrixXd coupling_;                                   ///< 3 x (m - 3): the first rows of Q^T Phi Q
    std::optional<DenseCholesky> factor_;                        ///< of the rest of Q^T Phi Q
};

} // namespace morph
