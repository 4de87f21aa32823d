#include "libmorph/geometry/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace {

using namespace morph;
using Box = BoxTree::Box;

/// Boxes on a coarse grid, many of them flat, a point, or equal: nearly every question has ties.
std::vector<Box> grid_boxes(Index count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> place(0, 5), side(0, 1);
    std::vector<Box> boxes;
    for (Index i = 0; i < count; ++i) {
        const Eigen::Vector3d low(place(random), place(random), place(random));
        boxes.emplace_back(low, low + Eigen::Vector3d(side(random), side(random), side(random)));
    }
    return boxes;
}

std::vector<Eigen::Vector3d> grid_points(unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> place(-4, 16);
    std::vector<Eigen::Vector3d> points;
    for (int i = 0; i < 200; ++i)
        points.emplace_back(0.5 * place(random), 0.5 * place(random), 0.5 * place(random));
    return points;
}

struct Shape {
    Index count, leaf_size;
    int axes;
};

void PrintTo(const Shape& shape, std::ostream* out)
{
    *out << shape.count << " items, " << shape.leaf_size << " in a leaf, " << shape.axes << " axes";
}

class BoxTreeOf : public testing::TestWithParam<Shape> {
protected:
    const Box& box(Index rank) const
    {
        return boxes[static_cast<std::size_t>(tree.order()[static_cast<std::size_t>(rank)])];
    }

    std::vector<Index> ranks_around(const Eigen::Vector3d& x) const
    {
        std::vector<Index> ranks;
        for (Index rank = 0; rank < GetParam().count; ++rank)
            if (box(rank).contains(x))
                ranks.push_back(rank);
        return ranks;
    }

    BoxTree::Candidate nearest(const Eigen::Vector3d& x, BoxTree::Candidate start = {}) const
    {
        return tree.least([&](const Box& b) { return b.squaredExteriorDistance(x); },
                          [&](Index rank) { return box(rank).squaredExteriorDistance(x); }, start);
    }

    double least_of_all(const Eigen::Vector3d& x) const
    {
        double least = HUGE_VAL;
        for (const Box& b : boxes)
            least = std::min(least, b.squaredExteriorDistance(x));
        return least;
    }

    std::vector<Box> boxes = grid_boxes(GetParam().count, 1);
    BoxTree tree{boxes, GetParam().leaf_size, GetParam().axes};
};

TEST_P(BoxTreeOf, HoldsEachItemOnce)
{
    std::vector<Index> all(boxes.size());
    std::iota(all.begin(), all.end(), 0);
    if (GetParam().axes == 0) {
        EXPECT_EQ(tree.order(), all);
    }
    EXPECT_TRUE(std::is_permutation(all.begin(), all.end(), tree.order().begin(), tree.order().end()));
}

TEST_P(BoxTreeOf, FindsTheLeastValueOfAll)
{
    for (const Eigen::Vector3d& x : grid_points(2)) {
        const BoxTree::Candidate found = nearest(x);
        ASSERT_GE(found.rank, 0);
        EXPECT_EQ(found.value, least_of_all(x));
        EXPECT_EQ(found.value, box(found.rank).squaredExteriorDistance(x));
    }
}

TEST_P(BoxTreeOf, KeepsAStartThatNothingIsLessThan)
{
    for (const Eigen::Vector3d& x : grid_points(3)) {
        const double least = least_of_all(x);
        for (Index rank = 0; rank < GetParam().count; ++rank) {
            const double value = box(rank).squaredExteriorDistance(x);
            const BoxTree::Candidate found = nearest(x, {rank, value});
            EXPECT_EQ(found.value, least);
            if (value == least) {
                EXPECT_EQ(found.rank, rank);
            }
        }
        EXPECT_EQ(nearest(x, {-7, least}).rank, -7);
    }
}

TEST_P(BoxTreeOf, OffersTheItemsAroundAPointByRank)
{
    for (const Eigen::Vector3d& x : grid_points(4)) {
        std::vector<Index> offered;
        EXPECT_FALSE(tree.find(x, [&](Index rank) {
            offered.push_back(rank);
            return false;
        }));
        EXPECT_TRUE(std::is_sorted(offered.begin(), offered.end()));
        const std::vector<Index> around = ranks_around(x);
        EXPECT_TRUE(std::includes(offered.begin(), offered.end(), around.begin(), around.end()));
        if (GetParam().leaf_size == 1) {
            EXPECT_EQ(offered, around);
        }
    }
}

TEST_P(BoxTreeOf, OffersNoMoreOnceAnItemIsTaken)
{
    for (const Eigen::Vector3d& x : grid_points(5)) {
        const std::vector<Index> around = ranks_around(x);
        Index calls = 0, taken = -1;
        const bool found = tree.find(x, [&](Index rank) {
            ++calls;
            taken = rank;
            return box(rank).contains(x);
        });
        EXPECT_EQ(found, !around.empty());
        if (!around.empty()) {
            EXPECT_EQ(taken, around.front());
        }
        if (!around.empty() && GetParam().leaf_size == 1) {
            EXPECT_EQ(calls, 1);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, BoxTreeOf,
                         testing::Values(Shape{1, 1, 0}, Shape{1, 4, 3}, Shape{2, 1, 0}, Shape{3, 1, 3},
                                         Shape{5, 4, 3}, Shape{8, 1, 0}, Shape{9, 1, 0}, Shape{37, 1, 0},
                                         Shape{37, 4, 2}, Shape{300, 1, 3}, Shape{300, 8, 2},
                                         Shape{300, 4, 3}));

TEST(BoxTree, OfNothingLeavesTheStartAndFindsNothing)
{
    const auto called = [](const auto&) {
        ADD_FAILURE() << "there is no box and no item";
        return 0.0;
    };
    for (const BoxTree& tree : {BoxTree(), BoxTree({}, 1, 0), BoxTree({}, 4, 3)}) {
        EXPECT_EQ(tree.least(called, called, {3, 2.5}).rank, 3);
        EXPECT_EQ(tree.least(called, called).rank, -1);
        EXPECT_FALSE(tree.find({0, 0, 0}, [](Index) { return true; }));
        EXPECT_TRUE(tree.order().empty());
    }
}

TEST(BoxTree, TakesTheFirstOfEqualItems)
{
    const BoxTree tree(std::vector<Box>(1000, Box(Eigen::Vector3d(1, 2, 3))), 4, 3);
    const auto found = tree.least([](const Box& b) { return b.min().x(); }, [](Index) { return 1.0; });
    EXPECT_EQ(found.rank, 0);
    EXPECT_EQ(found.value, 1);
}

TEST(BoxTree, SortsItemsAlongTheirLongestSide)
{
    std::vector<Box> boxes;
    for (const int y : {5, 1, 4, 2, 3, 0})
        boxes.emplace_back(Eigen::Vector3d(0.5 * y, y, 0));
    EXPECT_EQ(BoxTree(boxes, 1, 3).order(), (std::vector<Index>{5, 1, 3, 4, 2, 0}));
}

TEST(BoxTree, DoesNotHalveFurtherAxes)
{
    std::vector<Box> flat = grid_boxes(100, 6), tall = flat;
    for (std::size_t i = 0; i < tall.size(); ++i)
        tall[i].translate(Eigen::Vector3d(0, 0, 1000.0 * static_cast<double>(i % 17)));
    EXPECT_EQ(BoxTree(flat, 4, 2).order(), BoxTree(tall, 4, 2).order());
    EXPECT_NE(BoxTree(flat, 4, 3).order(), BoxTree(tall, 4, 3).order());
}

TEST(BoxTree, LooksAtFewItems)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<Box> boxes;
    for (int i = 0; i < 5000; ++i)
        boxes.emplace_back(Eigen::Vector3d(place(random), place(random), 0));
    const BoxTree tree(boxes, 4, 3);
    const Eigen::Vector3d x(0.3, 0.7, 0);
    int looks = 0;
    tree.least([&](const Box& b) { return b.squaredExteriorDistance(x); },
               [&](Index rank) {
                   ++looks;
                   const auto item = static_cast<std::size_t>(tree.order()[static_cast<std::size_t>(rank)]);
                   return (boxes[item].min() - x).squaredNorm();
               });
    EXPECT_LT(looks, 40);
}

} // namespace
