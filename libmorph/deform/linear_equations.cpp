#include "libmorph/deform/linear_equations.h"

#include <Eigen/QR>

#include <algorithm>
#include <map>

namespace morph {

namespace {

constexpr double kDependent = 1e-10; ///< of the largest pivot: rows that depend on others
constexpr double kNothing = 1e-12;   ///< length of a row that moves nothing
constexpr double kInvolved = 1e-6;   ///< part that an equation has in a contradiction, of the largest part

} // namespace

SolutionSpace::SolutionSpace(const std::vector<LinearEquation>& equations, const Eigen::VectorXd& wanted,
                             double tolerance)
    : equations_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(equations.size()), wanted.size())),
      base_(wanted)
{
    Eigen::VectorXd values(equations_.rows());
    for (Eigen::Index i = 0; i < equations_.rows(); ++i) {
        const LinearEquation& equation = equations[static_cast<std::size_t>(i)];
        for (const auto& [unknown, coefficient] : equation.terms)
            equations_(i, unknown) += coefficient;
        const double length = equations_.row(i).norm();
        equations_.row(i) *= length > kNothing ? 1 / length : 0;
        values[i] = equation.value * (length > kNothing ? 1 / length : 1);
        sources_.push_back(equation.source);
    }
    if (wanted.size() == 0 && equations_.rows() > 0)
        clash_ = values.cwiseAbs().maxCoeff() > tolerance ? by_part(values) : clash_;
    else if (equations_.rows() > 0)
        find_base(values, tolerance);
}

/// With A^T P = Q R, the rows that the pivots choose decide base = wanted + Q1 w, R1^T w = P^T (b - A
/// wanted).
void SolutionSpace::find_base(const Eigen::VectorXd& values, double tolerance)
{
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
    qr.setThreshold(kDependent);
    qr.compute(equations_.transpose());
    const Eigen::Index rank = qr.rank();
    const Eigen::MatrixXd Q = qr.householderQ();
    directions_ = Q.rightCols(Q.cols() - rank);
    const auto R = qr.matrixR().topLeftCorner(rank, rank).triangularView<Eigen::Upper>();
    const Eigen::VectorXd chosen =
        (qr.colsPermutation().transpose() * (values - equations_ * base_)).head(rank);
    base_ += Q.leftCols(rank) * R.transpose().solve(chosen);
    const Eigen::VectorXd residual = values - equations_ * base_;
    if (residual.cwiseAbs().maxCoeff() <= tolerance)
        return;
    const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> nearest(equations_);
    base_ += nearest.solve(residual);
    clash_ = by_part(values - equations_ * base_);
}

/// A residual r that least squares leave has A^T r = 0: r combines the equations to 0 = r^T b, which is not
/// 0.
std::vector<std::size_t> SolutionSpace::by_part(const Eigen::VectorXd& parts) const
{
    std::map<std::size_t, double> part_of;
    for (std::size_t i = 0; i < sources_.size(); ++i)
        part_of[sources_[i]] += std::abs(parts[static_cast<Eigen::Index>(i)]);
    std::vector<std::size_t> result;
    for (const auto& [source, part] : part_of)
        if (part > kInvolved * parts.cwiseAbs().maxCoeff())
            result.push_back(source);
    std::stable_sort(result.begin(), result.end(),
                     [&](std::size_t a, std::size_t b) { return part_of[a] > part_of[b]; });
    return result;
}

std::vector<std::size_t> SolutionSpace::sources_of(const Eigen::VectorXd& form) const
{
    if (equations_.size() == 0)
        return {};
    const Eigen::MatrixXd columns = equations_.transpose();
    return by_part(columns.completeOrthogonalDecomposition().solve(form));
}

Eigen::VectorXd SolutionSpace::at(const Eigen::VectorXd& y) const
{
    if (equations_.rows() == 0)
        return base_ + y;
    return base_ + directions_ * y;
}

Eigen::MatrixXd SolutionSpace::restrict_rows(const Eigen::MatrixXd& rows) const
{
    if (equations_.rows() == 0)
        return rows;
    return rows * directions_;
}

Eigen::MatrixXd SolutionSpace::restrict_form(const Eigen::MatrixXd& form) const
{
    if (equations_.rows() == 0)
        return form;
    return directions_.transpose() * form * directions_;
}

} // namespace morph
