#include "libmorph/remap/target_locations.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace {

using namespace morph;

Points rows(std::initializer_list<std::array<double, 3>> list)
{
    Points points(static_cast<Index>(list.size()), 3);
    Index row = 0;
    for (const auto& [x, y, z] : list)
        points.row(row++) << x, y, z;
    return points;
}

TEST(TargetLocations, CountTargetsOutsideThePlaneAndNameTheFarthestByItsFileNumber)
{
    const Mesh source = build_mesh(test::uneven_square(4)); // of the unit square
    const Points targets = rows({{0.5, 0.5, 0}, {1.25, 0.5, 0}, {0.5, -0.75, 0}, {0.25, 1.75, 0}});
    const TargetLocations found = locate_targets(Locator(source), targets);
    const TargetCounts counts = count_targets(found, {7, 3, 9, 5});
    EXPECT_EQ(counts.targets, 4U);
    EXPECT_EQ(counts.outside, 3U);
    EXPECT_EQ(counts.farthest, 5) << "of two equally far ones the lower number";
    EXPECT_EQ(counts.distance, 0.75);
    EXPECT_EQ(counts.where, targets.row(3));
    EXPECT_EQ(target_status(found), (Matrix(4, 1) << 0, 1, 1, 1).finished());
    EXPECT_EQ(target_distances(found), (Matrix(4, 1) << 0, 0.25, 0.75, 0.75).finished());
}

TEST(TargetLocations, HaveADistanceOfEveryTargetOfASurface)
{
    MeshData data = test::uneven_square(4);
    data.dimension = 3;
    data.points.col(2).setConstant(2);
    const Mesh source = build_mesh(data);
    const Points targets = rows({{0.5, 0.5, 2.5}, {1.75, 0.5, 2}});
    const TargetLocations found = locate_targets(Locator(source), targets);
    EXPECT_EQ(target_status(found), (Matrix(2, 1) << 0, 1).finished());
    EXPECT_TRUE(target_distances(found).isApprox((Matrix(2, 1) << 0.5, 0.75).finished(), 1e-14));
}

TEST(TargetLocations, CountNoneOutsideWhereAllAreInside)
{
    const Mesh source = build_mesh(test::uneven_square(4));
    const Points targets = points(source);
    const TargetCounts counts =
        count_targets(locate_targets(Locator(source), targets), source.numbering.vertex);
    EXPECT_EQ(counts.outside, 0U);
    EXPECT_EQ(counts.farthest, -1);
}

} // namespace
