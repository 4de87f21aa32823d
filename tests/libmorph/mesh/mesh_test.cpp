#include "libmorph/mesh/mesh.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

/// A square of quads whose last one is cut into two triangles.
MeshData mixed_square()
{
    MeshData data = test::quad_square(4);
    const Element q = data.elements.back();
    data.elements.back() = {q[0], q[1], q[2], -1};
    data.elements.push_back({q[0], q[2], q[3], -1});
    return data;
}

TEST(Mesh, TableAgreesWithTheCirculators)
{
    const Mesh mesh = build_mesh(test::shuffled(mixed_square(), 1));
    const std::vector<Element> table = element_table(mesh);
    ASSERT_EQ(table.size(), 17U);
    for (Index f = 0; f < element_count(mesh); ++f) {
        std::vector<Index> corners;
        for (const VertexHandle v : mesh.kernel.fv_range(FaceHandle(f)))
            corners.push_back(v.idx());
        corners.resize(4, -1);
        EXPECT_THAT(table[static_cast<std::size_t>(f)], testing::ElementsAreArray(corners));
        EXPECT_EQ(element_corners(mesh, f), table[static_cast<std::size_t>(f)]);
    }
}

TEST(Mesh, PointsAreThoseOfTheKernel)
{
    Mesh mesh = build_mesh(mixed_square());
    points(mesh).row(3) << 7, 8, 9;
    EXPECT_EQ(mesh.kernel.point(VertexHandle(3)), OpenMesh::Vec3d(7, 8, 9));
    const Mesh& fixed = mesh;
    for (Index v = 0; v < vertex_count(fixed); ++v)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_EQ(points(fixed)(v, axis),
                      fixed.kernel.point(VertexHandle(v))[static_cast<unsigned>(axis)]);
}

TEST(Mesh, MovedPointsComeBackInTheOrderOfTheFile)
{
    const MeshData data = test::shuffled(mixed_square(), 2);
    Mesh mesh = build_mesh(data);
    points(mesh) *= 2;
    EXPECT_EQ(to_mesh_data(mesh).points, data.points * 2);
}

TEST(Mesh, FindsAMarkerByName)
{
    const Mesh mesh = build_mesh(mixed_square());
    EXPECT_EQ(&marker(mesh, "right"), &mesh.markers[1]);
}

TEST(Mesh, NamesTheMarkersItHasWhenAskedForAnother)
{
    Mesh mesh = build_mesh(mixed_square());
    try {
        marker(mesh, "botom");
        ADD_FAILURE() << "found a marker that is not there";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "marker 'botom' is not in the mesh, which has bottom, right, top, left; "
                                   "did you mean 'bottom'?");
    }
    mesh.markers.clear();
    EXPECT_THROW(marker(mesh, "bottom"), InputError);
}

TEST(Mesh, ListsTheVerticesOfAMarkerOnce)
{
    EXPECT_THAT(marker_vertices({"ring", {{4, 2}, {2, 9}, {9, 4}, {9, 1}}}),
                testing::ElementsAre(4, 2, 9, 1));
    EXPECT_THAT(marker_vertices({"none", {}}), testing::IsEmpty());
}

} // namespace

} // namespace morph
