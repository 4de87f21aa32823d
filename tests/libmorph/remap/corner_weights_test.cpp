#include "libmorph/remap/corner_weights.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace {

using namespace morph;

constexpr double kRounding = 1e-14; // a few operations on numbers of about 1

PlanePoint weighted(const PlaneElement& element, const std::array<double, 4>& weights)
{
    PlanePoint sum;
    for (std::size_t k = 0; k < static_cast<std::size_t>(element.corners); ++k) {
        sum.x += weights[k] * element.corner[k].x;
        sum.y += weights[k] * element.corner[k].y;
    }
    return sum;
}

double distance(PlanePoint a, PlanePoint b)
{
    return std::hypot(a.x - b.x, a.y - b.y);
}

double sum_of(const std::array<double, 4>& weights)
{
    return std::accumulate(weights.begin(), weights.end(), 0.0);
}

/// The point of a quad that its bilinear map has at (u, v).
PlanePoint mapped(const PlaneElement& quad, double u, double v)
{
    return weighted(quad, {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v});
}

class RandomElements : public testing::Test {
protected:
    double uniform() { return static_cast<double>(random_()) / 4294967296.0; }

    PlaneElement convex_quad()
    {
        for (;;) {
            PlaneElement quad{{}, 4};
            const double turn = 6.28 * uniform();
            for (std::size_t k = 0; k < 4; ++k) {
                const double angle = turn + 1.57 * static_cast<double>(k) + uniform() - 0.5;
                const double radius = 0.2 + uniform();
                quad.corner[k] = {radius * std::cos(angle), radius * std::sin(angle)};
            }
            if (is_convex(quad))
                return quad;
        }
    }

    std::mt19937 random_{5};
};

TEST_F(RandomElements, WeightsOfATriangleSumToOneAndGiveThePoint)
{
    for (int i = 0; i < 10000; ++i) {
        const PlaneElement triangle{
            {{{uniform(), uniform()}, {uniform(), uniform()}, {uniform(), uniform()}, {}}}, 3};
        double s = uniform(), t = uniform();
        if (s + t > 1) {
            s = 1 - s;
            t = 1 - t;
        }
        const PlanePoint p = weighted(triangle, {1 - s - t, s, t, 0});
        const auto weights = corner_weights(triangle, p, QuadRule::bilinear);
        EXPECT_NEAR(sum_of(weights), 1, kRounding);
        EXPECT_LT(distance(weighted(triangle, weights), p), kRounding);
    }
}

TEST_F(RandomElements, WeightsOfASliverGiveThePointToRounding)
{
    // Twice the area is about 1e-12 while the sides are of length 1: single weights are known to some four
    // digits.
    for (int i = 0; i < 10000; ++i) {
        const double slope = uniform();
        const PlaneElement sliver{{{{0, 0}, {1, slope}, {uniform(), 0}, {}}}, 3};
        PlaneElement thin = sliver;
        thin.corner[2].y = slope * thin.corner[2].x + 1e-12 * (1 + uniform());
        const double s = 0.5 * uniform(), t = 0.5 * uniform();
        const PlanePoint p = weighted(thin, {1 - s - t, s, t, 0});
        EXPECT_LT(distance(weighted(thin, corner_weights(thin, p, QuadRule::bilinear)), p), kRounding);
    }
}

TEST_F(RandomElements, BilinearWeightsAreThoseOfTheInverseMap)
{
    for (int i = 0; i < 10000; ++i) {
        const PlaneElement quad = convex_quad();
        const double u = uniform(), v = uniform();
        const auto weights = corner_weights(quad, mapped(quad, u, v), QuadRule::bilinear);
        constexpr double kConditioned = 1e-10; // small angles of the quads above lose some digits
        EXPECT_NEAR(weights[1] + weights[2], u, kConditioned);
        EXPECT_NEAR(weights[2] + weights[3], v, kConditioned);
        EXPECT_LT(distance(weighted(quad, weights), mapped(quad, u, v)), kRounding);
    }
}

TEST_F(RandomElements, BilinearWeightsAreRightInParallelogramsAndTrapezoids)
{
    for (int i = 0; i < 1000; ++i) {
        const double shear = uniform(), top = i % 2 == 0 ? 1 : 0.1 + uniform();
        const PlaneElement quad{{{{0, 0}, {1, 0}, {shear + top, 1}, {shear, 1}}}, 4};
        const double u = uniform(), v = uniform();
        const auto weights = corner_weights(quad, mapped(quad, u, v), QuadRule::bilinear);
        EXPECT_NEAR(weights[1] + weights[2], u, kRounding);
        EXPECT_NEAR(weights[2] + weights[3], v, kRounding);
    }
}

TEST_F(RandomElements, TwoQuadsAgreeOnTheSideTheyShare)
{
    for (int i = 0; i < 1000; ++i) {
        const PlaneElement below{{{{0, -uniform() - 0.1}, {1, -uniform() - 0.1}, {1, 0}, {0, 0}}}, 4};
        const PlaneElement above{{{{0, 0}, {1, 0}, {1, uniform() + 0.1}, {0, uniform() + 0.1}}}, 4};
        const double x = uniform();
        const auto low = corner_weights(below, {x, 0}, QuadRule::bilinear);
        const auto high = corner_weights(above, {x, 0}, QuadRule::bilinear);
        EXPECT_NEAR(low[3], high[0], kRounding);
        EXPECT_NEAR(low[2], high[1], kRounding);
        EXPECT_NEAR(low[0] + low[1], 0, kRounding);
    }
}

TEST_F(RandomElements, SplitWeightsAreBarycentricInTheTrianglesOfTheThesis)
{
    for (int i = 0; i < 1000; ++i) {
        const PlaneElement quad = convex_quad();
        const double s = 0.5 * uniform(), t = 0.5 * uniform();
        const auto in_123 = corner_weights(quad, weighted(quad, {1 - s - t, s, t, 0}), QuadRule::split);
        EXPECT_EQ(in_123[3], 0);
        EXPECT_NEAR(in_123[1], s, 1e-10);
        const auto in_134 = corner_weights(quad, weighted(quad, {1 - s - t, 0, s, t}), QuadRule::split);
        EXPECT_EQ(in_134[1], 0);
        EXPECT_NEAR(in_134[3], t, 1e-10);
    }
}

TEST(CornerWeights, AreOneAndZeroAtACorner)
{
    const PlaneElement quad{{{{0.1, 0.3}, {1.7, 0.2}, {1.1, 1.9}, {0.3, 1.3}}}, 4};
    for (const QuadRule rule : {QuadRule::bilinear, QuadRule::split})
        for (std::size_t k = 0; k < 4; ++k) {
            std::array<double, 4> expected{};
            expected[k] = 1;
            EXPECT_EQ(corner_weights(quad, quad.corner[k], rule), expected);
        }
}

TEST(CornerWeights, ADentedQuadIsItsTwoTrianglesAlongTheInnerDiagonal)
{
    const PlaneElement dented{{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, 4}; // the corner (1, 1) is dented
    const auto weights = corner_weights(dented, {2, 0.25}, QuadRule::bilinear);
    EXPECT_EQ(weights[3], 0);
    EXPECT_LT(distance(weighted(dented, weights), {2, 0.25}), kRounding);
    const PlaneElement other{{{{4, 0}, {1, 1}, {0, 4}, {0, 0}}}, 4}; // dented at its second corner
    EXPECT_EQ(corner_weights(other, {2, 0.25}, QuadRule::split)[2], 0);
}

TEST(CornerWeights, OfAnElementWithoutAreaInterpolateAlongIt)
{
    const PlaneElement flat{{{{0, 0}, {1, 1}, {3, 3}, {}}}, 3};
    const auto weights = corner_weights(flat, {2, 2}, QuadRule::bilinear);
    EXPECT_NEAR(sum_of(weights), 1, kRounding);
    EXPECT_LT(distance(weighted(flat, weights), {2, 2}), kRounding);
}

TEST(CornerWeights, InSpaceAreThoseOfThePlaneTheElementLiesIn)
{
    // The quad of the plane, turned into the plane z = 2 x + 3 y.
    const PlaneElement quad{{{{0.1, 0.3}, {1.7, 0.2}, {1.1, 1.9}, {0.3, 1.3}}}, 4};
    const auto lifted = [](PlanePoint p) { return Eigen::Vector3d(p.x, p.y, 2 * p.x + 3 * p.y); };
    std::array<Eigen::Vector3d, 4> corner;
    for (std::size_t k = 0; k < 4; ++k)
        corner[k] = lifted(quad.corner[k]);
    const PlanePoint p = mapped(quad, 0.3, 0.6);
    const auto flat = corner_weights(quad, p, QuadRule::bilinear);
    const auto space = corner_weights(corner, 4, lifted(p), QuadRule::bilinear);
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(space[k], flat[k], kRounding);
}

} // namespace
