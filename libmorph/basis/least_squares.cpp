#include "libmorph/basis/least_squares.h"

#include "libmorph/core/error.h"

#include <Eigen/SparseCholesky>

#include <cassert>

namespace morph {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// A pivot this small, relative to the largest, is a control point that no data point holds.
constexpr double kSmallestPivot = 1e-14;

/// Rows of basis functions at the parameters, m x K.
SparseMatrix basis_matrix(const Curve& shape, const std::vector<double>& u)
{
    Triplets entries;
    entries.reserve(u.size() * (static_cast<std::size_t>(shape.degree()) + 1));
    for (std::size_t i = 0; i < u.size(); ++i) {
        const BasisRow row = shape.basis(u[i]);
        for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
            entries.emplace_back(static_cast<int>(i), row.control[k], row.value[k]);
    }
    SparseMatrix B(std::ssize(u), shape.control_point_count());
    B.setFromTriplets(entries.begin(), entries.end());
    return B;
}

/// The control point that alone decides the curve at a corner or an end.
Index deciding_point(const Curve& shape, double u)
{
    const BasisRow row = shape.basis(u);
    std::size_t largest = 0;
    for (std::size_t k = 1; k < static_cast<std::size_t>(row.count); ++k)
        if (row.value[k] > row.value[largest])
            largest = k;
    assert(row.value[largest] > 1 - 1e-9);
    return row.control[largest];
}

/// K x (number of free points): puts the free control points in their rows.
SparseMatrix free_columns(const std::vector<bool>& fixed)
{
    Triplets ones;
    int column = 0;
    for (std::size_t k = 0; k < fixed.size(); ++k)
        if (!fixed[k])
            ones.emplace_back(static_cast<int>(k), column++, 1.0);
    SparseMatrix S(std::ssize(fixed), column);
    S.setFromTriplets(ones.begin(), ones.end());
    return S;
}

} // namespace

Points2 least_squares_points(const Curve& shape, const Points2& points, const std::vector<double>& u,
                             const std::vector<Index>& interpolated)
{
    assert(points.rows() == std::ssize(u));
    const SparseMatrix B = basis_matrix(shape, u);
    Points2 control = Points2::Zero(shape.control_point_count(), 2);
    std::vector<bool> fixed(static_cast<std::size_t>(control.rows()));
    for (const Index row : interpolated) {
        const Index k = deciding_point(shape, u[static_cast<std::size_t>(row)]);
        fixed[static_cast<std::size_t>(k)] = true;
        control.row(k) = points.row(row);
    }
    const SparseMatrix S = free_columns(fixed);
    if (S.cols() == 0)
        return control;
    const SparseMatrix A = B * S;
    const SparseMatrix normal = A.transpose() * A;
    const Eigen::SimplicialLDLT<SparseMatrix> factor(normal);
    const auto pivots = factor.vectorD();
    if (factor.info() != Eigen::Success || !(pivots.minCoeff() > kSmallestPivot * pivots.maxCoeff()))
        throw InputError("the points do not determine the " + std::to_string(control.rows()) +
                         " control points of the curve: some of its spans hold too few of them");
    // The second pass takes back what the squared condition number of the normal equations has cost.
    for (int pass = 0; pass < 2; ++pass) {
        const Points2 residual = points - B * control;
        control += S * Points2(factor.solve(A.transpose() * residual));
    }
    return control;
}

} // namespace morph
