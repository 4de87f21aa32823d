#include "libmorph/remesh/target_size.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace morph {
namespace {

/// A quad of height 0.1 with an equilateral triangle of side 1 on it.
MeshData house()
{
    MeshData data;
    data.points.resize(5, 3);
    data.points << 0, 0, 0, 1, 0, 0, 1, 0.1, 0, 0, 0.1, 0, 0.5, 0.1 + std::sqrt(0.75), 0;
    data.elements = {{0, 1, 2, 3}, {3, 2, 4, -1}};
    return data;
}

TEST(TargetSize, OwnSizesAreThoseOfTrianglesWhereThereAreAny)
{
    const Mesh mesh = build_mesh(house());
    const Eigen::VectorXd sizes = current_sizes(mesh);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        EXPECT_NEAR(sizes[v], points(mesh)(v, 1) > 0 ? 1 : 0.55, 1e-15); // lengths of 1, and of 0.1 and 1
}

TEST(TargetSize, GradationIsTheSmallestSizePlusAFifthOfTheWayAndLeavesSmallerOnesAlone)
{
    const Mesh mesh = build_mesh(test::uneven_square(10));
    const auto place = points(mesh);
    Index corner = 0;
    place.rowwise().norm().minCoeff(&corner);
    Eigen::VectorXd sizes = Eigen::VectorXd::Constant(vertex_count(mesh), 5);
    sizes[corner] = 0.01;
    limit_gradation(mesh, 1.2, sizes);
    EXPECT_EQ(sizes[corner], 0.01);
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const double away = place.row(v).norm();
        EXPECT_GE(sizes[v], 0.01 + 0.2 * away * (1 - 1e-12));    // rounding of sums along the way
        EXPECT_LE(sizes[v], 0.01 + 0.2 * away * std::sqrt(2.0)); // paths along the edges of a grid
    }
}

TEST(TargetSize, ConformityNamesTheEdgeFarthestFromItsWish)
{
    MeshData data = house();
    data.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}, {3, 2, 4, -1}};
    const Mesh mesh = build_mesh(data);
    const Eigen::VectorXd sizes = Eigen::VectorXd::Constant(5, 1.0);
    const SizeConformity found = edge_conformity(mesh, sizes);
    EXPECT_NEAR(found.share, 5.0 / 7, 1e-15); // two of the seven edges have a length of 0.1
    EXPECT_NEAR(found.relative_length, 0.1, 1e-15);
    EXPECT_EQ(points(mesh)(found.worst[0], 0), points(mesh)(found.worst[1], 0)); // upright
    EXPECT_EQ(size_conformity(mesh, sizes), found.share);
}

TEST(TargetSize, ConformityLeavesOutTheEdgesOfQuads)
{
    const Mesh mesh = build_mesh(house());
    EXPECT_EQ(size_conformity(mesh, Eigen::VectorXd::Constant(5, 1.0)), 1);
    EXPECT_EQ(size_conformity(mesh, Eigen::VectorXd::Constant(5, 2.0)), 0); // two edges of half that remain
}

} // namespace
} // namespace morph
