#include "libmorph/geometry/corner_motion.h"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace morph {
namespace {

using Exact = CGAL::Exact_rational;

/// The Jacobian as c0 + c1 t + c2 t^2 in rational numbers: another form than the one under test.
struct Parabola {
    explicit Parabola(const MovingCorner& c)
    {
        const Exact ax = Exact(c.next.start.x) - c.corner.start.x,
                    ay = Exact(c.next.start.y) - c.corner.start.y;
        const Exact bx = Exact(c.previous.start.x) - c.corner.start.x;
        const Exact by = Exact(c.previous.start.y) - c.corner.start.y;
        const Exact ux = Exact(c.next.end.x) - c.corner.end.x - ax,
                    uy = Exact(c.next.end.y) - c.corner.end.y - ay;
        const Exact vx = Exact(c.previous.end.x) - c.corner.end.x - bx;
        const Exact vy = Exact(c.previous.end.y) - c.corner.end.y - by;
        c0 = ax * by - ay * bx;
        c1 = ax * vy - ay * vx + ux * by - uy * bx;
        c2 = ux * vy - uy * vx;
    }

    Exact at(const Exact& t) const { return c0 + t * (c1 + t * c2); }

    /// Positive at both ends and at the lowest point between them.
    bool is_positive_until(const Exact& time) const
    {
        if (at(0) <= 0 || at(time) <= 0)
            return false;
        if (c2 <= 0)
            return true;
        const Exact lowest = -c1 / (2 * c2);
        return lowest <= 0 || lowest >= time || at(lowest) > 0;
    }

    Exact c0, c1, c2;
};

MovingCorner right_angle(MovingPoint next, MovingPoint previous)
{
    return {{{0, 0}, {0, 0}}, next, previous};
}

/// The unit right angle turned by @p degrees about its corner, its points going along the chords.
MovingCorner turned(double degrees)
{
    const double c = std::cos(degrees / 180 * M_PI), s = std::sin(degrees / 180 * M_PI);
    return right_angle({{1, 0}, {c, s}}, {{0, 1}, {-s, c}});
}

TEST(TurnsLeftUntil, EndsWhenAPointReachesTheOppositeSide)
{
    const MovingCorner corner = right_angle({{1, 0}, {1, 0}}, {{0, 1}, {0, -1}}); // Jacobian 1 - 2 t
    EXPECT_TRUE(stays_positive_until(corner, std::nextafter(0.5, 0)));
    EXPECT_FALSE(stays_positive_until(corner, 0.5));
    EXPECT_FALSE(stays_positive_until(corner, 1));
    EXPECT_EQ(turning_time(corner), 0.5);
}

TEST(TurnsLeftUntil, SeesACornerThatTurnsOverAndBackAgain)
{
    // Half a turn passes through the point itself: the Jacobian is (1 - 2 t)^2, positive at both ends.
    const MovingCorner half = right_angle({{1, 0}, {-1, 0}}, {{0, 1}, {0, -1}});
    EXPECT_TRUE(stays_positive_until(half, std::nextafter(0.5, 0)));
    EXPECT_FALSE(stays_positive_until(half, 0.5));
    EXPECT_FALSE(stays_positive_until(half, 1));
    EXPECT_EQ(turning_time(half), 0.5);
    // (1 - 4 t) (1 - 2 t): below zero only between a quarter and a half.
    const MovingCorner twice = right_angle({{1, 0}, {-3, 0}}, {{0, 1}, {0, -1}});
    EXPECT_TRUE(stays_positive_until(twice, std::nextafter(0.25, 0)));
    EXPECT_FALSE(stays_positive_until(twice, 0.25));
    EXPECT_FALSE(stays_positive_until(twice, 0.75));
    EXPECT_FALSE(stays_positive_until(twice, 1));
    EXPECT_EQ(turning_time(twice), 0.25);
}

TEST(TurnsLeftUntil, LetsARotationThroughUpToHalfATurn)
{
    for (const double degrees : {10.0, 90.0, 150.0, 179.0, 179.9999})
        EXPECT_TRUE(stays_positive_until(turned(degrees), 1))
            << degrees; // the Jacobian stays above cos^2(degrees / 2)
    EXPECT_EQ(turning_time(turned(90)), 1);
}

TEST(TurnsLeftUntil, IsFalseForACornerThatDoesNotTurnLeftAtFirst)
{
    EXPECT_FALSE(stays_positive_until(right_angle({{1, 0}, {1, 0}}, {{0, -1}, {0, 1}}), 0));
    EXPECT_FALSE(stays_positive_until(right_angle({{1, 0}, {1, 0}}, {{2, 0}, {0, 1}}), 0));
    EXPECT_EQ(turning_time(right_angle({{1, 0}, {1, 0}}, {{2, 0}, {0, 1}})), 0);
}

TEST(TurnsLeftUntil, IsFalseWhereACoordinateIsNotFinite)
{
    for (const double bad :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_FALSE(stays_positive_until(right_angle({{1, 0}, {1, 0}}, {{0, 1}, {0, bad}}), 0.5));
}

TEST(TurnsLeftUntil, AgreesWithRationalNumbersOnRandomCornersAndTimes)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    std::uniform_int_distribution<int> grid(-2, 2);
    int yes = 0, no = 0;
    for (int i = 0; i < 20000; ++i) {
        const bool rough = i % 2 == 0; // ties, double roots and zeros are frequent on a grid
        const auto coordinate = [&] { return rough ? grid(random) : anywhere(random); };
        const auto point = [&] {
            return MovingPoint{{coordinate(), coordinate()}, {coordinate(), coordinate()}};
        };
        const MovingCorner corner{point(), point(), point()};
        const Parabola parabola(corner);
        for (const double time : {0.0, 0.25, 0.5, std::abs(anywhere(random)), turning_time(corner), 1.0}) {
            const bool expected = parabola.is_positive_until(time);
            ASSERT_EQ(stays_positive_until(corner, time), expected) << "corner " << i << ", time " << time;
            (expected ? yes : no) += 1;
        }
    }
    EXPECT_GT(yes, 10000);
    EXPECT_GT(no, 10000);
}

TEST(TurnsLeftUntil, AgreesWithRationalNumbersWhereRoundingHidesTheSign)
{
    // Points far from the origin move so that the corner flattens to within the last digits.
    std::mt19937 random(2);
    std::uniform_int_distribution<int> ulps(-3, 3);
    std::uniform_real_distribution<double> far(1, 2);
    int yes = 0, no = 0;
    for (int i = 0; i < 20000; ++i) {
        const double x = far(random), y = far(random), dx = far(random), dy = far(random);
        const double last = std::ldexp(1.0, -51);
        const MovingCorner corner{{{x, y}, {x, y}},
                                  {{x + dx, y + dy}, {x + dx, y + dy}},
                                  {{x - 1, y + 1}, {x + dx / 2, y + dy / 2 + ulps(random) * last}}};
        const Parabola parabola(corner);
        const bool expected = parabola.is_positive_until(1);
        ASSERT_EQ(stays_positive_until(corner, 1), expected);
        (expected ? yes : no) += 1;
    }
    EXPECT_GT(yes, 5000);
    EXPECT_GT(no, 5000);
}

TEST(TurnsLeftUntil, KnowsCornersTooSmallOrTooLargeForProductsOfDoubles)
{
    for (const double scale : {1e-200, 1e200, 5e-324}) {
        const MovingCorner corner = right_angle({{scale, 0}, {scale, 0}}, {{0, scale}, {0, -scale}});
        EXPECT_TRUE(stays_positive_until(corner, std::nextafter(0.5, 0))) << scale;
        EXPECT_FALSE(stays_positive_until(corner, 0.5)) << scale;
    }
}

} // namespace
} // namespace morph
