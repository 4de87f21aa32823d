#include "libmorph/quality/metrics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace morph {
namespace {

// A metric is a few operations on differences of coordinates of size one.
constexpr double kRoundingTol = 1e-14;
// After moving and turning the points, the differences carry the rounding of the larger coordinates.
constexpr double kMovedTol = 1e-10;

using P = Eigen::Vector3d;

const CornerPoints kEquilateral{P(0, 0, 0), P(1, 0, 0), P(0.5, std::numbers::sqrt3 / 2, 0), P(0, 0, 0)};
const CornerPoints kRightTriangle{P(0, 0, 0), P(1, 0, 0), P(0, 1, 0), P(0, 0, 0)};
const CornerPoints kSquare{P(0, 0, 0), P(1, 0, 0), P(1, 1, 0), P(0, 1, 0)};
const CornerPoints kRectangle{P(0, 0, 0), P(3, 0, 0), P(3, 1, 0), P(0, 1, 0)};
const CornerPoints kRhombus{P(0, 0, 0), P(1, 0, 0), P(1.5, std::numbers::sqrt3 / 2, 0),
                            P(0.5, std::numbers::sqrt3 / 2, 0)};
// Positive area, but the third corner lies inside the triangle of the others.
const CornerPoints kChevron{P(0, 0, 0), P(2, 0, 0), P(0.5, 0.5, 0), P(0, 2, 0)};

TEST(Metrics, OfAnEquilateralTriangleAreIdeal)
{
    const ElementShape shape = planar_shape(kEquilateral, 3);
    EXPECT_NEAR(scaled_jacobian(shape), 1, kRoundingTol);
    EXPECT_NEAR(aspect_ratio(shape), 1, kRoundingTol);
    EXPECT_NEAR(skew(shape), 1, kRoundingTol);
    EXPECT_NEAR(shape.area, std::numbers::sqrt3 / 4, kRoundingTol);
    EXPECT_NEAR(angle_range(shape).min, 60, 100 * kRoundingTol);
    EXPECT_NEAR(angle_range(shape).max, 60, 100 * kRoundingTol);
}

TEST(Metrics, OfAHalfSquareFollowFromItsSides)
{
    const ElementShape shape = planar_shape(kRightTriangle, 3);
    // Jacobian 1 over the longest pair of edges 1 * sqrt(2), times 2 / sqrt(3).
    EXPECT_NEAR(scaled_jacobian(shape), std::sqrt(2.0 / 3), kRoundingTol);
    EXPECT_NEAR(aspect_ratio(shape),
                std::numbers::sqrt2 * (2 + std::numbers::sqrt2) / (2 * std::numbers::sqrt3), kRoundingTol);
    EXPECT_NEAR(skew(shape), std::numbers::sqrt3 / 2, kRoundingTol);
    EXPECT_NEAR(min_jacobian(shape), 1, kRoundingTol);
    EXPECT_NEAR(angle_range(shape).min, 45, 100 * kRoundingTol);
    EXPECT_NEAR(angle_range(shape).max, 90, 100 * kRoundingTol);
}

TEST(Metrics, OfRectanglesDifferInAspectRatioOnly)
{
    for (const auto& [points, aspect] : {std::pair{kSquare, 1.0}, std::pair{kRectangle, 2.0}}) {
        const ElementShape shape = planar_shape(points, 4);
        EXPECT_NEAR(scaled_jacobian(shape), 1, kRoundingTol);
        EXPECT_NEAR(skew(shape), 1, kRoundingTol);
        EXPECT_NEAR(aspect_ratio(shape), aspect, kRoundingTol); // 3 * 8 / (4 * 3) = 2
        EXPECT_NEAR(angle_range(shape).min, 90, 100 * kRoundingTol);
        EXPECT_NEAR(angle_range(shape).max, 90, 100 * kRoundingTol);
    }
}

TEST(Metrics, OfARhombusFollowFromItsAngle)
{
    const ElementShape shape = planar_shape(kRhombus, 4);
    const double sine = std::numbers::sqrt3 / 2;
    EXPECT_NEAR(scaled_jacobian(shape), sine, kRoundingTol);
    EXPECT_NEAR(skew(shape), sine, kRoundingTol);
    EXPECT_NEAR(angle_range(shape).min, 60, 100 * kRoundingTol);
    EXPECT_NEAR(angle_range(shape).max, 120, 100 * kRoundingTol);
}

TEST(Metrics, CallADentedQuadOfPositiveAreaInverted)
{
    const ElementShape shape = planar_shape(kChevron, 4);
    EXPECT_GT(shape.area, 0);
    EXPECT_TRUE(is_inverted(shape));
    EXPECT_LT(scaled_jacobian(shape), 0);
    EXPECT_EQ(skew(shape), 0);
    // The inner angles of a simple quad add up to 360: 90, twice the tip, and the rest at the dent.
    const double tip = std::atan(1.0 / 3) * 180 / std::numbers::pi;
    EXPECT_NEAR(angle_range(shape).min, tip, 100 * kRoundingTol);
    EXPECT_NEAR(angle_range(shape).max, 270 - 2 * tip, 100 * kRoundingTol);
}

TEST(Metrics, CallAQuadWithAStraightCornerInverted)
{
    CornerPoints points = kSquare;
    points[2] = (points[1] + points[3]) / 2;
    const ElementShape shape = planar_shape(points, 4);
    EXPECT_TRUE(is_inverted(shape));
    EXPECT_EQ(scaled_jacobian(shape), 0);
    EXPECT_NEAR(angle_range(shape).max, 180, 100 * kRoundingTol);
    points[2] = P(0.5 + 0x1p-50, 0.5, 0);
    EXPECT_FALSE(is_inverted(planar_shape(points, 4)));
}

TEST(Metrics, OfAnElementTurnedOverChangeSignButNotItsAngles)
{
    for (const auto& [points, corners] : {std::pair{kRightTriangle, 3}, {kRhombus, 4}, {kRectangle, 4}}) {
        const ElementShape right = planar_shape(points, corners);
        CornerPoints mirrored = points;
        for (P& p : mirrored)
            p.x() = -p.x();
        const ElementShape turned = planar_shape(mirrored, corners);
        EXPECT_TRUE(is_inverted(turned));
        EXPECT_DOUBLE_EQ(turned.area, -right.area);
        EXPECT_DOUBLE_EQ(angle_range(turned).min, angle_range(right).min);
        EXPECT_DOUBLE_EQ(angle_range(turned).max, angle_range(right).max);
        EXPECT_DOUBLE_EQ(aspect_ratio(turned), aspect_ratio(right));
        EXPECT_NEAR(scaled_jacobian(turned), -scaled_jacobian(right), kRoundingTol);
        EXPECT_EQ(skew(turned), 0);
    }
}

TEST(Metrics, StayTheSameWhenTheElementIsMovedTurnedAndScaled)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const auto& [points, corners] : {std::pair{kRightTriangle, 3}, {kRhombus, 4}, {kChevron, 4}})
        for (const double scale : {1e-3, 1.0, 1e3}) {
            const ElementShape original = planar_shape(points, corners);
            const Eigen::AngleAxisd turn(3 * unit(random), P::UnitZ());
            const P shift(unit(random), unit(random), 0);
            CornerPoints moved = points;
            for (P& p : moved)
                p = scale * (turn * p + shift);
            const ElementShape shape = planar_shape(moved, corners);
            EXPECT_NEAR(scaled_jacobian(shape), scaled_jacobian(original), kMovedTol);
            EXPECT_NEAR(aspect_ratio(shape), aspect_ratio(original), kMovedTol);
            EXPECT_NEAR(skew(shape), skew(original), kMovedTol);
            EXPECT_NEAR(angle_range(shape).min, angle_range(original).min, 100 * kMovedTol);
            EXPECT_NEAR(angle_range(shape).max, angle_range(original).max, 100 * kMovedTol);
            EXPECT_NEAR(shape.area, scale * scale * original.area, scale * scale * kMovedTol);
        }
}

TEST(Metrics, OfAnElementTiltedIntoSpaceAreThoseOfThePlane)
{
    const Eigen::Quaterniond tilt = Eigen::Quaterniond(0.3, -0.5, 0.2, 0.7).normalized();
    for (const auto& [points, corners] : {std::pair{kRightTriangle, 3}, {kRhombus, 4}, {kChevron, 4}}) {
        const ElementShape flat = planar_shape(points, corners);
        CornerPoints tilted = points;
        for (P& p : tilted)
            p = tilt * p + P(1, 2, 3);
        const ElementShape shape = surface_shape(tilted, corners);
        EXPECT_EQ(is_inverted(shape), is_inverted(flat));
        EXPECT_NEAR(scaled_jacobian(shape), scaled_jacobian(flat), kMovedTol);
        EXPECT_NEAR(aspect_ratio(shape), aspect_ratio(flat), kMovedTol);
        EXPECT_NEAR(skew(shape), skew(flat), kMovedTol);
        EXPECT_NEAR(angle_range(shape).max, angle_range(flat).max, 100 * kMovedTol);
    }
}

TEST(Metrics, OfASurfaceTriangleInvertOnlyWhenItsCornersAreOnOneLine)
{
    const CornerPoints turned{P(0, 0, 1), P(0, 1, 1), P(1, 0, 1), P(0, 0, 0)};
    EXPECT_FALSE(is_inverted(surface_shape(turned, 3)));
    const CornerPoints flat{P(0, 0, 0), P(1, 2, 3), P(2, 4, 6), P(0, 0, 0)};
    EXPECT_TRUE(is_inverted(surface_shape(flat, 3)));
}

TEST(Metrics, AreFiniteForDegenerateAndExtremeElements)
{
    const double huge = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    const std::vector<CornerPoints> awkward{
        {P(1, 1, 0), P(1, 1, 0), P(1, 1, 0), P(1, 1, 0)},
        {P(0, 0, 0), P(0, 0, 0), P(1, 0, 0), P(0, 1, 0)},
        {P(0, 0, 0), P(1, 0, 0), P(2, 0, 0), P(3, 0, 0)},
        {P(0, 0, 0), P(1, 1, 0), P(1, 0, 0), P(0, 1, 0)},
        {P(0, 0, 0), P(tiny, 0, 0), P(tiny, tiny, 0), P(0, tiny, 0)},
        {P(-huge, -huge, 0), P(huge, -huge, 0), P(huge, huge, 0), P(-huge, huge, 0)},
        {P(0, 0, 0), P(1e200, 0, 0), P(1e200, 1e200, 0), P(0, 1e200, 0)},
        {P(0, 0, 0), P(1e-200, 0, 0), P(1e-200, 1e-200, 0), P(0, 1e-200, 0)}};
    for (const CornerPoints& points : awkward)
        for (const int corners : {3, 4})
            for (const ElementShape& shape :
                 {planar_shape(points, corners), surface_shape(points, corners)}) {
                EXPECT_TRUE(std::isfinite(scaled_jacobian(shape)));
                EXPECT_TRUE(std::isfinite(aspect_ratio(shape)));
                EXPECT_TRUE(std::isfinite(skew(shape)));
                EXPECT_TRUE(std::isfinite(size_skew(shape, 1)));
                EXPECT_TRUE(std::isfinite(angle_range(shape).min));
                EXPECT_TRUE(std::isfinite(angle_range(shape).max));
                EXPECT_EQ(is_inverted(shape), min_jacobian(shape) <= 0);
            }
}

TEST(SizeSkew, IsOneForAnIdealElementOfTheReferenceSize)
{
    EXPECT_NEAR(size_skew(planar_shape(kEquilateral, 3), std::numbers::sqrt3 / 4), 1, kRoundingTol);
    EXPECT_NEAR(size_skew(planar_shape(kSquare, 4), 1), 1, kRoundingTol);
}

TEST(SizeSkew, FallsWithTheRootOfTheAreaRatioEitherWay)
{
    const ElementShape square = planar_shape(kSquare, 4);
    EXPECT_NEAR(size_skew(square, 4), 0.5, kRoundingTol);
    EXPECT_NEAR(size_skew(square, 0.25), 0.5, kRoundingTol);
    EXPECT_NEAR(size_skew(planar_shape(kRhombus, 4), 2 * std::numbers::sqrt3), 0.5 * std::numbers::sqrt3 / 2,
                kRoundingTol);
}

TEST(SizeSkew, IsZeroForInvertedElementsAndReferencesWithoutArea)
{
    EXPECT_EQ(size_skew(planar_shape(kChevron, 4), 1), 0);
    EXPECT_EQ(size_skew(planar_shape(kSquare, 4), 0), 0);
    EXPECT_EQ(size_skew(planar_shape(kSquare, 4), -1), 0);
}

} // namespace
} // namespace morph
