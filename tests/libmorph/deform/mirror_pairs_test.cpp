#include "libmorph/core/error.h"
#include "libmorph/deform/mirror_pairs.h"
#include "tests/support/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Pair = std::array<Index, 2>;

TEST(MirrorPairs, JoinEachPointWithItsImageAndThoseOnTheMirrorWithThemselves)
{
    Matrix points(5, 2);
    points << 0, 1, 4, 1 + 1e-9, 1, 3, 2, -1, 3, 3;
    EXPECT_THAT(mirror_pairs(points, {2, 7, 0}, {-5, 0, 0}), ElementsAre(Pair{0, 1}, Pair{2, 4}, Pair{3, 3}));
}

TEST(MirrorPairs, AreFoundInSlantedMirrorsAndInSpace)
{
    Matrix points(2, 3);
    points << 1, 2, 5, 2, 1, 5;
    EXPECT_THAT(mirror_pairs(points, {0, 0, 9}, {1, -1, 0}), ElementsAre(Pair{0, 1}));
}

TEST(MirrorPairs, NameAPointWithoutAnImage)
{
    Matrix points(3, 2);
    points << 0, 1, 0, -1, 1, 2;
    EXPECT_THAT(test::message_of([&] {
                    mirror_pairs(points, {0, 0, 0}, {0, 1, 0});
                }),
                HasSubstr("control point 2 has no image in the mirror"));
    EXPECT_THROW(mirror_pairs(points, {0, 0, 0}, {0, 0, 1}), InputError);
}

TEST(MirrorPairs, RefuseTwoPointsWithTheSameImage)
{
    Matrix points(3, 2);
    points << 0, 1, 0, 1, 0, -1;
    EXPECT_THROW(mirror_pairs(points, {0, 0, 0}, {0, 1, 0}), InputError);
}

} // namespace
