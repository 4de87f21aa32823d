#include "libmorph/geometry/surface_predicates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morph {
namespace {

TEST(OnOneLine, TellsCollinearPointsOfSpaceFromThoseOneUnitInTheLastPlaceOff)
{
    const Eigen::Vector3d a(0.1, 0.2, 0.3);
    const Eigen::Vector3d step(0.25, -0.5, 0.125);
    const Eigen::Vector3d origin(1, 2, 3);
    EXPECT_TRUE(on_one_line(origin, origin + step, origin + 2 * step));
    EXPECT_TRUE(on_one_line(a, a, Eigen::Vector3d(4, 5, 6)));
    Eigen::Vector3d off = origin + 2 * step;
    off.z() = std::nextafter(off.z(), 10.0);
    EXPECT_FALSE(on_one_line(origin, origin + step, off));
}

TEST(QuadCornerSign, AgreesWithThePlaneForEveryCornerOfAFlatQuad)
{
    const Eigen::Vector3d a(0, 0, 1);
    const Eigen::Vector3d b(2, 0, 1);
    const Eigen::Vector3d c(2, 2, 1);
    const Eigen::Vector3d dented(1.5, 1, 1); // beyond the diagonal from a to c: corner d is dented
    EXPECT_EQ(quad_corner_sign(a, b, c, dented), 1);
    EXPECT_EQ(quad_corner_sign(dented, a, b, c), -1);
    EXPECT_EQ(quad_corner_sign(Eigen::Vector3d(1, 1, 1), a, b, c), 0);
}

TEST(QuadCornerSign, KeepsItsSignWhenTheQuadIsMovedSlightlyOffADegenerateOne)
{
    const Eigen::Vector3d a(0.5, 0.25, -1);
    const Eigen::Vector3d b(2.5, 0.25, 3);
    const Eigen::Vector3d c(2.5, 4.25, 1);
    const Eigen::Vector3d middle = (a + c) / 2;
    EXPECT_EQ(quad_corner_sign(middle, a, b, c), 0);
    // Away from b the corner opens, towards b it dents.
    const Eigen::Vector3d away = middle + (middle - b) * std::ldexp(1.0, -48);
    const Eigen::Vector3d towards = middle - (middle - b) * std::ldexp(1.0, -48);
    EXPECT_EQ(quad_corner_sign(away, a, b, c), 1);
    EXPECT_EQ(quad_corner_sign(towards, a, b, c), -1);
}

} // namespace
} // namespace morph
