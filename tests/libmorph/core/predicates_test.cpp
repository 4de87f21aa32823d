#include "libmorph/core/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace morph {
namespace {

__extension__ using Wide = __int128; // holds products of the 46-bit differences below

int sign(Wide value)
{
    return (value > 0 ? 1 : 0) - (value < 0 ? 1 : 0);
}

/// A point of the plane on a grid of step 2^-40 near (0.5, 0.5), with the integers behind it.
struct GridPoint {
    std::int64_t x;
    std::int64_t y;
    PlanePoint point() const { return {std::ldexp(double(x), -40), std::ldexp(double(y), -40)}; }
};

int exact_sign(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d)
{
    return sign(Wide(b.x - a.x) * (d.y - c.y) - Wide(b.y - a.y) * (d.x - c.x));
}

TEST(Orientation, KnowsTheThreeSimpleCases)
{
    EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(orientation({0, 0}, {0, 1}, {1, 0}), -1);
    EXPECT_EQ(orientation({0, 0}, {1, 1}, {2, 2}), 0);
}

TEST(Orientation, AgreesWithIntegersOnNearlyCollinearTriples)
{
    std::mt19937 random(1);
    std::uniform_int_distribution<std::int64_t> far(1, std::int64_t{1} << 45);
    std::uniform_int_distribution<std::int64_t> near(-2, 2);
    int zeros = 0;
    int turned = 0;
    for (int i = 0; i < 20000; ++i) {
        const GridPoint a{near(random), near(random)};
        const GridPoint b{far(random), far(random)};
        const GridPoint c{2 * b.x + near(random), 2 * b.y + near(random)};
        const int expected = exact_sign(a, b, a, c);
        ASSERT_EQ(orientation(a.point(), b.point(), c.point()), expected);
        ASSERT_EQ(orientation(b.point(), a.point(), c.point()), -expected);
        zeros += expected == 0 ? 1 : 0;
        // How often plain floating point would have been wrong: the test must contain such triples.
        const PlanePoint p = a.point();
        const PlanePoint q = b.point();
        const PlanePoint r = c.point();
        const double rounded = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        turned += (rounded > 0 ? 1 : 0) - (rounded < 0 ? 1 : 0) != expected ? 1 : 0;
    }
    EXPECT_GT(zeros, 0);
    EXPECT_GT(turned, 0);
}

TEST(CrossSign, AgreesWithIntegersOnNearlyParallelVectors)
{
    std::mt19937 random(2);
    std::uniform_int_distribution<std::int64_t> far(1, std::int64_t{1} << 45);
    std::uniform_int_distribution<std::int64_t> near(-2, 2);
    for (int i = 0; i < 20000; ++i) {
        const GridPoint a{far(random), far(random)};
        const GridPoint b{far(random), far(random)};
        const GridPoint c{far(random), far(random)};
        const GridPoint d{c.x + b.x - a.x + near(random), c.y + b.y - a.y + near(random)};
        ASSERT_EQ(cross_sign(a.point(), b.point(), c.point(), d.point()), exact_sign(a, b, c, d));
    }
}

TEST(Orientation, HoldsAtTheEndsOfTheRangeOfDoubles)
{
    const double tiny = std::numeric_limits<double>::denorm_min();
    const double huge = std::numeric_limits<double>::max();
    EXPECT_EQ(orientation({0, 0}, {tiny, 0}, {0, tiny}), 1);
    EXPECT_EQ(orientation({0, 0}, {0, tiny}, {tiny, 0}), -1);
    EXPECT_EQ(orientation({-huge, -huge}, {huge, -huge}, {huge, huge}), 1);
    EXPECT_EQ(orientation({-huge, -huge}, {0, 0}, {huge, huge}), 0);
    EXPECT_EQ(orientation({-huge, -huge}, {0, 0}, {huge, std::nextafter(huge, 0)}), -1);
}

} // namespace
} // namespace morph
