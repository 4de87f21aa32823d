#include "libmorph/deform/shape_measures.h"
#include "tests/support/curves.h"
#include "tests/support/weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace {

using namespace morph;
using Kind = ShapeMeasure::Kind;

// Some hundred sums and products of numbers of size 1.
constexpr double kRoundOff = 1e-13;

/// The area of a wobbly boundary and the distance of two points, carried by 9 control points.
struct Shapes {
    ControlledPoints boundary = test::nodes_on(Curve(test::wobbly_curve(3, 9, true, true, 7)), 200);
    ControlledPoints ends = test::nodes_on(Curve(test::wobbly_curve(3, 9, true, true, 11)), 2);
    ShapeMeasures measures{{boundary, ends}, {{Kind::area, 0, {}, {}}, {Kind::distance, 1, {}, {}}}, 2};
};

Matrix some_displacements()
{
    return 0.1 * Matrix::Random(9, 2);
}

/// Largest relative error of the central differences of a row of functions against their derivatives.
double difference_error(const std::function<Eigen::VectorXd(const Matrix&)>& f,
                        const Eigen::MatrixXd& derivative, const Matrix& at, double step)
{
    Eigen::MatrixXd difference(derivative.rows(), derivative.cols());
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        Matrix ahead = at;
        Matrix behind = at;
        ahead.data()[k] += step;
        behind.data()[k] -= step;
        difference.col(k) = (f(ahead) - f(behind)) / (2 * step);
    }
    return (difference - derivative).norm() / derivative.norm();
}

TEST(ShapeMeasures, OfASquareAreItsAreaWidthAndDiagonal)
{
    ControlledPoints square{Points::Zero(4, 3), {4, 0}};
    square.positions << 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0;
    ControlledPoints ends{square.positions({0, 2}, Eigen::all), {2, 0}};
    const double half = std::sqrt(0.5);
    const ShapeMeasures measures({square, ends},
                                 {{Kind::area, 0, {}, {}},
                                  {Kind::extent, 0, {0.3, 5}, {0, 1}},
                                  {Kind::extent, 0, {0, 0}, {half, half}},
                                  {Kind::extent, 0, {3, 0}, {0, 1}},
                                  {Kind::distance, 1, {}, {}}},
                                 2);
    const Eigen::VectorXd values = measures.at(Matrix(0, 2)).values;
    EXPECT_NEAR(values[0], 4, kRoundOff);
    EXPECT_NEAR(values[1], 2, kRoundOff);
    EXPECT_NEAR(values[2], 2 * std::numbers::sqrt2, kRoundOff);
    EXPECT_TRUE(std::isnan(values[3])); // the line passes by
    EXPECT_NEAR(values[4], 2 * std::numbers::sqrt2, kRoundOff);
}

TEST(ShapeMeasures, TakeTheWholeExtentOfAShapeThatALineCrossesFourTimes)
{
    ControlledPoints hook{Points::Zero(8, 3), {8, 0}};
    hook.positions << 0, 0, 0, 4, 0, 0, 4, 1, 0, 1, 1, 0, 1, 3, 0, 4, 3, 0, 4, 4, 0, 0, 4, 0;
    const ShapeMeasures measures({hook}, {{Kind::extent, 0, {2, 0}, {0, 1}}}, 2);
    EXPECT_NEAR(measures.at(Matrix(0, 2)).values[0], 4, kRoundOff);
}

TEST(ShapeMeasures, ScaleAndTranslateAsLengthsAndAreasDo)
{
    ControlledPoints ring = test::nodes_on(test::ellipse_curve(8, 1), 100);
    const ShapeMeasures near({ring}, {{Kind::area, 0, {}, {}}, {Kind::extent, 0, {0.5, 0}, {0, 1}}}, 2);
    const Eigen::VectorXd values = near.at(Matrix::Zero(8, 2)).values;
    for (const double scale : {1e-3, 1e3}) {
        ControlledPoints other = ring;
        other.positions *= scale;
        other.positions.col(0).array() += 10 * scale;
        const ShapeMeasures far({other},
                                {{Kind::area, 0, {}, {}}, {Kind::extent, 0, {10.5 * scale, 0}, {0, 1}}}, 2);
        const Eigen::VectorXd scaled = far.at(Matrix::Zero(8, 2)).values;
        EXPECT_NEAR(scaled[0] / (scale * scale), values[0], kRoundOff);
        EXPECT_NEAR(scaled[1] / scale, values[1], kRoundOff);
    }
}

// The error of central differences falls with the square of the step until rounding over the step takes over:
// both are below 1e-8 at 1e-5. The area is quadratic, so that its differences are exact.
TEST(ShapeMeasures, HaveTheGradientsOfTheirDifferences)
{
    const Shapes shapes;
    const Matrix D = some_displacements();
    const Eigen::MatrixXd jacobian = shapes.measures.at(D).jacobian;
    const auto area = [&](const Matrix& at) -> Eigen::VectorXd {
        return shapes.measures.at(at).values.head(1);
    };
    const auto distance = [&](const Matrix& at) -> Eigen::VectorXd {
        return shapes.measures.at(at).values.tail(1);
    };
    EXPECT_LE(difference_error(area, jacobian.row(0), D, 1e-1), 1e-12);
    EXPECT_LE(difference_error(distance, jacobian.row(1), D, 1e-5), 1e-8);
    const double ratio = difference_error(distance, jacobian.row(1), D, 1e-2) /
                         difference_error(distance, jacobian.row(1), D, 1e-3);
    EXPECT_NEAR(std::log10(ratio), 2, 0.1);
}

TEST(ShapeMeasures, HaveTheSecondDerivativesOfTheirGradients)
{
    const Shapes shapes;
    const Matrix D = some_displacements();
    for (Eigen::Index j = 0; j < 2; ++j) {
        Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(18, 18);
        shapes.measures.add_hessian(D, 3 * Eigen::VectorXd::Unit(2, j), hessian);
        const auto gradient = [&](const Matrix& at) -> Eigen::VectorXd {
            return 3 * shapes.measures.at(at).jacobian.row(j).transpose();
        };
        EXPECT_LE(difference_error(gradient, hessian, D, 1e-5), 1e-8) << j;
        EXPECT_LE((hessian - hessian.transpose()).norm(), kRoundOff * hessian.norm()) << j;
    }
}

/// Parameter in [low, high] where a curve passes the line x = at.
double parameter_at(const Curve& curve, double x, double low, double high)
{
    const bool falls = curve.point(low).x() > curve.point(high).x();
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        ((curve.point(middle).x() > x) == falls ? low : high) = middle;
    }
    return low;
}

/// Derivative by the displacements of the height at x of the curve at @p u: a control point lifts it by its
/// basis function, and a shift of the curve moves another height there.
Eigen::RowVectorXd height_gradient(const Curve& curve, double u)
{
    Eigen::RowVectorXd gradient = Eigen::RowVectorXd::Zero(curve.definition().control_points.size());
    const auto derivative = curve.derivatives(u, 1)[1];
    const BasisRow basis = curve.basis(u);
    for (std::size_t k = 0; k < static_cast<std::size_t>(basis.count); ++k) {
        gradient.segment<2>(Eigen::Index{2} * basis.control[k])
            << -basis.value[k] * derivative.y() / derivative.x(),
            basis.value[k];
    }
    return gradient;
}

// Polygons with sides of length h differ from the curve by h^2.
TEST(ShapeMeasures, HaveExtentsAndTheirGradientsThatTendToThoseOfTheCurve)
{
    const Curve curve = test::ellipse_curve(12, 0.3);
    const double x = 0.313;
    const double above = parameter_at(curve, x, 0, 0.5);
    const double below = parameter_at(curve, x, 0.5, 1);
    const double extent = curve.point(above).y() - curve.point(below).y();
    const Eigen::RowVectorXd gradient = height_gradient(curve, above) - height_gradient(curve, below);
    const auto errors = [&](Index nodes) {
        const ShapeMeasures measures({test::nodes_on(curve, nodes)}, {{Kind::extent, 0, {x, 7}, {0, 1}}}, 2);
        const ShapeMeasures::Values found = measures.at(Matrix::Zero(12, 2));
        return Eigen::Array2d(std::abs(found.values[0] - extent) / extent,
                              (found.jacobian.row(0) - gradient).norm() / gradient.norm());
    };
    const Eigen::Array2d coarse = errors(400);
    const Eigen::Array2d fine = errors(4000);
    EXPECT_LE(coarse.maxCoeff<Eigen::PropagateNaN>(), 1e-3);
    EXPECT_LE((fine / coarse).maxCoeff<Eigen::PropagateNaN>(), 1. / 50);
}

TEST(ShapeMeasures, HaveGradientsOfExtentsWithoutAJumpAtANode)
{
    const ControlledPoints nodes = test::nodes_on(test::ellipse_curve(12, 0.3), 100);
    const double x = nodes.positions(17, 0);
    const ShapeMeasures measures(
        {nodes}, {{Kind::extent, 0, {x - 1e-9, 0}, {0, 1}}, {Kind::extent, 0, {x + 1e-9, 0}, {0, 1}}}, 2);
    const Eigen::MatrixXd jacobian = measures.at(Matrix::Zero(12, 2)).jacobian;
    EXPECT_LE((jacobian.row(0) - jacobian.row(1)).norm(), 1e-6); // the slope of the sides jumps by 0.02
}

// The gradients of extents are smooth only up to the length h of the sides, here 1.6e-3.
TEST(ShapeMeasures, HaveSecondDerivativesOfExtentsUpToTheLengthOfTheSides)
{
    const Curve curve = test::ellipse_curve(12, 0.3);
    for (const Eigen::Vector2d& along : {Eigen::Vector2d(0, 1), Eigen::Vector2d(0.6, 0.8)}) {
        const ShapeMeasures measures({test::nodes_on(curve, 4000)}, {{Kind::extent, 0, {0.1, 0}, along}}, 2);
        const Matrix D = 0.02 * Matrix::Random(12, 2);
        Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(24, 24);
        measures.add_hessian(D, Eigen::VectorXd::Ones(1), hessian);
        const auto gradient = [&](const Matrix& at) -> Eigen::VectorXd {
            return measures.at(at).jacobian.row(0);
        };
        EXPECT_LE(difference_error(gradient, hessian, D, 1e-3), 2e-2) << along.transpose();
    }
}

TEST(ShapeMeasures, OfDistancesInSpaceHaveTheDerivativesOfTheirDifferences)
{
    ControlledPoints ends{Points::Random(2, 3), {2, 3}};
    ends.weights = Matrix(Matrix::Random(2, 3)).sparseView();
    const ShapeMeasures measures({ends}, {{Kind::distance, 0, {}, {}}}, 3);
    const Matrix D = Matrix::Random(3, 3);
    const auto values = [&](const Matrix& at) { return measures.at(at).values; };
    const auto gradient = [&](const Matrix& at) -> Eigen::VectorXd {
        return measures.at(at).jacobian.row(0);
    };
    Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(9, 9);
    measures.add_hessian(D, Eigen::VectorXd::Ones(1), hessian);
    EXPECT_LE(difference_error(values, measures.at(D).jacobian, D, 1e-5), 1e-8);
    EXPECT_LE(difference_error(gradient, hessian, D, 1e-5), 1e-8);
}

} // namespace
