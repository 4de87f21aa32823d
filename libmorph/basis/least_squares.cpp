#include "libmorph/basis/least_squares.h"

#include "libmorph/core/error.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace morph {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

constexpr Index kFixed = -1;
// A pivot this small, relative to the largest, is a control point that no data point holds.
constexpr double kSmallestPivot = 1e-14;

/// Normal and tangent of the curve, rows of a rotation; the axes where it stands still.
Eigen::Matrix2d local_frame(const Eigen::Vector2d& derivative)
{
    const double speed = derivative.norm();
    Eigen::Matrix2d frame;
    if (speed > 0)
        frame << -derivative.y(), derivative.x(), derivative.x(), derivative.y();
    return speed > 0 ? Eigen::Matrix2d(frame / speed) : Eigen::Matrix2d::Identity();
}

/// The linear least-squares problem for the change of the free control points: two rows for each point,
/// two columns, x and y, for each free control point.
struct StepProblem {
    SparseMatrix matrix;
    Eigen::VectorXd residual;
};

StepProblem make_problem(const Curve& curve, const Points2& points, const std::vector<double>& u,
                         const std::vector<Index>& column, double tangential)
{
    const double scale = std::sqrt(tangential);
    StepProblem problem{{}, Eigen::VectorXd(2 * points.rows())};
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(4 * u.size() * (static_cast<std::size_t>(curve.degree()) + 1));
    for (Eigen::Index i = 0; i < std::ssize(u); ++i) {
        const double at = u[static_cast<std::size_t>(i)];
        const auto d = curve.derivatives(at, 1);
        Eigen::Matrix2d frame = local_frame(d[1]);
        frame.row(1) *= scale;
        problem.residual.segment<2>(2 * i) = frame * (points.row(i).transpose() - d[0]);
        const BasisRow basis = curve.basis(at);
        for (std::size_t k = 0; k < static_cast<std::size_t>(basis.count); ++k)
            if (const Index free = column[static_cast<std::size_t>(basis.control[k])]; free != kFixed)
                for (const int row : {0, 1})
                    for (const int axis : {0, 1})
                        entries.emplace_back(static_cast<int>(2 * i) + row, 2 * free + axis,
                                             basis.value[k] * frame(row, axis));
    }
    const Eigen::Index free_count = *std::max_element(column.begin(), column.end()) + 1;
    problem.matrix.resize(2 * points.rows(), 2 * free_count);
    problem.matrix.setFromTriplets(entries.begin(), entries.end());
    return problem;
}

Eigen::VectorXd solve(const StepProblem& problem)
{
    const SparseMatrix normal = problem.matrix.transpose() * problem.matrix;
    const Eigen::SimplicialLDLT<SparseMatrix> factor(normal);
    const bool definite = factor.info() == Eigen::Success &&
                          factor.vectorD().minCoeff() > kSmallestPivot * factor.vectorD().maxCoeff();
    if (!definite)
        throw InputError(
            "the points do not determine the control points of the curve: some of its spans hold "
            "too few of them");
    return factor.solve(problem.matrix.transpose() * problem.residual);
}

/// The control point that alone decides the curve at a corner or an end.
Index deciding_point(const Curve& curve, double u)
{
    const BasisRow row = curve.basis(u);
    const auto largest = std::max_element(row.value.begin(), row.value.end());
    assert(*largest > 1 - 1e-9);
    return row.control[static_cast<std::size_t>(largest - row.value.begin())];
}

} // namespace

Points2 fitting_step(const Curve& curve, const Points2& points, const std::vector<double>& u,
                     const std::vector<Index>& interpolated, double tangential)
{
    assert(points.rows() == std::ssize(u));
    Points2 control = curve.definition().control_points;
    std::vector<Index> column(static_cast<std::size_t>(control.rows()), 0);
    for (const Index row : interpolated) {
        const Index k = deciding_point(curve, u[static_cast<std::size_t>(row)]);
        column[static_cast<std::size_t>(k)] = kFixed;
        control.row(k) = points.row(row);
    }
    Index free = 0;
    for (Index& c : column)
        c = c == kFixed ? kFixed : free++;
    if (free == 0)
        return control;
    const Eigen::VectorXd step =
        solve(make_problem(curve.with_control_points(control), points, u, column, tangential));
    for (std::size_t k = 0; k < column.size(); ++k)
        if (column[k] != kFixed)
            control.row(static_cast<Eigen::Index>(k)) +=
                step.segment<2>(Eigen::Index{2} * column[k]).transpose();
    return control;
}

Points2 least_squares_points(const Curve& shape, const Points2& points, const std::vector<double>& u,
                             const std::vector<Index>& interpolated)
{
    // The second pass takes back what the squared condition number of the normal equations has cost.
    const Points2 first = fitting_step(shape, points, u, interpolated, 1);
    return fitting_step(shape.with_control_points(first), points, u, interpolated, 1);
}

} // namespace morph
