#include "libmorph/deform/shape_measures.h"

#include <cassert>
#include <utility>

namespace morph {

namespace {

using SparseRow = Eigen::SparseMatrix<double, Eigen::RowMajor, Index>::InnerIterator;
using Kind = ShapeMeasure::Kind;

Index next_node(Index i, Index count)
{
    return i + 1 < count ? i + 1 : 0;
}

/// From the first node, so that a small shape far from the origin keeps its digits.
double signed_area(const Points& polygon)
{
    double twice = 0;
    for (Index i = 1; i + 1 < polygon.rows(); ++i) {
        const Eigen::RowVector3d a = polygon.row(i) - polygon.row(0);
        const Eigen::RowVector3d b = polygon.row(i + 1) - polygon.row(0);
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

/// dA/dx_i = (y_next - y_previous) / 2 and dA/dy_i likewise, carried to the control points.
Eigen::VectorXd area_gradient(const ControlledPoints& shape, const Points& polygon)
{
    const auto count = static_cast<Index>(polygon.rows());
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * shape.weights.cols());
    for (Index before = count - 2, i = count - 1, next = 0; next < count; before = i, i = next++) {
        const Eigen::RowVector3d chord = (polygon.row(next) - polygon.row(before)) / 2;
        for (SparseRow weight(shape.weights, i); weight; ++weight) {
            gradient[2 * weight.col()] += weight.value() * chord.y();
            gradient[2 * weight.col() + 1] -= weight.value() * chord.x();
        }
    }
    return gradient;
}

/// The area is quadratic in the displacements: its second derivative by x_k and y_l is constant, the one by
/// two x or two y is 0.
Eigen::MatrixXd area_mixed(const ControlledPoints& shape)
{
    const Eigen::Index K = shape.weights.cols();
    const auto count = static_cast<Index>(shape.weights.rows());
    Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(K, K);
    for (Index i = 0; i < count; ++i)
        for (SparseRow a(shape.weights, i); a; ++a)
            for (SparseRow b(shape.weights, next_node(i, count)); b; ++b) {
                mixed(a.col(), b.col()) += a.value() * b.value() / 2;
                mixed(b.col(), a.col()) -= a.value() * b.value() / 2;
            }
    return mixed;
}

Eigen::VectorXd carried_gradient(const ControlledPoints& shape, const LocalMeasure& local,
                                 Eigen::Index components)
{
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(shape.weights.cols() * components);
    for (std::size_t p = 0; p < local.points.size(); ++p)
        for (SparseRow weight(shape.weights, local.points[p]); weight; ++weight)
            gradient.segment(weight.col() * components, components) +=
                weight.value() *
                local.gradient.segment(static_cast<Eigen::Index>(p) * components, components);
    return gradient;
}

void add_carried_hessian(const ControlledPoints& shape, const LocalMeasure& local, Eigen::Index c,
                         double factor, Eigen::MatrixXd& hessian)
{
    const auto count = static_cast<Eigen::Index>(local.points.size());
    for (Eigen::Index p = 0; p < count; ++p)
        for (Eigen::Index q = 0; q < count; ++q) {
            const Eigen::MatrixXd block = factor * local.hessian.block(p * c, q * c, c, c);
            for (SparseRow a(shape.weights, local.points[static_cast<std::size_t>(p)]); a; ++a)
                for (SparseRow b(shape.weights, local.points[static_cast<std::size_t>(q)]); b; ++b)
                    hessian.block(a.col() * c, b.col() * c, c, c) += a.value() * b.value() * block;
        }
}

void add_area_hessian(const Eigen::MatrixXd& mixed, double factor, Eigen::MatrixXd& hessian)
{
    for (Eigen::Index k = 0; k < mixed.rows(); ++k)
        for (Eigen::Index l = 0; l < mixed.cols(); ++l) {
            hessian(2 * k, 2 * l + 1) += factor * mixed(k, l);
            hessian(2 * l + 1, 2 * k) += factor * mixed(k, l);
        }
}

} // namespace

ShapeMeasures::ShapeMeasures(std::vector<ControlledPoints> shapes, std::vector<ShapeMeasure> measures,
                             Eigen::Index components)
    : shapes_(std::move(shapes)), measures_(std::move(measures)), mixed_(measures_.size()),
      components_(components)
{
    for (std::size_t j = 0; j < measures_.size(); ++j) {
        assert(components == 2 || measures_[j].kind == Kind::distance);
        if (measures_[j].kind == Kind::area)
            mixed_[j] = area_mixed(shapes_[measures_[j].shape]);
    }
}

std::vector<Points> ShapeMeasures::moved_shapes(const Matrix& D) const
{
    std::vector<Points> result;
    result.reserve(shapes_.size());
    for (const ControlledPoints& shape : shapes_)
        result.push_back(moved(shape, D));
    return result;
}

LocalMeasure ShapeMeasures::local_measure(const ShapeMeasure& measure, const std::vector<Points>& moved) const
{
    const Points& shape = moved[measure.shape];
    return measure.kind == Kind::extent ? extent_along(shape, measure.at, measure.along)
                                        : distance_between(shape, components_);
}

ShapeMeasures::Values ShapeMeasures::at(const Matrix& D) const
{
    const std::vector<Points> moved = moved_shapes(D);
    const auto count = static_cast<Eigen::Index>(measures_.size());
    Values result{Eigen::VectorXd(count), Eigen::MatrixXd(count, D.size())};
    for (Eigen::Index j = 0; j < count; ++j) {
        const ShapeMeasure& measure = measures_[static_cast<std::size_t>(j)];
        const ControlledPoints& shape = shapes_[measure.shape];
        if (measure.kind == Kind::area) {
            result.values[j] = measure.turn * signed_area(moved[measure.shape]);
            result.jacobian.row(j) = measure.turn * area_gradient(shape, moved[measure.shape]);
        } else {
            const LocalMeasure local = local_measure(measure, moved);
            result.values[j] = local.value;
            result.jacobian.row(j) = carried_gradient(shape, local, components_);
        }
    }
    return result;
}

void ShapeMeasures::add_hessian(const Matrix& D, const Eigen::VectorXd& factors,
                                Eigen::MatrixXd& hessian) const
{
    const std::vector<Points> moved = moved_shapes(D);
    for (std::size_t j = 0; j < measures_.size(); ++j) {
        const ShapeMeasure& measure = measures_[j];
        const double factor = factors[static_cast<Eigen::Index>(j)];
        if (factor == 0)
            continue;
        if (measure.kind == Kind::area)
            add_area_hessian(mixed_[j], measure.turn * factor, hessian);
        else
            add_carried_hessian(shapes_[measure.shape], local_measure(measure, moved), components_, factor,
                                hessian);
    }
}

} // namespace morph
