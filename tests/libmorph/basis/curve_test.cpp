#include "libmorph/basis/curve.h"

#include "formats/csv/table.h"
#include "libmorph/core/error.h"
#include "tests/support/curves.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace morph;
using test::wobbly_curve;

// Sums of at most eight products of numbers near 1.
constexpr double kRoundOff = 1e-14;

/// One curve of each degree, open and closed, polynomial and rational.
std::vector<Curve> all_kinds()
{
    std::vector<Curve> curves;
    for (int degree = 1; degree <= kMaxDegree; ++degree)
        for (const bool closed : {false, true})
            for (const bool rational : {false, true})
                curves.emplace_back(wobbly_curve(degree, degree + 5, closed, rational, 17));
    return curves;
}

std::string kind(const Curve& curve)
{
    return std::string(curve.closed() ? "closed" : "open") + ", degree " + std::to_string(curve.degree()) +
           (curve.definition().weights.empty() ? "" : ", rational");
}

/// N_{i,p}(u) straight from its definition (method.md, section 1), with 0/0 = 0.
double cox_de_boor(const std::vector<double>& t, int i, int p, double u)
{
    const auto knot = [&](int k) { return t[static_cast<std::size_t>(k)]; };
    if (p == 0)
        return knot(i) <= u && u < knot(i + 1) ? 1 : 0;
    double sum = 0;
    if (knot(i + p) > knot(i))
        sum += (u - knot(i)) / (knot(i + p) - knot(i)) * cox_de_boor(t, i, p - 1, u);
    if (knot(i + p + 1) > knot(i + 1))
        sum += (knot(i + p + 1) - u) / (knot(i + p + 1) - knot(i + 1)) * cox_de_boor(t, i + 1, p - 1, u);
    return sum;
}

std::string message_of(CurveDefinition definition)
{
    try {
        const Curve curve(std::move(definition));
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Curve, ReproducesTable512OfTheThesis)
{
    const Curve curve(test::thesis_case_1());
    const Matrix table = csv_columns(read_csv_table(test::data_path("thesis/table_5_1_2.csv")),
                                     {"u", "x", "y", "n1", "n2", "n3", "n4"});
    ASSERT_EQ(table.rows(), 100);
    for (const auto& row : table.rowwise()) {
        // The printed u drifts in the sixth decimal from the hundredths it stands for.
        const double u = std::round(100 * row(0)) / 100;
        EXPECT_NEAR(u, row(0), 2e-6);
        EXPECT_LE((curve.point(u) - Eigen::Vector2d(row(1), row(2))).cwiseAbs().maxCoeff(), 2e-5)
            << "u = " << u;
        Eigen::Vector4d N = Eigen::Vector4d::Zero();
        const BasisRow basis = curve.basis(u);
        for (std::size_t k = 0; k < 3; ++k)
            N(basis.control[k]) += basis.value[k];
        EXPECT_LE((N - row.tail<4>().transpose()).cwiseAbs().maxCoeff(), 3e-6) << "u = " << u;
    }
}

TEST(Curve, BasisFunctionsArePositiveSumToOneAndNameDistinctPoints)
{
    for (const Curve& curve : all_kinds())
        for (int i = 0; i <= 200; ++i) {
            const BasisRow row = curve.basis(i / 200.0);
            ASSERT_EQ(row.count, curve.degree() + 1);
            double sum = 0;
            std::vector<bool> seen(static_cast<std::size_t>(curve.control_point_count()));
            for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k) {
                EXPECT_GE(row.value[k], 0) << kind(curve);
                EXPECT_FALSE(seen.at(static_cast<std::size_t>(row.control[k]))) << kind(curve);
                seen[static_cast<std::size_t>(row.control[k])] = true;
                sum += row.value[k];
            }
            EXPECT_NEAR(sum, 1, kRoundOff) << kind(curve);
        }
}

TEST(Curve, BasisFunctionsEqualTheirRecursiveDefinition)
{
    for (int degree = 1; degree <= kMaxDegree; ++degree)
        for (const bool closed : {false, true}) {
            const Curve curve(wobbly_curve(degree, degree + 4, closed, false, 3));
            for (int i = 0; i < 97; ++i) {
                const double u = i / 97.0;
                std::vector<double> expected(static_cast<std::size_t>(degree + 4));
                for (int k = 0; k + degree + 1 < std::ssize(curve.knots()); ++k)
                    expected[static_cast<std::size_t>(k % (degree + 4))] +=
                        cox_de_boor(curve.knots(), k, degree, u);
                const BasisRow row = curve.basis(u);
                for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
                    EXPECT_NEAR(row.value[k], expected[static_cast<std::size_t>(row.control[k])], kRoundOff);
            }
        }
}

TEST(Curve, SpanJOfAClosedCurveIsShapedByPointsJToJPlusDegree)
{
    const Curve curve(wobbly_curve(3, 9, true, false, 5));
    for (Index j = 0; j < 9; ++j) {
        const std::vector<double>& knots = curve.definition().knots;
        const auto at = static_cast<std::size_t>(j);
        const BasisRow row = curve.basis(0.5 * (knots[at] + knots[at + 1]));
        for (Index k = 0; k <= 3; ++k)
            EXPECT_EQ(row.control[static_cast<std::size_t>(k)], (j + k) % 9);
    }
}

TEST(Curve, WithoutInnerKnotsIsTheBernsteinCurve)
{
    for (int p = 1; p <= kMaxDegree; ++p) {
        CurveDefinition definition = wobbly_curve(p, p + 1, false, false, 8);
        definition.knots.clear();
        const BasisRow row = Curve(definition).basis(0.3);
        for (int k = 0; k <= p; ++k) {
            const double binomial = std::tgamma(p + 1) / std::tgamma(k + 1) / std::tgamma(p - k + 1);
            EXPECT_NEAR(row.value[static_cast<std::size_t>(k)],
                        binomial * std::pow(0.3, k) * std::pow(0.7, p - k), kRoundOff);
        }
    }
}

TEST(Curve, DerivativesAgreeWithCentralDifferences)
{
    constexpr double step = 1e-4;
    for (const Curve& curve : all_kinds())
        for (const double u : {0.137, 0.501, 0.873})
            for (std::size_t k = 1; k <= 3; ++k) {
                const auto before = curve.derivatives(u - step, 2)[k - 1];
                const auto after = curve.derivatives(u + step, 2)[k - 1];
                const Eigen::Vector2d exact = curve.derivatives(u, 3)[k];
                // The error is step^2 / 6 times the derivative two orders higher, and these curves'
                // derivatives grow by less than a factor 200 from one order to the next.
                EXPECT_LE(((after - before) / (2 * step) - exact).norm(),
                          step * step / 6 * 4e4 * (1 + exact.norm()))
                    << kind(curve) << ", order " << k << ", u = " << u;
            }
}

TEST(Curve, JoinsItsPiecesSmoothlyAtSimpleKnotsAndAtTheSeam)
{
    constexpr double step = 1e-9;
    for (const Curve& curve : all_kinds())
        for (const double u : curve.breakpoints()) {
            if (!curve.closed() && (u == 0 || u == 1))
                continue;
            const int smooth = std::min(curve.degree() - 1, 2);
            const auto before = curve.derivatives(u - step, 3);
            const auto after = curve.derivatives(u + step, 3);
            for (std::size_t k = 0; k <= static_cast<std::size_t>(smooth); ++k)
                // One derivative more, times the distance between the two places.
                EXPECT_LE((after[k] - before[k]).norm(), 2 * step * 1e5) << kind(curve) << ", u = " << u;
        }
}

TEST(Curve, IsPeriodicWhenClosedAndStopsAtItsEndsWhenOpen)
{
    const Curve closed(wobbly_curve(3, 7, true, true, 2));
    EXPECT_LE((closed.point(0.25) - closed.point(1.25)).norm(), kRoundOff);
    EXPECT_LE((closed.point(0.75) - closed.point(-2.25)).norm(), kRoundOff);
    EXPECT_EQ(closed.point(1), closed.point(0));
    EXPECT_TRUE(closed.point(-1e-20).allFinite());
    const Curve open(wobbly_curve(3, 7, false, true, 2));
    EXPECT_EQ(open.point(-1), open.definition().control_points.row(0).transpose());
    EXPECT_EQ(open.point(2), open.definition().control_points.row(6).transpose());
}

TEST(Curve, FollowsAnAffineMapOfItsControlPoints)
{
    Eigen::Matrix2d A;
    A << 0.7, -1.3, 0.4, 2.1;
    const Eigen::RowVector2d shift(5, -3);
    for (const Curve& curve : all_kinds()) {
        const Points2 moved = (curve.definition().control_points * A.transpose()).rowwise() + shift;
        const Curve image = curve.with_control_points(moved);
        for (const double u : {0.0, 0.31, 0.77})
            EXPECT_LE((image.point(u) - (A * curve.point(u) + shift.transpose())).norm(), 10 * kRoundOff)
                << kind(curve);
    }
}

TEST(Curve, MakesAnExactCircleOfNinePoints)
{
    CurveDefinition circle; // Piegl & Tiller, The NURBS Book, example 7.2
    circle.degree = 2;
    circle.control_points.resize(9, 2);
    circle.control_points << 1, 0, 1, 1, 0, 1, -1, 1, -1, 0, -1, -1, 0, -1, 1, -1, 1, 0;
    circle.knots = {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}; // over another interval than [0, 1]
    const double s = std::numbers::sqrt2 / 2;
    circle.weights = {1, s, 1, s, 1, s, 1, s, 1};
    const Curve curve(circle);
    for (int i = 0; i <= 1000; ++i) {
        const auto d = curve.derivatives(i / 1000.0, 2);
        EXPECT_NEAR(d[0].norm(), 1, kRoundOff);
        EXPECT_NEAR(d[0].dot(d[1]), 0, 1e-13);
        EXPECT_NEAR(d[0].dot(d[2]) + d[1].dot(d[1]), 0, 1e-11) << "the curvature is that of the circle";
    }
}

TEST(Curve, PassesThroughOneControlPointAtAKnotOfFullMultiplicity)
{
    for (int p = 2; p <= kMaxDegree; ++p) {
        CurveDefinition definition = wobbly_curve(p, p + 3, true, false, 4);
        definition.knots = {0, 0.3, 0.6};
        definition.knots.resize(static_cast<std::size_t>(p) + 4, 1.0);
        definition.knots[3] = 0.8;
        const Curve curve(definition);
        // K + 1 = p + 4 values: 0, 0.3, 0.6, 0.8 and p times 1, which is 0 again.
        EXPECT_EQ(curve.corners(), std::vector<double>{0.0});
        EXPECT_LE((curve.point(0) - definition.control_points.row(0).transpose()).norm(), kRoundOff);
        const Eigen::Vector2d before = curve.derivatives(1 - 1e-12, 1)[1].normalized();
        const Eigen::Vector2d after = curve.derivatives(0, 1)[1].normalized();
        EXPECT_GT((before - after).norm(), 0.1) << "the tangent jumps";
    }
}

TEST(Curve, NamesItsBreakpointsAndCorners)
{
    CurveDefinition open = wobbly_curve(2, 7, false, false, 1);
    open.knots = {0, 0, 0, 0.25, 0.5, 0.5, 0.75, 1, 1, 1};
    EXPECT_EQ(Curve(open).breakpoints(), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
    EXPECT_EQ(Curve(open).corners(), std::vector<double>{0.5});
    const Curve polygon(wobbly_curve(1, 4, true, false, 1));
    EXPECT_EQ(polygon.corners().size(), 4U) << "every knot of a polygon is a corner";
}

TEST(Curve, RefusesDegreesItDoesNotSupport)
{
    CurveDefinition curve = wobbly_curve(3, 12, true, false, 1);
    for (const int degree : {-1, 0, 8, 1000}) {
        curve.degree = degree;
        EXPECT_EQ(message_of(curve),
                  "degree " + std::to_string(degree) + " is not supported; expected 1 to 7");
    }
}

TEST(Curve, RefusesTooFewControlPoints)
{
    CurveDefinition curve;
    EXPECT_THAT(message_of(curve), testing::HasSubstr("needs at least 4 control points, but there are 0"));
    curve = wobbly_curve(3, 4, false, false, 1);
    EXPECT_EQ(message_of(curve), "accepted");
    curve.control_points.conservativeResize(3, 2);
    EXPECT_THAT(message_of(curve), testing::HasSubstr("needs at least 4 control points, but there are 3"));
    CurveDefinition back_and_forth;
    back_and_forth.degree = 1;
    back_and_forth.closed = true;
    back_and_forth.control_points.setIdentity(2, 2);
    EXPECT_THAT(message_of(back_and_forth), testing::HasSubstr("needs at least 3 control points"));
}

TEST(Curve, RefusesBrokenKnots)
{
    CurveDefinition closed = wobbly_curve(3, 6, true, false, 1);
    const auto with = [&](CurveDefinition curve, std::vector<double> knots) {
        curve.knots = std::move(knots);
        return message_of(curve);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THAT(with(closed, {0, 1}), testing::HasSubstr("there are 2 knots; a closed curve has one more"));
    EXPECT_THAT(with(closed, {0, 0.1, 0.3, 0.2, 0.4, 0.5, 1}),
                testing::HasSubstr("knot 4 (0.2) is less than"));
    EXPECT_THAT(with(closed, {0, 0.1, nan, 0.2, 0.4, 0.5, 1}), testing::HasSubstr("knot 3 is not finite"));
    EXPECT_THAT(with(closed, {0, 1, 2, 3, 4, 5, 6}), testing::HasSubstr("from 0 to 1 over one period"));
    EXPECT_THAT(with(closed, {0, 0, 0, 0, 0, 0, 0}), testing::HasSubstr("must increase"));
    EXPECT_THAT(with(closed, {0, 0.1, 0.2, 0.2, 0.2, 0.2, 1}), testing::HasSubstr("is repeated 4 times"));
    EXPECT_THAT(with(closed, {0, 0, 0, 0.5, 0.6, 1, 1}), testing::HasSubstr("is repeated 4 times"))
        << "0 and 1 are the same knot";
    EXPECT_THAT(with(closed, {0, 0.1, 0.2, 0.2 + 1e-12, 0.3, 0.4, 1}), testing::HasSubstr("nearly coincide"));
    const CurveDefinition open = wobbly_curve(2, 5, false, false, 1);
    EXPECT_THAT(with(open, {0, 0, 0, 0.5, 1, 1, 1}), testing::HasSubstr("has 8"));
    EXPECT_THAT(with(open, {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 1}),
                testing::HasSubstr("repeat the first and the last"));
    EXPECT_THAT(with(open, {0, 0, 0, 0, 0.5, 1, 1, 1}), testing::HasSubstr("is repeated 4 times"));
}

TEST(Curve, RefusesBrokenWeightsAndPoints)
{
    const CurveDefinition good = wobbly_curve(3, 6, true, true, 1);
    for (const double bad :
         {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        CurveDefinition curve = good;
        curve.weights[2] = bad;
        EXPECT_THAT(message_of(curve), testing::HasSubstr("weight 3 is "));
    }
    CurveDefinition curve = good;
    curve.weights.pop_back();
    EXPECT_THAT(message_of(curve), testing::HasSubstr("5 weights for 6 control points"));
    curve = good;
    curve.control_points(4, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(message_of(curve), "control point 5 is not finite");
    EXPECT_THROW(Curve(good).with_control_points(Points2::Zero(5, 2)), InputError);
}

} // namespace
