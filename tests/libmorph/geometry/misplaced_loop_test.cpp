#include "libmorph/geometry/misplaced_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

namespace {

using namespace morph;
using Loops = std::vector<std::vector<Index>>;

/// Adds a star-shaped polygon to the points.
std::vector<Index> add_polygon(Points& points, std::complex<double> centre, double radius, Index corners,
                               bool counter_clockwise)
{
    std::vector<Index> loop;
    const Index start = static_cast<Index>(points.rows());
    points.conservativeResize(start + corners, 3);
    for (Index i = 0; i < corners; ++i) {
        const double angle = 0.3 + 2 * std::numbers::pi * i / corners;
        const auto p =
            centre + std::polar(radius * (i % 2 == 0 ? 1 : 0.7), counter_clockwise ? angle : -angle);
        points.row(start + i) << p.real(), p.imag(), 0;
        loop.push_back(start + i);
    }
    return loop;
}

/// By the angle under which the edges are seen: another way than the one under test.
int winding_by_angles(std::complex<double> p, const Points& points, const Loops& loops)
{
    double turns = 0;
    const auto place = [&](Index v) { return std::complex<double>(points(v, 0), points(v, 1)) - p; };
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            turns += std::arg(place(loop[(i + 1) % loop.size()]) / place(loop[i]));
    return static_cast<int>(std::lround(turns / (2 * std::numbers::pi)));
}

TEST(MisplacedLoop, OrientationIsThatOfTheLoop)
{
    for (const bool counter_clockwise : {true, false})
        for (const Index corners : {4, 7, 20}) {
            Points points(0, 3);
            const auto loop = add_polygon(points, {0.4, -2}, 0.1, corners, counter_clockwise);
            EXPECT_EQ(loop_orientation(points, loop), counter_clockwise ? 1 : -1);
        }
}

TEST(MisplacedLoop, IsNoneWhereHolesLieInTheirDomain)
{
    Points points(0, 3);
    Loops loops;
    loops.push_back(add_polygon(points, {0, 0}, 10, 12, true));
    loops.push_back(add_polygon(points, {3, 0}, 1, 9, false));
    loops.push_back(add_polygon(points, {-3, 0}, 2, 8, false));
    loops.push_back(add_polygon(points, {-3, 0}, 0.5, 8, true)); // an island in a hole
    EXPECT_FALSE(find_misplaced_loop(points, loops));
}

TEST(MisplacedLoop, NamesTheHoleThatIsInsideOut)
{
    Points points(0, 3);
    Loops loops;
    loops.push_back(add_polygon(points, {0, 0}, 10, 12, true));
    loops.push_back(add_polygon(points, {3, 0}, 1, 9, false));
    loops.push_back(add_polygon(points, {-3, 0}, 2, 8, true));
    EXPECT_EQ(find_misplaced_loop(points, loops), 2U);
}

TEST(MisplacedLoop, NamesTheHoleThatHasLeftItsDomain)
{
    Points points(0, 3);
    Loops loops;
    loops.push_back(add_polygon(points, {0, 0}, 10, 12, true));
    loops.push_back(add_polygon(points, {30, 0}, 1, 9, false));
    EXPECT_EQ(find_misplaced_loop(points, loops), 1U);
}

TEST(MisplacedLoop, HolesMayTouchInAVertex)
{
    // Two triangles on either side of their common corner: side by side, and one below the other.
    for (const bool upright : {false, true}) {
        Points points(10, 3);
        points << -9, -9, 0, 9, -9, 0, 9, 9, 0, -9, 9, 0, //
            0, 0, 0, 1, 1, 0, 1, -1, 0,                   //
            0, 0, 0, -1, -1, 0, -1, 1, 0;
        Loops loops = {{0, 1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
        if (upright) { // a mirror image, so that all directions change
            points.col(0).swap(points.col(1));
            for (auto& loop : loops)
                std::reverse(loop.begin(), loop.end());
        }
        EXPECT_FALSE(find_misplaced_loop(points, loops)) << upright;
        for (const std::size_t hole : {1U, 2U}) {
            Loops turned = loops;
            std::reverse(turned[hole].begin(), turned[hole].end());
            EXPECT_EQ(find_misplaced_loop(points, turned), hole) << upright;
        }
    }
}

TEST(MisplacedLoop, IsNoneJustWhereTheBoundaryWindsAroundNoPointTwiceOrBackwards)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    int bad = 0;
    for (int trial = 0; trial < 60; ++trial) {
        // Concentric polygons with gaps between them, each in a random direction, some shifted outside.
        Points points(0, 3);
        Loops loops;
        double radius = 16;
        for (int l = 0; l < 4; ++l, radius *= 0.5)
            loops.push_back(add_polygon(points, uniform(random) < -0.7 ? 40.0 * (l + 1) : 0, radius,
                                        6 + 2 * l, uniform(random) < (l % 2 == 0 ? 0.6 : -0.6)));
        bool fits = true;
        for (int sample = 0; sample < 4000; ++sample) {
            const std::complex<double> p(sample % 2 == 0 ? 17 * uniform(random) : 100 + 100 * uniform(random),
                                         17 * uniform(random) * (sample % 3 == 0 ? 0.1 : 1));
            const int winding = winding_by_angles(p, points, loops);
            fits = fits && (winding == 0 || winding == 1);
        }
        EXPECT_EQ(!find_misplaced_loop(points, loops), fits) << trial;
        bad += static_cast<int>(!fits);
    }
    EXPECT_GT(bad, 10);
    EXPECT_LT(bad, 55);
}

} // namespace
