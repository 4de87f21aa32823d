#include "libmorph/basis/lattice.h"

#include "tests/support/errors.h"
#include "tests/support/lattices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace {

using namespace morph;
using test::all_kinds_of_lattices;
using test::kind;
using testing::HasSubstr;

// Sums of up to a thousand products of coordinates up to 22, in lattices of size 2.7.
constexpr double kRoundOff = 1e-13;

const std::vector<Eigen::Vector3d> kSomeParameters = {
    {0, 0, 0}, {1, 1, 1}, {0.137, 0.501, 0.873}, {0.3, 1, 0}, {0.99, 0.42, 0.05}};

double bernstein(int n, int i, double u)
{
    return std::tgamma(n + 1) / std::tgamma(i + 1) / std::tgamma(n - i + 1) * std::pow(u, i) *
           std::pow(1 - u, n - i);
}

TEST(Lattice, BasisFunctionsArePositiveAndSumToOne)
{
    for (const Lattice& lattice : all_kinds_of_lattices())
        for (const Eigen::Vector3d& u : kSomeParameters) {
            const LatticeRow row = lattice.basis(u);
            EXPECT_NEAR(std::accumulate(row.value.begin(), row.value.end(), 0.0), 1, 1e-14) << kind(lattice);
            EXPECT_GE(*std::min_element(row.value.begin(), row.value.end()), 0) << kind(lattice);
            EXPECT_TRUE(std::is_sorted(row.control.begin(), row.control.end()));
        }
}

TEST(Lattice, OfBernsteinPolynomialsIsTheTripleSumOfSederbergAndParry)
{
    LatticeDefinition shape = test::uneven_shape(3, LatticeBasis::bernstein, 3, 0, false);
    shape.degree = {3, 1, 12};
    shape.points = {4, 2, 13};
    const Lattice lattice = test::deformed_lattice(shape, 0.3);
    for (const Eigen::Vector3d& u : kSomeParameters) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (Index i = 0; i <= 3; ++i)
            for (Index j = 0; j <= 1; ++j)
                for (Index k = 0; k <= 12; ++k)
                    sum += bernstein(3, i, u[0]) * bernstein(1, j, u[1]) * bernstein(12, k, u[2]) *
                           lattice.definition().control_points.row(i + 4 * (j + 2 * k));
        EXPECT_LE((lattice.point(u) - sum.transpose()).norm(), kRoundOff) << u.transpose();
    }
}

TEST(Lattice, InABoxIsAffineWithoutWeights)
{
    Eigen::Matrix3d axes;
    axes << 2, 0.3, 0, -0.5, 1, 0, 0, 0, 1;
    for (const int dimension : {2, 3}) {
        if (dimension == 3)
            axes.col(2) << 0.2, -0.1, 3;
        for (const LatticeBasis basis : {LatticeBasis::bspline, LatticeBasis::bernstein}) {
            const Lattice lattice = lattice_on_axes({1, 2, dimension == 2 ? 0.0 : 3.0}, axes,
                                                    test::uneven_shape(dimension, basis, 3, 6, false));
            for (Eigen::Vector3d u : kSomeParameters) {
                if (dimension == 2)
                    u[2] = 0;
                const Eigen::Vector3d expected = Eigen::Vector3d(1, 2, dimension == 2 ? 0 : 3) + axes * u;
                EXPECT_LE((lattice.point(u) - expected).norm(), kRoundOff);
                EXPECT_LE((lattice.jacobian(u) - axes).norm(), 100 * kRoundOff);
            }
        }
    }
    const Lattice box = lattice_in_box({-1, -2, -3}, {1, 3, 2}, LatticeDefinition{});
    EXPECT_EQ(box.point({0, 0, 0}), Eigen::Vector3d(-1, -2, -3));
    EXPECT_EQ(box.point({1, 1, 1}), Eigen::Vector3d(1, 3, 2));
    EXPECT_EQ(box.size(), Eigen::Vector3d(2, 5, 5).norm());
}

TEST(Lattice, FollowsAnAffineMapOfItsControlPoints)
{
    Eigen::Matrix3d A;
    A << 0.7, -1.3, 0, 0.4, 2.1, 0, 0, 0, 1.5;
    const Eigen::RowVector3d shift(5, -3, 0);
    for (const Lattice& lattice : all_kinds_of_lattices()) {
        const Points moved = (lattice.definition().control_points * A.transpose()).rowwise() + shift;
        const Lattice image = lattice.with_control_points(moved);
        for (const Eigen::Vector3d& u : kSomeParameters)
            EXPECT_LE((image.point(u) - (A * lattice.point(u) + shift.transpose())).norm(), kRoundOff)
                << kind(lattice);
    }
}

TEST(Lattice, JacobianAgreesWithCentralDifferences)
{
    constexpr double step = 1e-5;
    for (const Lattice& lattice : all_kinds_of_lattices())
        for (const Eigen::Vector3d& u :
             {Eigen::Vector3d(0.137, 0.501, 0.873), Eigen::Vector3d(0.91, 0.234, 0.052)})
            for (int d = 0; d < lattice.dimension(); ++d) {
                const Eigen::Vector3d to_side = step * Eigen::Vector3d::Unit(d);
                const Eigen::Vector3d slope =
                    (lattice.point(u + to_side) - lattice.point(u - to_side)) / (2 * step);
                // Rounding 1e-14 / step, and step^2 / 6 times third derivatives of up to 1e3.
                EXPECT_LE((lattice.jacobian(u).col(d) - slope).norm(), 1e-7) << kind(lattice);
            }
}

TEST(Lattice, AcrossASimpleKnotHasDegreeLessOneContinuousDerivatives)
{
    const Lattice lattice =
        test::deformed_lattice(test::uneven_shape(3, LatticeBasis::bspline, 2, 5, true), 0.3);
    const double knot = lattice.axis(1).knots()[3];
    constexpr double step = 1e-9;
    const Eigen::Matrix3d before = lattice.jacobian({0.3, knot - step, 0.6});
    const Eigen::Matrix3d after = lattice.jacobian({0.3, knot + step, 0.6});
    EXPECT_LE((after - before).norm(), 2 * step * 1e3); // second derivatives are below 1e3
}

TEST(Lattice, IsNotChangedByInsertingKnots)
{
    for (const int dimension : {2, 3})
        for (const bool rational : {false, true}) {
            const Lattice lattice = test::deformed_lattice(
                test::uneven_shape(dimension, LatticeBasis::bspline, 3, 6, rational), 0.3);
            for (int d = 0; d < dimension; ++d) {
                const Lattice finer = test::with_knot(test::with_knot(lattice, d, 0.37), d, 0.37);
                for (const Eigen::Vector3d& u : kSomeParameters)
                    EXPECT_LE((finer.point(u) - lattice.point(u)).norm(), kRoundOff) << d;
            }
        }
}

TEST(Lattice, IsNotChangedByElevatingTheDegree)
{
    for (const int dimension : {2, 3})
        for (const bool rational : {false, true}) {
            const Lattice lattice = test::deformed_lattice(
                test::uneven_shape(dimension, LatticeBasis::bernstein, 3, 0, rational), 0.3);
            for (int d = 0; d < dimension; ++d) {
                const Lattice higher = test::with_degree_elevated(lattice, d);
                for (const Eigen::Vector3d& u : kSomeParameters)
                    EXPECT_LE((higher.point(u) - lattice.point(u)).norm(), kRoundOff) << d;
            }
        }
}

TEST(Lattice, EqualWeightsAreNoWeights)
{
    const Lattice lattice =
        test::deformed_lattice(test::uneven_shape(3, LatticeBasis::bspline, 3, 5, false), 0.3);
    const Lattice rational = lattice.with_weights(
        std::vector<double>(static_cast<std::size_t>(lattice.control_point_count()), 3.0));
    for (const Eigen::Vector3d& u : kSomeParameters)
        EXPECT_LE((rational.point(u) - lattice.point(u)).norm(), kRoundOff);
}

TEST(Lattice, NamesControlPointsByTheirThreeIndices)
{
    const Lattice lattice = lattice_in_box({0, 0, 0}, {1, 1, 1}, {.points = {4, 5, 6}});
    EXPECT_EQ(lattice.row_of(1, 2, 3), 1 + 4 * (2 + 5 * 3));
    EXPECT_EQ(lattice.indices_of(lattice.row_of(3, 4, 5)), (std::array<Index, 3>{3, 4, 5}));
}

std::string refusal(const LatticeDefinition& shape, const Eigen::Vector3d& high = {1, 1, 1})
{
    return test::message_of([&] { lattice_in_box({0, 0, 0}, high, shape); });
}

TEST(Lattice, RefusesDegreesAndNumbersOfPointsThatDoNotGoTogether)
{
    EXPECT_EQ(refusal({.dimension = 4}), "a lattice has dimension 2 or 3, not 4");
    EXPECT_EQ(refusal({.points = {4, 3, 4}}),
              "lattice along j: degree 3 needs at least 4 control points, but there are 3");
    EXPECT_EQ(refusal({.basis = LatticeBasis::bernstein, .points = {4, 4, 5}}),
              "lattice along k: degree 3 needs 4 control points (Bernstein polynomials), but there are 5");
    EXPECT_EQ(refusal({.degree = {0, 3, 3}}), "lattice along i: degree 0 is not supported; expected 1 to 7");
    EXPECT_EQ(refusal({.basis = LatticeBasis::bernstein, .degree = {32, 3, 3}, .points = {33, 4, 4}}),
              "lattice along i: degree 32 is not supported; expected 1 to 31");
    EXPECT_THAT(refusal({.points = {2'000'000, 2'000'000, 2'000'000}}), HasSubstr("is too large"));
    EXPECT_EQ(refusal({.dimension = 2, .degree = {3, 3, -5}, .points = {4, 4, 0}}), "nothing was thrown")
        << "k does not count in the plane";
}

TEST(Lattice, RefusesBrokenKnots)
{
    LatticeDefinition shape{.points = {4, 5, 4}};
    shape.knots[1] = {0, 0, 0, 0, 1, 1, 1, 1};
    EXPECT_EQ(refusal(shape), "lattice along j: there are 8 knots; degree 3 with 5 control points has 9");
    shape.knots[1] = {0, 0, 0, 0, -0.5, 1, 1, 1, 1};
    EXPECT_THAT(refusal(shape), HasSubstr("lattice along j: knot 5 (-0.5) is less than"));
    shape.knots[1] = {0, 0, 0, 0.1, 0.5, 1, 1, 1, 1};
    EXPECT_THAT(refusal(shape), HasSubstr("lattice along j: clamped knots of degree 3 repeat the first"));
    shape.knots[1] = {0, 0, 0, 0, 0, 1, 1, 1, 1};
    EXPECT_THAT(refusal(shape), HasSubstr("lattice along j: the knot 0 is repeated 5 times"));
    shape.knots[1] = {2, 2, 2, 2, 3, 7, 7, 7, 7};
    EXPECT_EQ(refusal(shape), "nothing was thrown") << "another interval than [0, 1] is mapped to it";
    shape = {.basis = LatticeBasis::bernstein};
    shape.knots[0] = {0, 0, 0, 0, 1, 1, 1, 1};
    EXPECT_EQ(refusal(shape), "lattice along i: Bernstein polynomials take no knots");
}

TEST(Lattice, RefusesABoxWithoutVolume)
{
    EXPECT_EQ(refusal({}, {1, 0, 1}), "the control points of the lattice enclose no volume");
    EXPECT_EQ(refusal({.dimension = 2}, {1, 0, 1}), "the control points of the lattice enclose no area");
    EXPECT_EQ(refusal({.dimension = 2}, {1, 1, 0}), "nothing was thrown");
    EXPECT_EQ(refusal({}, {1, 1e-6, 1e3}), "nothing was thrown") << "thin is not flat";
    Eigen::Matrix3d flat;
    flat << 1, 0, 1, 0, 1, 1, 0, 0, 0;
    EXPECT_THAT(test::message_of([&] { lattice_on_axes({0, 0, 0}, flat, {}); }), HasSubstr("no volume"));
}

TEST(Lattice, RefusesBrokenPointsAndWeights)
{
    const Lattice good = lattice_in_box({0, 0, 0}, {1, 1, 1}, {});
    Points P = good.definition().control_points;
    P(good.row_of(1, 2, 3), 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(test::message_of([&] { good.with_control_points(P); }),
              "control point (1, 2, 3) of the lattice is not finite");
    EXPECT_EQ(test::message_of([&] { good.with_control_points(P.topRows(63)); }),
              "there are 63 control points for a lattice of 64");
    EXPECT_THAT(test::message_of([&] {
                    good.with_weights({1, 2});
                }),
                HasSubstr("2 weights for a lattice of 64"));
    for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
        std::vector<double> weights(64, 1.0);
        weights[static_cast<std::size_t>(good.row_of(3, 0, 1))] = bad;
        EXPECT_THAT(test::message_of([&] { good.with_weights(weights); }),
                    HasSubstr("the weight of control point (3, 0, 1) of the lattice is "));
    }
}

} // namespace
