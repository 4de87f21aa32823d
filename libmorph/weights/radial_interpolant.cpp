#include "libmorph/weights/radial_interpolant.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

constexpr Index kRows = 256;    // points a thread takes at a time
constexpr Index kColumns = 256; // centres whose functions it has in memory at a time: 512 KiB

constexpr double kFlat = 1e-10; // centres that leave a line by this part of its length are on it

// Rounding moves the eigenvalues of a matrix by some 1e-16 of its trace. What has pivots well above that is
// factored as it is, else a multiple of the identity is added, not more than the last of these.
constexpr double kLeastPivot = 1e-15;
constexpr double kRidges[] = {0, 2e-15, 1e-14, 1e-13, 1e-12, 1e-11};

constexpr double kRounding = 1e-12; // of the norm of values: what an affine move leaves at most
constexpr double kGivenBack = 0.25; // of the largest value: what misses more is no interpolant

DenseCholesky regularised(const Eigen::MatrixXd& A)
{
    const double trace = std::max(A.trace(), 0.0);
    for (const double ridge : kRidges)
        try {
            Eigen::MatrixXd raised = A;
            raised.diagonal().array() += ridge * trace;
            DenseCholesky factor(std::move(raised));
            if (factor.least_pivot() >= kLeastPivot * trace)
                return factor;
        } catch (const SolverError&) { // a larger ridge is next
        }
    throw SolverError("the system of " + std::to_string(A.rows()) +
                      " radial functions is singular to working precision; take a smaller support radius or "
                      "a less smooth function");
}

double largest(const Matrix& values)
{
    return values.size() == 0 ? 0 : values.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

/// Squared distance between the boxes of two sets of points.
double squared_gap(const Eigen::Ref<const Points>& a, const Eigen::Ref<const Points>& b)
{
    const Eigen::Array2d above = (b.colwise().minCoeff() - a.colwise().maxCoeff()).head<2>();
    const Eigen::Array2d below = (a.colwise().minCoeff() - b.colwise().maxCoeff()).head<2>();
    return above.max(below).max(0).square().sum();
}

} // namespace

RadialInterpolant::RadialInterpolant(const Points& centres, RadialFunction function, double support,
                                     bool linear)
    : centres_(centres), function_(function), support_(support)
{
    const Eigen::RowVector3d low = centres.colwise().minCoeff(), high = centres.colwise().maxCoeff();
    middle_ = 0.5 * (low + high).head<2>();
    scale_ = std::max(0.5 * (high - low).head<2>().maxCoeff(), 1e-300);
    Eigen::MatrixXd A = matrix();
    if (linear) {
        const Eigen::MatrixXd P = linear_terms(centres);
        if (P.rows() >= 3)
            terms_.emplace(P);
        if (!terms_ || std::abs(terms_->matrixQR()(2, 2)) < kFlat * std::abs(terms_->matrixQR()(0, 0)))
            throw InputError("the " + std::to_string(centres.rows()) +
                             " centres of the radial functions lie on a line: linear terms need three that "
                             "do not");
        A.applyOnTheLeft(terms_->householderQ().adjoint());
        A.applyOnTheRight(terms_->householderQ());
        coupling_ = A.topRightCorner(3, A.cols() - 3);
        A = A.bottomRightCorner(A.rows() - 3, A.cols() - 3).eval();
    }
    factor_.emplace(regularised(A));
}

Eigen::MatrixXd RadialInterpolant::matrix() const
{
    const auto m = centres_.rows();
    Eigen::MatrixXd A(m, m);
    parallel_for(static_cast<std::size_t>(m), 16, [&](std::size_t begin, std::size_t end) {
        for (auto j = static_cast<Index>(begin); j < static_cast<Index>(end); ++j) {
            A.col(j) = (centres_.col(0).array() - centres_(j, 0)).square() +
                       (centres_.col(1).array() - centres_(j, 1)).square();
            A.col(j) /= support_ * support_;
            apply_radial(function_, A.col(j).array());
        }
    });
    return A;
}

Eigen::MatrixX3d RadialInterpolant::linear_terms(const Eigen::Ref<const Points>& at) const
{
    Eigen::MatrixX3d terms(at.rows(), 3);
    terms.col(0).setOnes();
    terms.rightCols<2>() = (at.leftCols<2>().rowwise() - middle_) / scale_;
    return terms;
}

Matrix RadialInterpolant::solve(const Matrix& values) const
{
    Eigen::MatrixXd u = values;
    if (!terms_) {
        factor_->solve(u);
        return u;
    }
    u.applyOnTheLeft(terms_->householderQ().adjoint());
    const auto m = u.rows();
    for (Index c = 0; c < static_cast<Index>(u.cols());
         ++c) // an affine move leaves rounding, let it be nothing
        if (u.col(c).tail(m - 3).norm() <= kRounding * u.col(c).norm())
            u.col(c).tail(m - 3).setZero();
    factor_->solve(u.bottomRows(m - 3));
    Eigen::MatrixXd beta = u.topRows(3) - coupling_ * u.bottomRows(m - 3);
    terms_->matrixQR().topRows(3).triangularView<Eigen::Upper>().solveInPlace(beta);
    u.topRows(3).setZero();
    u.applyOnTheLeft(terms_->householderQ());
    Matrix result(m + 3, values.cols());
    result << u, beta;
    return result;
}

Matrix RadialInterpolant::coefficients(const Matrix& values) const
{
    Matrix result = solve(values);
    const double missed = largest(values - evaluate(centres_, result));
    if (!(missed <= kGivenBack * largest(values)))
        throw SolverError("the system of " + std::to_string(centres_.rows()) +
                          " radial functions is so ill-conditioned that its solution misses the values by " +
                          std::to_string(std::lround(100 * missed / largest(values))) +
                          " percent; take a smaller support radius or a less smooth function");
    return result;
}

void RadialInterpolant::add_block(const Eigen::Ref<const Points>& at, const Matrix& coefficients,
                                  Eigen::Ref<Matrix> result) const
{
    const Eigen::ArrayXd x = at.col(0), y = at.col(1);
    Eigen::MatrixXd phi(at.rows(), kColumns);
    for (Index first = 0; first < static_cast<Index>(centres_.rows()); first += kColumns) {
        const Index count = std::min(kColumns, static_cast<Index>(centres_.rows()) - first);
        const auto centres = centres_.middleRows(first, count);
        if (has_compact_support(function_) && squared_gap(at, centres) >= support_ * support_)
            continue;
        for (Index j = 0; j < count; ++j) {
            phi.col(j) =
                ((x - centres(j, 0)).square() + (y - centres(j, 1)).square()) / (support_ * support_);
            apply_radial(function_, phi.col(j).array());
        }
        result.noalias() += phi.leftCols(count) * coefficients.middleRows(first, count);
    }
    if (terms_)
        result.noalias() += linear_terms(at) * coefficients.bottomRows(3);
}

Matrix RadialInterpolant::evaluate(const Eigen::Ref<const Points>& at, const Matrix& coefficients) const
{
    Matrix result = Matrix::Zero(at.rows(), coefficients.cols());
    parallel_for(static_cast<std::size_t>(at.rows()), kRows, [&](std::size_t begin, std::size_t end) {
        const auto first = static_cast<Index>(begin), count = static_cast<Index>(end - begin);
        add_block(at.middleRows(first, count), coefficients, result.middleRows(first, count));
    });
    return result;
}

} // namespace morph
