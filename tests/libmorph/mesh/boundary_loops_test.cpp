#include "libmorph/mesh/boundary_loops.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace {

using namespace morph;

double signed_area(const Mesh& mesh, const std::vector<Index>& loop)
{
    double twice = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const auto a = points(mesh).row(loop[i]), b = points(mesh).row(loop[(i + 1) % loop.size()]);
        twice += a(0) * b(1) - a(1) * b(0);
    }
    return 0.5 * twice;
}

double mesh_area(const Mesh& mesh)
{
    double area = 0;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        area += signed_area(mesh, {e.begin(), e.begin() + corner_count(e)});
    }
    return area;
}

TEST(BoundaryLoops, HaveTheMeshOnTheirLeft)
{
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 30));
    auto loops = boundary_loops(mesh);
    ASSERT_EQ(loops.size(), 2U);
    if (signed_area(mesh, loops[0]) < 0)
        loops[0].swap(loops[1]);
    EXPECT_GT(signed_area(mesh, loops[0]), 0); // counter-clockwise around the mesh
    EXPECT_LT(signed_area(mesh, loops[1]), 0); // clockwise around the hole
    EXPECT_NEAR(signed_area(mesh, loops[0]) + signed_area(mesh, loops[1]), mesh_area(mesh), 1e-12);
}

TEST(BoundaryLoops, GoOverEachBoundaryEdgeOnce)
{
    for (const MeshData& data : {test::uneven_annulus(0.5, 3, 30), test::touching_squares(4)}) {
        const Mesh mesh = build_mesh(data);
        std::size_t edges = 0, corners = 0;
        for (const auto edge : mesh.kernel.edges())
            edges += static_cast<std::size_t>(mesh.kernel.is_boundary(edge));
        for (const auto& loop : boundary_loops(mesh)) {
            corners += loop.size();
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const auto half = mesh.kernel.find_halfedge(VertexHandle(loop[i]),
                                                            VertexHandle(loop[(i + 1) % loop.size()]));
                ASSERT_TRUE(half.is_valid());
                EXPECT_TRUE(mesh.kernel.is_boundary(mesh.kernel.edge_handle(half)));
            }
        }
        EXPECT_EQ(corners, edges);
    }
}

TEST(BoundaryEdges, AreThoseOfTheLoopsOnceEach)
{
    for (const MeshData& data : {test::uneven_annulus(0.5, 3, 30), test::touching_squares(4)}) {
        const Mesh mesh = build_mesh(data);
        std::set<std::pair<Index, Index>> of_loops, found;
        for (const auto& loop : boundary_loops(mesh))
            for (std::size_t i = 0; i < loop.size(); ++i)
                of_loops.insert(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
        const auto edges = boundary_edges(mesh);
        for (const auto& [a, b] : edges)
            found.insert(std::minmax(a, b));
        EXPECT_EQ(found, of_loops);
        EXPECT_EQ(edges.size(), of_loops.size());
    }
}

} // namespace
