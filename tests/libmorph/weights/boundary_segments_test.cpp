#include "libmorph/weights/boundary_segments.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/boundary_moves.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace morph;

TEST(BoundarySegments, AreTheMovingOnesAndTheRestOfTheBoundaryOnceEach)
{
    const Mesh mesh = build_mesh(test::uneven_square(4));
    DirichletBoundary held = test::dirichlet_boundary(mesh, {"bottom"});
    std::swap(held.moving_edges[0][0], held.moving_edges[0][1]); // the direction does not matter
    const BoundarySegments edges = boundary_segments(mesh, held, UniqueDirichletVertices(mesh, held));
    EXPECT_EQ(edges.moving.size(), 4);
    EXPECT_EQ(edges.still.size(), 12);
}

TEST(BoundarySegments, IncludeWallsAndLoneVertices)
{
    const Mesh mesh = build_mesh(test::uneven_square(4));
    std::vector<Index> inner;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (!mesh.kernel.is_boundary(v))
            inner.push_back(v.idx());
    DirichletBoundary held = test::dirichlet_boundary(mesh, {"bottom"});
    const auto boundary = static_cast<Index>(held.vertices.size());
    held.vertices.insert(held.vertices.end(), inner.begin(), inner.begin() + 3);
    held.fixed_edges = {{inner[0], inner[1]}, {inner[0], inner[3]}}; // the last is not held
    const BoundarySegments edges = boundary_segments(mesh, held, UniqueDirichletVertices(mesh, held));
    ASSERT_EQ(edges.still.size(), 14);
    EXPECT_EQ(edges.still[12], (BoundarySegment{boundary, boundary + 1}));
    EXPECT_EQ(edges.still[13], (BoundarySegment{boundary + 2, boundary + 2}));
}

TEST(UniqueDirichletVertices, TakeTheCopiesOfASplitVertexAsOne)
{
    const Mesh mesh = build_mesh(test::touching_squares(3));
    const DirichletBoundary held = test::dirichlet_boundary(mesh, {"top"});
    const UniqueDirichletVertices vertices(mesh, held);
    const auto rows = vertices.rows();
    const auto copies = static_cast<std::ptrdiff_t>(mesh.numbering.vertex.size()) -
                        static_cast<std::ptrdiff_t>(mesh.numbering.file_vertices);
    EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [](Index row) { return row >= 0; }),
              static_cast<std::ptrdiff_t>(vertices.vertices().size()) + copies);
    Matrix everything = Matrix::Zero(vertex_count(mesh), 1);
    vertices.restore(vertices.join(Matrix::Ones(static_cast<Index>(held.vertices.size()), 1)), everything);
    EXPECT_EQ(everything.sum(), static_cast<double>(vertices.vertices().size()) + copies);
}

TEST(NearestOnSegments, FindsTheNearestPointAndTheValueThere)
{
    Points points(4, 3);
    points << 0, 0, 0, 2, 0, 0, 2, 2, 0, 5, 5, 0;
    const NearestOnSegments edges(points, {{0, 1}, {1, 2}, {3, 3}});
    Matrix values(4, 1);
    values << 10, 20, 40, 7;
    const auto expect = [&](double x, double y, double distance, double value) {
        const EdgePoint point = edges.nearest({x, y, 0});
        EXPECT_NEAR(point.distance, distance, 1e-15);
        EXPECT_NEAR(point.value(values)[0], value, 1e-14);
    };
    expect(0.5, -1, 1, 12.5); // next to the first edge
    expect(-3, 4, 5, 10);     // beyond its end
    expect(3, 1.5, 1, 35);    // next to the second
    expect(5, 8, 3, 7);       // near the lone vertex
    expect(2, 0, 0, 20);      // on a vertex
}

} // namespace
