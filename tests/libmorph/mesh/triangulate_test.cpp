#include "libmorph/mesh/triangulate.h"

#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using testing::ElementsAre;

MeshData one_quad(const std::vector<std::array<double, 2>>& corners)
{
    MeshData mesh;
    mesh.points = Points::Zero(4, 3);
    for (Index v = 0; v < 4; ++v)
        mesh.points.row(v) << corners[static_cast<std::size_t>(v)][0],
            corners[static_cast<std::size_t>(v)][1], 0;
    mesh.elements = {{0, 1, 2, 3}};
    return mesh;
}

double signed_area(const MeshData& mesh, const Element& t)
{
    const Eigen::RowVector3d a = mesh.points.row(t[1]) - mesh.points.row(t[0]);
    const Eigen::RowVector3d b = mesh.points.row(t[2]) - mesh.points.row(t[0]);
    return (a(0) * b(1) - a(1) * b(0)) / 2;
}

TEST(Triangulate, AQuadIsCutAlongItsShorterDiagonal)
{
    EXPECT_THAT(triangulated(one_quad({{0, 0}, {2, 0}, {3, 1}, {1, 1}})).elements,
                ElementsAre(Element{0, 1, 3, -1}, Element{1, 2, 3, -1}));
    EXPECT_THAT(triangulated(one_quad({{1, 0}, {3, 0}, {2, 1}, {0, 1}})).elements,
                ElementsAre(Element{0, 1, 2, -1}, Element{0, 2, 3, -1}));
}

TEST(Triangulate, AQuadThatIsNotConvexIsCutWhereBothTrianglesStayPositive)
{
    // A dart whose inward corner is 2: the shorter diagonal, from 1 to 3, lies outside it.
    const MeshData dart = one_quad({{0, 0}, {4, 1}, {3, 3}, {1, 4}});
    const MeshData inward = one_quad({{0, 0}, {1, -0.5}, {0.2, 0}, {1, 0.5}});
    for (const MeshData& mesh : {dart, inward}) {
        const MeshData split = triangulated(mesh);
        for (const Element& triangle : split.elements)
            EXPECT_GT(signed_area(split, triangle), 0);
    }
    EXPECT_THAT(triangulated(inward).elements, ElementsAre(Element{0, 1, 2, -1}, Element{0, 2, 3, -1}));
}

TEST(Triangulate, FieldsGroupsAndMarkersComeAlong)
{
    MeshData mesh = test::quad_square(2); // 4 quads
    mesh.elements.push_back({0, 1, 3, -1});
    mesh.groups = {{"last two", {4, 3}}};
    Field number{"number", FieldLocation::element, Matrix(5, 1)};
    number.values << 10, 11, 12, 13, 14;
    mesh.fields = {number};
    const MeshData split = triangulated(mesh);
    ASSERT_EQ(split.elements.size(), 9U);
    EXPECT_EQ(split.elements.back(), mesh.elements.back());
    EXPECT_THAT(split.groups[0].elements, ElementsAre(8, 6, 7));
    const Matrix& values = split.fields[0].values;
    EXPECT_THAT(std::vector<double>(values.data(), values.data() + 9),
                ElementsAre(10, 10, 11, 11, 12, 12, 13, 13, 14));
    ASSERT_EQ(split.markers.size(), mesh.markers.size());
    EXPECT_EQ(split.markers[0].edges, mesh.markers[0].edges);
}

TEST(Triangulate, AreaIsKept)
{
    const MeshData mesh = test::quad_square(7);
    const MeshData split = triangulated(mesh);
    double area = 0;
    for (const Element& triangle : split.elements)
        area += signed_area(split, triangle);
    EXPECT_NEAR(area, 1, 1e-14); // a sum of 98 numbers below 1
}

TEST(Triangulate, AMeshOfTrianglesIsLeftAsItIs)
{
    const MeshData mesh = test::uneven_square(3);
    EXPECT_EQ(test::difference(mesh, triangulated(mesh)), "");
}

} // namespace
