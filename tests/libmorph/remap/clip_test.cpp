#include "libmorph/remap/clip.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/convex_hull_2.h>
#include <CGAL/intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace morph;
using K = CGAL::Exact_predicates_exact_constructions_kernel;

/// Crossings are rounded to about 2^-53 of polygons whose size is about 1, and areas with them.
constexpr double kRounding = 1e-15;

ConvexPolygon polygon(const std::vector<PlanePoint>& corners, int first_side = 0)
{
    ConvexPolygon made;
    for (const PlanePoint p : corners)
        made.add(p, first_side++);
    return made;
}

/// A random triangle or convex quad in the unit square, on a coarse grid every other time.
std::vector<PlanePoint> random_corners(std::mt19937& random)
{
    const bool on_grid = random() % 2 == 0;
    const std::size_t wanted = 3 + random() % 2;
    for (;;) {
        std::vector<K::Point_2> points, hull;
        for (std::size_t k = 0; k < wanted; ++k) {
            const auto coordinate = [&] {
                return on_grid ? (random() % 5) / 4.0 : static_cast<double>(random()) / 4294967296.0;
            };
            const double x = coordinate();
            points.emplace_back(x, coordinate());
        }
        CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
        if (hull.size() != wanted)
            continue;
        std::vector<PlanePoint> corners;
        corners.reserve(wanted);
        for (const auto& p : hull)
            corners.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y())});
        return corners;
    }
}

/// Exact area of the common part of two convex polygons, whose fans of triangles are intersected by CGAL.
double exact_common_area(const std::vector<PlanePoint>& a, const std::vector<PlanePoint>& b)
{
    const auto triangle = [](const std::vector<PlanePoint>& p, std::size_t k) {
        return K::Triangle_2({p[0].x, p[0].y}, {p[k - 1].x, p[k - 1].y}, {p[k].x, p[k].y});
    };
    K::FT area = 0;
    for (std::size_t i = 2; i < a.size(); ++i)
        for (std::size_t j = 2; j < b.size(); ++j) {
            const auto common = CGAL::intersection(triangle(a, i), triangle(b, j));
            if (!common)
                continue;
            if (const auto* part = boost::get<K::Triangle_2>(&*common))
                area += CGAL::abs(part->area());
            if (const auto* part = boost::get<std::vector<K::Point_2>>(&*common))
                area += CGAL::abs(CGAL::Polygon_2<K>(part->begin(), part->end()).area());
        }
    return CGAL::to_double(CGAL::exact(area));
}

TEST(Clip, HasTheAreaOfCgalsExactIntersection)
{
    std::mt19937 random(5);
    for (int i = 0; i < 20000; ++i) {
        const auto a = random_corners(random), b = random_corners(random);
        EXPECT_NEAR(area(clip(polygon(a), polygon(b))), exact_common_area(a, b), kRounding) << "pair " << i;
    }
}

TEST(Clip, KeepsTheNumbersOfTheSides)
{
    const ConvexPolygon square = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 10);
    const ConvexPolygon corner = polygon({{1, 1}, {3, 1}, {3, 3}, {1, 3}}, 20);
    const ConvexPolygon common = clip(square, corner);
    ASSERT_EQ(common.corners, 4);
    std::vector<int> sides(common.side.begin(), common.side.begin() + 4);
    std::sort(sides.begin(), sides.end());
    EXPECT_EQ(sides,
              (std::vector<int>{11, 12, 20, 23})); // right and top of the one, bottom and left of the other
    for (int k = 0; k < 4; ++k) {                  // right: x = 2, and so on
        const PlanePoint p = common[k], q = common.after(k);
        switch (common.side[static_cast<std::size_t>(k)]) {
        case 11:
            EXPECT_TRUE(p.x == 2 && q.x == 2);
            break;
        case 12:
            EXPECT_TRUE(p.y == 2 && q.y == 2);
            break;
        case 20:
            EXPECT_TRUE(p.y == 1 && q.y == 1);
            break;
        default:
            EXPECT_TRUE(p.x == 1 && q.x == 1);
        }
    }
}

TEST(Clip, GivesNothingForPolygonsThatOnlyTouch)
{
    const ConvexPolygon square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    const ConvexPolygon along_side = polygon({{1, 0.25}, {2, 0.5}, {1, 0.75}});
    const ConvexPolygon at_corner = polygon({{1, 1}, {2, 1}, {2, 2}});
    for (const ConvexPolygon& other : {along_side, at_corner}) {
        EXPECT_EQ(area(clip(square, other)), 0);
        EXPECT_EQ(area(clip(other, square)), 0);
    }
}

TEST(Clip, OfAPolygonWithItselfIsThePolygon)
{
    const ConvexPolygon triangle = polygon({{0.1, 0.7}, {0.3, 0.2}, {0.9, 0.4}});
    const ConvexPolygon common = clip(triangle, triangle);
    ASSERT_EQ(common.corners, 3);
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(common[k].x, triangle[k].x - 0.1);
        EXPECT_EQ(common[k].y, triangle[k].y - 0.7);
    }
}

TEST(Clip, SplitsAPolygonAlongASharedSideWithoutGapOrOverlap)
{
    std::mt19937 random(6);
    for (int i = 0; i < 5000; ++i) {
        const ConvexPolygon subject = polygon(random_corners(random));
        // Two huge triangles that meet in the side from p to q.
        const double angle = static_cast<double>(random());
        const double x = std::cos(angle), y = std::sin(angle);
        const PlanePoint p{0.5 - 1000 * x, 0.5 - 1000 * y}, q{0.5 + 1000 * x, 0.5 + 1000 * y};
        const PlanePoint left{0.5 - 3000 * y, 0.5 + 3000 * x}, right{0.5 + 3000 * y, 0.5 - 3000 * x};
        const double sum =
            area(clip(subject, polygon({p, q, left}))) + area(clip(subject, polygon({q, p, right})));
        EXPECT_NEAR(sum, area(subject), 4e-16) << "pair " << i; // a clipper's own rounding would be 1e-13
    }
}

TEST(Clip, LosesNoDigitsFarFromTheOrigin)
{
    constexpr double kFar = 0x1p30; // where neighbouring numbers are 2^-22 apart
    const auto moved = [](std::vector<PlanePoint> corners) {
        for (PlanePoint& p : corners)
            p = {p.x + kFar, p.y - kFar};
        return corners;
    };
    const std::vector<PlanePoint> a{{0, 0}, {1, 0.125}, {0.25, 0.875}}, b{{0.5, 0}, {0.75, 1}, {-0.25, 0.5}};
    const ConvexPolygon near = clip(polygon(a), polygon(b)), far = clip(polygon(moved(a)), polygon(moved(b)));
    ASSERT_EQ(near.corners, far.corners);
    EXPECT_GT(near.corners, 3);
    for (int k = 0; k < near.corners; ++k)
        EXPECT_TRUE(near[k].x == far[k].x && near[k].y == far[k].y) << "corner " << k;
}

} // namespace
