#include "libmorph/quality/wall.h"

#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

namespace morph {
namespace {

// Differences and quotients of a few coordinates of size one.
constexpr double kTol = 1e-13;

/// The rectangle [0, 3] x [0, 1 + 2 + 4 + 8] of columns x 4 quads, each row twice as high as the one below;
/// vertex (i, j) is i + (columns + 1) j. Markers "wall" (below) and "top".
MeshData stretched_rectangle(Index columns)
{
    MeshData mesh;
    mesh.points.resize((Eigen::Index{columns} + 1) * 5, 3);
    const Index row = columns + 1;
    for (Index j = 0; j <= 4; ++j)
        for (Index i = 0; i <= columns; ++i)
            mesh.points.row(i + row * j) << 3.0 * i / columns, std::exp2(j) - 1, 0;
    mesh.markers = {{"wall", {}}, {"top", {}}};
    for (Index i = 0; i < columns; ++i) {
        for (Index j = 0; j < 4; ++j)
            mesh.elements.push_back({i + row * j, i + 1 + row * j, i + 1 + row * (j + 1), i + row * (j + 1)});
        mesh.markers[0].edges.push_back({i, i + 1});
        mesh.markers[1].edges.push_back({i + row * 4, i + 1 + row * 4});
    }
    return mesh;
}

/// The same with each quad cut from its first corner to its third.
MeshData triangulated(MeshData mesh)
{
    std::vector<Element> triangles;
    for (const Element& q : mesh.elements) {
        triangles.push_back({q[0], q[1], q[2], -1});
        triangles.push_back({q[0], q[2], q[3], -1});
    }
    mesh.elements = triangles;
    return mesh;
}

/// Every point (x, y) to (x + tan(degrees) y, y).
Points sheared(const Points& points, double degrees)
{
    Points after = points;
    after.col(0) += std::tan(degrees / 180 * std::numbers::pi) * points.col(1);
    return after;
}

TEST(WallQuality, KnowsTheHeightsOfAStretchedRectangle)
{
    for (const MeshData& data : {stretched_rectangle(5), triangulated(stretched_rectangle(5))}) {
        const Mesh mesh = build_mesh(test::shuffled(data, 2));
        const auto walls = wall_quality(mesh, points(mesh));
        ASSERT_EQ(walls.size(), 2U);
        EXPECT_EQ(walls[0].marker, "wall");
        EXPECT_EQ(walls[0].cells, 5);
        EXPECT_NEAR(walls[0].height.min, 1, kTol);
        EXPECT_NEAR(walls[0].height.mean, 1, kTol);
        EXPECT_NEAR(walls[0].height.max, 1, kTol);
        EXPECT_NEAR(walls[0].angle.max, 0, kTol);
        EXPECT_EQ(walls[1].marker, "top");
        EXPECT_NEAR(walls[1].height.min, 8, kTol);
        EXPECT_NEAR(walls[1].height.max, 8, kTol);
        EXPECT_FALSE(walls[0].change.has_value());
    }
}

TEST(WallQuality, OfAShearedRectangleHasTheShearAsItsAngleAndTheSameHeights)
{
    const Mesh mesh = build_mesh(stretched_rectangle(4));
    const Points before = points(mesh);
    const PositionsView reference = before;
    const auto walls = wall_quality(mesh, sheared(points(mesh), 30), &reference);
    for (const WallQuality& wall : walls) {
        EXPECT_NEAR(wall.angle.min, 30, 1e-12);
        EXPECT_NEAR(wall.angle.mean, 30, 1e-12);
        EXPECT_NEAR(wall.angle.max, 30, 1e-12);
        EXPECT_NEAR(wall.change->angle.value, 30, 1e-12);
        EXPECT_NEAR(wall.change->height.value, 0, kTol);
    }
    EXPECT_NEAR(walls[1].height.mean, 8, kTol);
}

TEST(WallCells, TakeTheWorseSideOfAQuadAndTheBetterOneOfATriangle)
{
    Points corners(4, 3);
    corners << 0, 0, 0, 1, 0, 0, 2, 1, 0, 0, 3, 0; // right side at 45 degrees, left one upright
    MeshData data;
    data.points = corners;
    data.elements = {{0, 1, 2, 3}};
    data.markers = {{"wall", {{0, 1}}}};
    const Mesh quad = build_mesh(data);
    const auto cell = wall_cells(quad, quad.markers[0], points(quad)).at(0);
    EXPECT_NEAR(cell.height, 2, kTol); // corners at 1 and 3
    EXPECT_NEAR(cell.angle, 45, 1e-12);
    data.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}};
    const Mesh triangles = build_mesh(data);
    const auto first = wall_cells(triangles, triangles.markers[0], points(triangles)).at(0);
    EXPECT_NEAR(first.height, 1, kTol);
    EXPECT_NEAR(first.angle, 45, 1e-12); // the other side is the diagonal, at 63 degrees
}

TEST(WallCells, AreNegativeAndObtuseWhenTheElementHasGoneThroughTheWall)
{
    const Mesh mesh = build_mesh(test::quad_square(1));
    Points after = points(mesh);
    for (Index v = 0; v < 4; ++v)
        after(v, 1) *= after(v, 1) > 0.5 ? -0.5 : 1;
    const WallCell cell = wall_cells(mesh, marker(mesh, "bottom"), after).at(0);
    EXPECT_NEAR(cell.height, -0.5, kTol);
    EXPECT_NEAR(cell.angle, 180, kTol);
}

TEST(WallCells, DoNotDependOnTheDirectionInWhichAMarkerListsItsEdges)
{
    MeshData data = stretched_rectangle(3);
    for (auto& edge : data.markers[0].edges)
        std::swap(edge[0], edge[1]);
    const Mesh mesh = build_mesh(data);
    EXPECT_NEAR(wall_quality(mesh, sheared(points(mesh), 10))[0].height.min, 1, kTol);
}

TEST(WallCells, LieOnBothSidesOfAWallInsideTheMesh)
{
    MeshData data = stretched_rectangle(3);
    data.markers = {{"inside", {{4, 5}, {5, 6}, {6, 7}}}}; // between heights 1 below and 2 above
    const Mesh mesh = build_mesh(data);
    const auto walls = wall_quality(mesh, points(mesh));
    EXPECT_EQ(walls.at(0).cells, 6);
    EXPECT_NEAR(walls[0].height.min, 1, kTol);
    EXPECT_NEAR(walls[0].height.mean, 1.5, kTol);
    EXPECT_NEAR(walls[0].height.max, 2, kTol);
}

TEST(WallCells, MeetAtAVertexThatTheBuilderSplits)
{
    const Mesh mesh = build_mesh(test::touching_squares(4));
    for (const WallQuality& wall : wall_quality(mesh, points(mesh)))
        EXPECT_EQ(wall.cells, 4) << wall.marker;
}

TEST(WallQuality, NamesTheCellThatAMoveChangesMost)
{
    const MeshData data = stretched_rectangle(5);
    const Mesh mesh = build_mesh(test::shuffled(data, 4));
    Points after = points(mesh);
    Eigen::Vector3d where;
    Index squeezed = -1;
    for (Index v = 0; v < after.rows(); ++v)
        if (after(v, 1) == 1 && std::abs(after(v, 0) - 3) < 1e-12) { // above the last corner of the wall
            after(v, 1) = 0.5;
            where = {2.7, 0, 0}; // middle of the last edge
        }
    for (const WallCell& cell : wall_cells(mesh, mesh.markers[0], after))
        if (cell.height < 0.8)
            squeezed = mesh.numbering.element[static_cast<std::size_t>(cell.face)];
    const Points before = points(mesh);
    const PositionsView reference = before;
    const WallChange change = *wall_quality(mesh, after, &reference)[0].change;
    EXPECT_NEAR(change.height.value, 0.25, kTol); // one of two upper corners comes down by half
    EXPECT_EQ(change.height.element, squeezed);
    EXPECT_LT((change.height.middle - where).norm(), kTol);
}

TEST(WallQuality, ChangesByNothingUnderARigidMoveOfRealMeshes)
{
    for (const std::string& path : test::real_meshes()) {
        const Mesh mesh = read_mesh(path);
        if (mesh.dimension != 2)
            continue;
        Points turned = points(mesh);
        turned.leftCols<2>() = points(mesh).leftCols<2>() * Eigen::Rotation2Dd(0.7).toRotationMatrix();
        const Points before = points(mesh);
        const PositionsView reference = before;
        // A first cell of 1e-6 at coordinates of 1 to 500 has lost as many of its digits.
        for (const WallQuality& wall : wall_quality(mesh, turned, &reference)) {
            EXPECT_LT(wall.change->height.value, 1e-7) << path << ' ' << wall.marker;
            EXPECT_LT(wall.change->angle.value, 1e-5) << path << ' ' << wall.marker;
            EXPECT_GT(wall.height.min, 0);
        }
    }
}

TEST(WallQuality, OfASurfaceIsThatOfThePlaneItLiesIn)
{
    MeshData data = stretched_rectangle(3);
    data.points = sheared(data.points, 20) *
                  Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    data.dimension = 3;
    const Mesh mesh = build_mesh(data);
    const auto walls = wall_quality(mesh, points(mesh));
    EXPECT_NEAR(walls.at(0).height.mean, 1, kTol);
    EXPECT_NEAR(walls[0].angle.max, 20, 1e-12);
}

TEST(WallQuality, IsFiniteForElementsThatHaveShrunk)
{
    const Mesh mesh = build_mesh(test::quad_square(2));
    const Points none = Points::Zero(9, 3);
    const PositionsView reference = none;
    for (const WallQuality& wall : wall_quality(mesh, points(mesh), &reference))
        EXPECT_EQ(wall.change->height.value, std::numeric_limits<double>::max());
    for (const WallQuality& wall : wall_quality(mesh, none, &reference)) {
        EXPECT_EQ(wall.change->height.value, 0);
        EXPECT_EQ(wall.angle.max, 0);
    }
}

TEST(WallQuality, RefusesPositionsOfAnotherMesh)
{
    const Mesh mesh = build_mesh(test::quad_square(1));
    const Points few = Points::Zero(3, 3);
    EXPECT_EQ(test::message_of([&] { wall_quality(mesh, few); }),
              "there are 3 positions, but the mesh has 4 vertices");
}

} // namespace
} // namespace morph
