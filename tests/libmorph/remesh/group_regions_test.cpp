#include "libmorph/remesh/group_regions.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

namespace {

using namespace morph;

/// A square of 4 x 4 quads, the lower two rows of which are a group.
Mesh two_zones()
{
    MeshData data = test::quad_square(4);
    data.groups = {{"lower", {0, 1, 2, 3, 4, 5, 6, 7}}};
    return build_mesh(data);
}

TEST(RegionBorders, AreAMarkerBetweenGroupsAsLongAsTheyExist)
{
    Mesh mesh = two_zones();
    mesh.markers.push_back({"borders of groups", {}}); // the name is taken
    const std::size_t markers = mesh.markers.size();
    Mesh remeshed;
    {
        const RegionBorders borders(mesh, group_regions(mesh));
        ASSERT_EQ(mesh.markers.size(), markers + 1);
        EXPECT_EQ(mesh.markers.back().edges.size(), 4U);
        for (const auto& edge : mesh.markers.back().edges)
            for (const Index v : edge)
                EXPECT_EQ(file_vertex(mesh, v) / 5, 2) << "the middle one of five rows of vertices";
        remeshed = mesh;
        borders.remove_from(remeshed);
    }
    EXPECT_EQ(mesh.markers.size(), markers);
    EXPECT_EQ(remeshed.markers.size(), markers);
    EXPECT_EQ(mesh.markers.back().name, "borders of groups");
}

TEST(RegionBorders, AreNoneWithoutGroups)
{
    Mesh mesh = build_mesh(test::quad_square(2));
    const std::size_t markers = mesh.markers.size();
    const RegionBorders borders(mesh, group_regions(mesh));
    EXPECT_EQ(mesh.markers.size(), markers);
}

} // namespace
