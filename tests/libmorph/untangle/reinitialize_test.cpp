#include "libmorph/untangle/reinitialize.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using namespace morph;

std::vector<char> dirichlet_boundary(const Mesh& mesh)
{
    std::vector<char> held(static_cast<std::size_t>(vertex_count(mesh)));
    for (const VertexHandle v : mesh.kernel.vertices())
        held[static_cast<std::size_t>(v.idx())] = static_cast<char>(mesh.kernel.is_boundary(v));
    return held;
}

TEST(SpreadMove, GivesATranslationOfTheBoundaryToEveryVertex)
{
    for (const MeshData& data : {test::uneven_square(6), test::quad_square(6)}) {
        const Mesh mesh = build_mesh(data);
        const Points after = points(mesh).rowwise() + Eigen::RowVector3d(2, -1, 0);
        const auto move = spread_move(mesh, VertexStars(mesh), points(mesh), dirichlet_boundary(mesh), after);
        ASSERT_TRUE(move);
        EXPECT_LT((move->rowwise() - Eigen::RowVector2d(2, -1)).cwiseAbs().maxCoeff(), 1e-12);
    }
}

TEST(SpreadMove, DoesNotDependOnWhereTheFreeVerticesCameToLie)
{
    const Mesh mesh = build_mesh(test::uneven_square(6));
    const auto held = dirichlet_boundary(mesh);
    Points after = 1.5 * points(mesh);
    const auto move = spread_move(mesh, VertexStars(mesh), points(mesh), held, after);
    for (Index v = 0; v < after.rows(); ++v)
        if (!held[static_cast<std::size_t>(v)])
            after.row(v) << 7, 8, 0;
    EXPECT_EQ(*spread_move(mesh, VertexStars(mesh), points(mesh), held, after), *move);
}

TEST(SpreadMove, LetsLargeElementsGiveWayFirst)
{
    // On a graded ring whose hole moves, the displacement of the smallest elements is nearest to that of the
    // hole: with g = r^-2 it is harmonic in r^2 instead of ln(r).
    const Mesh mesh = build_mesh(test::annulus(1, 4, 120, 30));
    Points after = points(mesh);
    for (const Index v : marker_vertices(marker(mesh, "inner")))
        after(v, 0) += 1;
    const auto move = spread_move(mesh, VertexStars(mesh), points(mesh), dirichlet_boundary(mesh), after);
    ASSERT_TRUE(move);
    for (Index v = 0; v < after.rows(); ++v) {
        const double r = points(mesh).row(v).norm();
        EXPECT_NEAR((*move)(v, 0), (16 - r * r) / 15, 0.02) << r;
    }
}

TEST(SpreadMove, IsNothingWhereAPartOfTheMeshIsNotHeld)
{
    const Mesh mesh = build_mesh(test::uneven_square(3));
    EXPECT_FALSE(spread_move(mesh, VertexStars(mesh), points(mesh),
                             std::vector<char>(static_cast<std::size_t>(vertex_count(mesh))), points(mesh)));
}

} // namespace
