#include "libmorph/deform/loop_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

using namespace morph;
using Polygon = std::vector<std::complex<double>>;

constexpr double kRounding = 1e-13; // of coordinates of about 1, through some tens of sums

Polygon ellipse(int corners)
{
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.3 * std::sin(i)) / corners;
        polygon.emplace_back(1 + std::cos(angle), 0.2 * std::sin(angle));
    }
    return polygon;
}

double distance(const Polygon& a, const Polygon& b)
{
    double largest = a.size() == b.size() ? 0 : HUGE_VAL;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

/// Angle by which a polygon turns at each corner, in (-pi, pi].
std::vector<double> corner_turns(const Polygon& p)
{
    std::vector<double> turns;
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i)
        turns.push_back(std::arg((p[(i + 1) % n] - p[i]) / (p[i] - p[(i + n - 1) % n])));
    return turns;
}

/// Most that any corner turns between two of many places on a way. More than half a turn: it has turned over.
template <class Way>
double largest_jump(const Way& way)
{
    double jump = 0;
    std::vector<double> before = corner_turns(way(0.0));
    for (int step = 1; step <= 400; ++step) {
        const std::vector<double> now = corner_turns(way(step / 400.0));
        for (std::size_t i = 0; i < now.size(); ++i)
            jump = std::max(jump, std::abs(now[i] - before[i]));
        before = now;
    }
    return jump;
}

TEST(LoopPath, LeadsFromOneShapeToTheOther)
{
    const Polygon from = ellipse(20);
    Polygon to = from;
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] = {2 * to[i].real(), to[i].imag() + 0.3 * std::sin(4 * to[i].real())};
    const LoopPath path(from, to);
    EXPECT_LT(distance(path.at(0), from), kRounding);
    EXPECT_EQ(path.at(1), to);
    EXPECT_LT(distance(path.at(1 - 1e-9), to), 1e-7); // arrives without a jump
}

TEST(LoopPath, OfARigidMotionIsRigid)
{
    const Polygon from = ellipse(15);
    for (const double degrees : {30.0, -120.0, 179.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const std::complex<double> shift(3, -1), centre(1, 0);
        std::complex<double> mean = 0;
        for (const auto& corner : from)
            mean += corner / 15.0;
        const auto moved = [&](double f) {
            Polygon polygon;
            const auto to_mean =
                mean + f * (centre + std::polar(1.0, angle) * (mean - centre) + shift - mean);
            for (const auto& corner : from)
                polygon.push_back(to_mean + std::polar(1.0, f * angle) * (corner - mean));
            return polygon;
        };
        const LoopPath path(from, moved(1));
        for (const double f : {0.2, 0.5, 0.9})
            EXPECT_LT(distance(path.at(f), moved(f)), kRounding) << degrees << ' ' << f;
    }
}

TEST(LoopPath, OpensACornerWhereAStraightWayTurnsItOver)
{
    // A spike becomes a notch between two tips; on straight ways it passes outside of the upper one.
    const Polygon from{{0, -1}, {2, -0.5}, {6, 0}, {2, 0.5}, {0, 1}, {-1, 0}};
    const Polygon to{{0, -1}, {5, 0.9}, {1, 1.9}, {5, 1.2}, {0, 3}, {-1, 0}};
    const LoopPath path(from, to);
    EXPECT_LT(largest_jump([&](double f) { return path.at(f); }), 0.1);
    EXPECT_GT(largest_jump([&](double f) {
                  Polygon straight = from;
                  for (std::size_t i = 0; i < straight.size(); ++i)
                      straight[i] += f * (to[i] - from[i]);
                  return straight;
              }),
              3);
}

TEST(LoopPath, LeavesNoEdgeWithoutLength)
{
    const Polygon from = ellipse(40);
    Polygon to = from;
    for (std::size_t i = 0; i < to.size(); ++i)
        to[i] *= std::polar(1.0, 2.5 * to[i].real());
    const LoopPath path(from, to);
    for (int step = 1; step < 50; ++step) {
        const Polygon p = path.at(step / 50.0);
        for (std::size_t i = 0; i < p.size(); ++i) {
            const std::size_t next = (i + 1) % p.size();
            const double least = std::min(std::abs(from[next] - from[i]), std::abs(to[next] - to[i]));
            EXPECT_GT(std::abs(p[next] - p[i]), 0.3 * least);
        }
    }
}

} // namespace
