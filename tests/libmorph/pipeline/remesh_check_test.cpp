#include "libmorph/pipeline/remesh_job.h"

#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morph {
namespace {

/// The mesh itself as what remeshing made of it, with one target size everywhere.
RemeshCheck check_with_size(const Mesh& mesh, double size)
{
    const Eigen::VectorXd sizes = Eigen::VectorXd::Constant(vertex_count(mesh), size);
    return check_remeshing(mesh, mesh, {sizes, sizes, 0});
}

TEST(RemeshCheck, FindsTheWorstTriangle)
{
    const Mesh mesh = read_mesh(test::data_path("meshes/naca0012_inv.su2"));
    const std::optional<TriangleSummary> found = triangle_summary(mesh);
    ASSERT_TRUE(found.has_value());
    const Element e = element_corners(mesh, found->worst);
    const auto place = points(mesh);
    double sides = 0;
    for (std::size_t k = 0; k < 3; ++k)
        sides += (place.row(e[(k + 1) % 3]) - place.row(e[k])).squaredNorm();
    const Eigen::RowVector3d ab = place.row(e[1]) - place.row(e[0]), ac = place.row(e[2]) - place.row(e[0]);
    const double area = (ab[0] * ac[1] - ab[1] * ac[0]) / 2;
    EXPECT_NEAR(found->min, 4 * std::sqrt(3) * area / sides, 1e-12); // the formula loses a few digits
    EXPECT_GT(found->mean, found->min);
    EXPECT_FALSE(triangle_summary(build_mesh(test::quad_square(3))).has_value());
}

TEST(RemeshCheck, OfAMeshThatDidNotChangeHasNoDistance)
{
    const Mesh mesh = build_mesh(test::uneven_square(8));
    const RemeshCheck check = check_with_size(mesh, 0.125);
    EXPECT_EQ(check.before.vertices, check.after.vertices);
    EXPECT_EQ(check.distance.value, 0);
    EXPECT_EQ(check.isolated_left_out, 0);
    EXPECT_TRUE(is_valid(check));
}

TEST(RemeshCheck, NamesTheEdgeFarthestFromItsTargetAndWhyItIsShort)
{
    const Mesh mesh = build_mesh(test::uneven_square(8));
    const RemeshCheck held = check_with_size(mesh, 0.5);
    ASSERT_TRUE(held.sizes.has_value());
    const auto [a, b] = held.sizes->worst;
    const auto place = points(mesh);
    EXPECT_NEAR(held.sizes->relative_length, (place.row(a) - place.row(b)).norm() / 0.5, 1e-12);
    EXPECT_LT(held.sizes->relative_length, 0.7);
    EXPECT_EQ(held.sizes->middle.transpose(), (place.row(a) + place.row(b)) / 2);
    EXPECT_EQ(held.sizes->share, held.sizes->possible_share);

    const Index n = vertex_count(mesh);
    const RemeshCheck limited = check_remeshing(
        mesh, mesh, {Eigen::VectorXd::Constant(n, 0.5), Eigen::VectorXd::Constant(n, 0.125), 0});
    EXPECT_EQ(limited.sizes->cause, ShortEdgeCause::limited);
    EXPECT_DOUBLE_EQ(limited.sizes->possible_part, 0.25);
    EXPECT_GT(limited.sizes->possible_share, limited.sizes->share);
}

TEST(RemeshCheck, SaysThatBothEndsOfAShortEdgeAreHeld)
{
    const Mesh mesh = build_mesh(test::uneven_square(1)); // all vertices are on the boundary
    EXPECT_EQ(check_with_size(mesh, 10).sizes->cause, ShortEdgeCause::held);
    EXPECT_EQ(check_with_size(mesh, 1).sizes->cause, ShortEdgeCause::none);
}

TEST(RemeshCheck, HasNoSizesWithoutTriangles)
{
    EXPECT_FALSE(check_with_size(build_mesh(test::quad_square(3)), 0.3).sizes.has_value());
}

TEST(RemeshCheck, CountsVerticesOfNoElementThatAreGone)
{
    MeshData data = test::uneven_square(6);
    const Index count = static_cast<Index>(data.points.rows());
    data.points.conservativeResize(count + 2, 3);
    data.points.bottomRows(2) << 0.5, 0.5, 0, 7, 7, 0; // such as the centres of arcs
    const Mesh old = build_mesh(data);
    const RemeshedMesh made = remesh(old, RemeshJob{});
    EXPECT_EQ(check_remeshing(old, made.mesh, made.targets).isolated_left_out, 2);
}

TEST(RemeshCheck, KeepsASurfaceWithinTheDistanceAskedFor)
{
    RemeshJob job;
    job.sizes.size = 0.5;
    job.hausdorff = 0.004;
    const Mesh ball = build_mesh(test::sphere(20));
    const RemeshedMesh made = remesh(ball, job);
    const RemeshCheck check = check_remeshing(ball, made.mesh, made.targets);
    EXPECT_LE(check.distance.value, job.hausdorff);
    EXPECT_TRUE(check.folded.empty());
    EXPECT_TRUE(is_valid(check));
}

TEST(RemeshCheck, FindsTrianglesThatAreFoldedOver)
{
    MeshData data = test::sphere(6);
    const Mesh old = build_mesh(data);
    const auto [tip, a, b, none] = data.elements[0];
    const Eigen::RowVector3d beyond = data.points.row(a) + data.points.row(b) - data.points.row(tip);
    data.points.row(tip) = beyond.normalized(); // over the triangle next to it
    const Mesh folded = build_mesh(data);
    const Eigen::VectorXd sizes = Eigen::VectorXd::Constant(vertex_count(folded), 0.3);
    const RemeshCheck check = check_remeshing(old, folded, {sizes, sizes, 0});
    EXPECT_FALSE(check.folded.empty());
    EXPECT_FALSE(is_valid(check));
}

} // namespace
} // namespace morph
