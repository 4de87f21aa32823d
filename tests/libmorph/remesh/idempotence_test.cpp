#include "libmorph/geometry/nearest_points.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/bad_region.h"
#include "libmorph/remesh/remesh.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

namespace morph {
namespace {

constexpr double kSize = 0.08;

MeshData remade(const MeshData& data)
{
    const Mesh mesh = build_mesh(data);
    return remesh(mesh, Eigen::VectorXd::Constant(vertex_count(mesh), kSize)).data;
}

/// Share of the vertices of one mesh that are farther than a part of the size from any of the other.
double share_moved(const MeshData& from, const MeshData& to, double part)
{
    std::atomic<int> moved = 0;
    NearestPoints(from.points)
        .nearest(to.points, 1, [&](Index, std::span<const NearestPoints::Neighbor> near) {
            moved += near[0].distance > part * kSize ? 1 : 0;
        });
    return static_cast<double>(moved) / static_cast<double>(to.points.rows());
}

double worst(const MeshData& data)
{
    const std::vector<double> quality = triangle_qualities(build_mesh(data));
    return *std::min_element(quality.begin(), quality.end());
}

TEST(Remesh, AgainAtTheSameSizeLeavesNearlyAllVerticesWhereTheyAre)
{
    const MeshData first = remade(test::annulus(1, 3, 80, 30));
    const MeshData second = remade(first), third = remade(second);
    EXPECT_NEAR(static_cast<double>(second.points.rows()), static_cast<double>(first.points.rows()),
                0.01 * static_cast<double>(first.points.rows()));
    // A vertex that is left less than 4 % from where it wants to be stays; some are not there when the last
    // sweep ends.
    EXPECT_LT(share_moved(first, second, 0.01), 0.1);
    EXPECT_LT(share_moved(first, second, 0.1), 0.05);
    EXPECT_LT(share_moved(second, third, 0.01), 0.02);
    EXPECT_GE(worst(second), worst(first) - 0.01);
}

} // namespace
} // namespace morph
