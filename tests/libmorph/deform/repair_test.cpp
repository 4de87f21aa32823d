#include "libmorph/deform/repair.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace morph;
using test::boundary_displacement;
using test::dirichlet_boundary;

/// The mesh with its inner boundary turned and nothing else moved: elements next to it are inverted.
Mesh left_behind(const Mesh& start, const DirichletBoundary& held, const Matrix& displacement)
{
    Mesh mesh = start;
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        points(mesh).row(held.vertices[i]).head<2>() += displacement.row(static_cast<Index>(i));
    return mesh;
}

TEST(Repair, HoldsTheBoundaryAndEndsWithoutInvertedElements)
{
    const Mesh start = build_mesh(test::uneven_annulus(0.5, 3, 60));
    const DirichletBoundary held = dirichlet_boundary(start, {"inner"});
    for (const double degrees : {30.0, 90.0, 170.0}) {
        const Matrix D = boundary_displacement(start, held, test::turn(degrees, {0.1, 0}));
        Mesh mesh = left_behind(start, held, D);
        ASSERT_FALSE(inverted_elements(mesh, points(mesh)).empty());
        const UntangleResult result = repair(mesh, points(start));
        EXPECT_TRUE(result.valid) << degrees;
        EXPECT_TRUE(inverted_elements(mesh, points(mesh)).empty());
        for (std::size_t i = 0; i < held.vertices.size(); ++i)
            ASSERT_EQ(points(mesh).row(held.vertices[i]).head<2>(),
                      points(start).row(held.vertices[i]).head<2>() + D.row(static_cast<Index>(i)));
    }
}

TEST(Repair, HoldsMarkersInsideTheMesh)
{
    // Noise on all vertices but those of the boundary and an inner wall.
    MeshData data = test::uneven_square(12);
    Marker wall{"wall", {}};
    for (Index i = 3; i < 9; ++i)
        wall.edges.push_back({6 * 13 + i, 6 * 13 + i + 1});
    data.markers.push_back(wall);
    const Mesh start = build_mesh(data);
    Mesh mesh = start;
    const std::vector<Index> of_wall = marker_vertices(marker(mesh, "wall"));
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (!mesh.kernel.is_boundary(Kernel::VertexHandle(v)) &&
            std::find(of_wall.begin(), of_wall.end(), v) == of_wall.end())
            points(mesh).row(v).head<2>() +=
                Eigen::RowVector2d(0.1 * std::sin(7.0 * v), 0.1 * std::cos(11.0 * v));
    ASSERT_FALSE(inverted_elements(mesh, points(mesh)).empty());
    EXPECT_TRUE(repair(mesh, points(start)).valid);
    for (const Index v : of_wall)
        EXPECT_EQ(points(mesh).row(v), points(start).row(v));
}

TEST(Repair, EndsWithTheBestOfItsStartsWhereNoValidMeshExists)
{
    // The hole has left the domain.
    const Mesh start = build_mesh(test::uneven_annulus(0.5, 3, 30));
    const DirichletBoundary held = dirichlet_boundary(start, {"inner"});
    const Matrix D =
        boundary_displacement(start, held, [](double, double) { return Eigen::RowVector2d(8, 0); });
    Mesh mesh = left_behind(start, held, D);
    Points alone = points(mesh);
    const UntangleResult first = untangle(mesh, points(start), held.vertices, alone);
    const UntangleResult result = repair(mesh, points(start));
    EXPECT_FALSE(result.valid);
    EXPECT_EQ(result.inverted, inverted_elements(mesh, points(mesh)));
    EXPECT_LE(result.inverted.size(), first.inverted.size());
    EXPECT_GT(result.iterations, first.iterations); // the other starts were tried
    for (std::size_t i = 0; i < held.vertices.size(); ++i)
        ASSERT_EQ(points(mesh).row(held.vertices[i]).head<2>(),
                  points(start).row(held.vertices[i]).head<2>() + D.row(static_cast<Index>(i)));
}

TEST(Repair, LeavesAValidMeshAsItIs)
{
    const Mesh start = build_mesh(test::uneven_square(8));
    Mesh mesh = start;
    EXPECT_TRUE(repair(mesh, points(start)).valid);
    EXPECT_EQ(points(mesh), points(start));
}

} // namespace
