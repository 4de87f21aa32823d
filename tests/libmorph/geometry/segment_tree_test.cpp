#include "libmorph/geometry/segment_tree.h"

#include "libmorph/core/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

using namespace morph;

// A distance is a few operations on numbers of size 1.
constexpr double kRoundOff = 1e-15;

/// Distance by minimising over the segment's parameter: not the formula under test.
double distance_to(const Points& points, const std::array<Index, 2>& segment, const Eigen::Vector3d& x)
{
    const Eigen::Vector3d a = points.row(segment[0]), b = points.row(segment[1]);
    const double length2 = (b - a).squaredNorm();
    const double t = length2 > 0 ? std::clamp((x - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
    return (x - a - t * (b - a)).norm();
}

class RandomSegments : public testing::TestWithParam<Index> {
protected:
    RandomSegments() : points(Points::Random(Eigen::Index{2} * GetParam(), 3))
    {
        for (Index i = 0; i < GetParam(); ++i)
            segments.push_back({2 * i, i % 5 == 0 ? 2 * i : 2 * i + 1}); // every fifth is a point
    }

    double brute_force(const Eigen::Vector3d& x) const
    {
        double least = HUGE_VAL;
        for (const auto& segment : segments)
            least = std::min(least, distance_to(points, segment, x));
        return least;
    }

    Points points;
    std::vector<std::array<Index, 2>> segments;
};

TEST_P(RandomSegments, TheNearestIsAsNearAsAmongAll)
{
    const SegmentTree tree(points, segments);
    for (int i = 0; i < 300; ++i) {
        const Eigen::Vector3d x = 3 * Eigen::Vector3d::Random();
        const SegmentTree::Nearest found = tree.nearest(x);
        EXPECT_NEAR(found.distance, brute_force(x), 10 * kRoundOff);
        const auto& segment = segments[static_cast<std::size_t>(found.segment)];
        EXPECT_NEAR(found.distance, distance_to(points, segment, x), 10 * kRoundOff);
    }
}

TEST_P(RandomSegments, AHintChangesNothingButTime)
{
    const SegmentTree tree(points, segments);
    for (Index hint = 0; hint < GetParam(); ++hint) {
        const Eigen::Vector3d x = Eigen::Vector3d::Random();
        EXPECT_EQ(tree.nearest(x, hint).distance, tree.nearest(x).distance);
    }
}

INSTANTIATE_TEST_SUITE_P(Counts, RandomSegments, testing::Values(1, 4, 5, 37, 500));

TEST(SegmentTree, MeasuresPastTheEndsAndBesideTheMiddle)
{
    Points points(2, 3);
    points << 0, 0, 0, 2, 0, 0;
    const SegmentTree tree(points, {{0, 1}});
    EXPECT_DOUBLE_EQ(tree.nearest(1, 0.25).distance, 0.25);
    EXPECT_DOUBLE_EQ(tree.nearest(-3, 4).distance, 5);
    EXPECT_DOUBLE_EQ(tree.nearest(5, -4).distance, 5);
    EXPECT_DOUBLE_EQ(tree.nearest(0.5, 0).distance, 0);
}

TEST(SegmentTree, CopesWithManySegmentsInOnePlace)
{
    Points points(2, 3);
    points << 0, 0, 0, 1, 0, 0;
    const SegmentTree tree(points, std::vector<std::array<Index, 2>>(1000, {0, 1}));
    EXPECT_DOUBLE_EQ(tree.nearest(0.5, 2).distance, 2);
}

TEST(SegmentTree, RefusesToMeasureToNothing)
{
    EXPECT_THROW(SegmentTree(Points::Zero(2, 3), {}), InputError);
}

} // namespace
