#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/deform/apply.h"
#include "libmorph/deform/gradient.h"
#include "tests/support/errors.h"
#include "tests/support/weights.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace morph;
using ::testing::HasSubstr;

// Sums of up to 40000 products of numbers of size 1, as random as their rounding.
constexpr double kRoundOff = 1e-13;

/// A smooth objective of all vertices, neither linear nor quadratic, and its derivative.
double objective(const Points& x)
{
    return (x.col(0).array().sin() * (x.col(1).array() * 1.5).cos() + x.col(2).array().exp()).sum();
}

Matrix objective_gradient(const Points& x)
{
    Matrix gradient(x.rows(), 3);
    gradient.col(0) = x.col(0).array().cos() * (x.col(1).array() * 1.5).cos();
    gradient.col(1) = -1.5 * x.col(0).array().sin() * (x.col(1).array() * 1.5).sin();
    gradient.col(2) = x.col(2).array().exp();
    return gradient;
}

TEST(ControlPointGradient, IsTheProductWithTheTransposedWeights)
{
    constexpr Index kRows = 40'000; // more than one block
    const Weights weights = test::random_weights(kRows, 7);
    for (const int components : {2, 3}) {
        const Matrix gradient = Matrix::Random(kRows, components);
        const Matrix expected = weights.values.transpose() * gradient;
        EXPECT_LE((control_point_gradient(weights, gradient) - expected).norm(), kRoundOff * expected.norm())
            << components;
    }
}

TEST(ControlPointGradient, IsTheSameFromSparseWeights)
{
    const SparseWeights sparse = test::random_sparse_weights(1000, 20);
    const Matrix gradient = Matrix::Random(1000, 2);
    const Matrix expected = Matrix(sparse.values).transpose() * gradient;
    EXPECT_LE((control_point_gradient(sparse, gradient) - expected).norm(), kRoundOff * expected.norm());
}

// The error of central differences falls with the square of the step until round-off, eps |J| / step, takes
// over; at a step of 1e-4 both are below 1e-8 here.
TEST(ControlPointGradient, AgreesWithFiniteDifferencesOfTheMovedMesh)
{
    const Weights weights = test::random_weights(50, 4);
    const Points start = Points::Random(50, 3);
    const auto moved_objective = [&](const Matrix& D) {
        Points x = start;
        apply_weights(weights, D, {x.data(), x.rows(), 3});
        return objective(x);
    };
    const Matrix gradient = control_point_gradient(weights, objective_gradient(start));
    const auto error_at = [&](double step) {
        Matrix difference(4, 3);
        for (Eigen::Index k = 0; k < difference.size(); ++k) {
            Matrix D = Matrix::Zero(4, 3);
            D.data()[k] = step;
            difference.data()[k] = (moved_objective(D) - moved_objective(-D)) / (2 * step);
        }
        return (difference - gradient).norm() / gradient.norm();
    };
    EXPECT_LE(error_at(1e-4), 1e-8);
    const double rate = std::log10(error_at(1e-1) / error_at(1e-2));
    EXPECT_NEAR(rate, 2, 0.05); // of the central differences, so that what they tend to is the gradient
}

TEST(ControlPointGradient, GivesTheSameBytesForAnyThreadCount)
{
    const Weights weights = test::random_weights(100'000, 5);
    const Matrix gradient = Matrix::Random(100'000, 2);
    set_thread_count(1);
    const Matrix one = control_point_gradient(weights, gradient);
    set_thread_count(3);
    const Matrix three = control_point_gradient(weights, gradient);
    set_thread_count(0);
    EXPECT_EQ(one, three);
}

TEST(ControlPointGradient, OfNoVerticesIsZero)
{
    EXPECT_EQ(control_point_gradient(test::random_weights(0, 3), Matrix(0, 2)), Matrix::Zero(3, 2));
}

TEST(ControlPointGradient, RefusesSizesThatDoNotFit)
{
    const Weights weights = test::random_weights(10, 4);
    EXPECT_THAT(test::message_of([&] { control_point_gradient(weights, Matrix::Zero(9, 2)); }),
                HasSubstr("the gradient is 9 x 2, but the weights are for 10 vertices"));
    EXPECT_THROW(control_point_gradient(weights, Matrix::Zero(10, 1)), InputError);
}

} // namespace
