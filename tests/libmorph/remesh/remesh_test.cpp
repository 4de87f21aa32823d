#include "libmorph/remesh/remesh.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morph {
namespace {

Eigen::VectorXd uniform(const Mesh& mesh, double size)
{
    return Eigen::VectorXd::Constant(vertex_count(mesh), size);
}

double area(const MeshData& data)
{
    double sum = 0;
    for (const Element& e : data.elements) {
        const Eigen::Vector3d a = data.points.row(e[0]), b = data.points.row(e[1]), c = data.points.row(e[2]);
        sum += (b - a).cross(c - a).z() / 2;
    }
    return sum;
}

TEST(Remesh, KeepsTheAreaOfASquareExactlyAndItsCorners)
{
    const Mesh mesh = build_mesh(test::uneven_square(20));
    for (const double size : {0.02, 0.05, 0.12}) {
        const MeshData data = remesh(mesh, uniform(mesh, size)).data;
        EXPECT_NEAR(area(data), 1, 1e-13) << size; // sums of some thousand products of rounded numbers
        for (const Eigen::RowVector3d& corner : {Eigen::RowVector3d(0, 0, 0), Eigen::RowVector3d(1, 1, 0)})
            EXPECT_EQ((data.points.rowwise() - corner).rowwise().norm().minCoeff(), 0);
        EXPECT_EQ(quality_report(build_mesh(data)).inverted, 0);
    }
}

TEST(Remesh, ReachesTheNumberOfTrianglesThatTheSizeAsksFor)
{
    const Mesh mesh = build_mesh(test::uneven_square(20));
    constexpr double kSize = 0.02;
    const double equilateral = std::sqrt(3) / 4 * kSize * kSize;
    const auto count = static_cast<double>(remesh(mesh, uniform(mesh, kSize)).data.elements.size());
    EXPECT_NEAR(count * equilateral, 1, 0.15); // edges are within 0.7 and 1.4 of the length
}

TEST(Remesh, RefinedCirclesAreRounderThanTheirPolygon)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 40, 10));
    const MeshData data = remesh(mesh, uniform(mesh, 0.04)).data;
    // Bessel's cubics through nodes 9 degrees apart miss the circle by less than 1e-4 of its radius.
    for (const Marker& marker : data.markers)
        for (const auto& edge : marker.edges)
            EXPECT_NEAR(data.points.row(edge[0]).norm(), marker.name == "inner" ? 1 : 3,
                        1e-4 * (marker.name == "inner" ? 1 : 3));
    EXPECT_NEAR(area(data), 8 * std::numbers::pi, 0.01);
}

/// The unit cube, two triangles a face, outwards.
MeshData cube()
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(8, 3);
    for (Index i = 0; i < 8; ++i)
        data.points.row(i) << i / 4, i / 2 % 2, i % 2;
    for (const Element& q : {Element{0, 1, 3, 2}, Element{4, 6, 7, 5}, Element{0, 4, 5, 1},
                             Element{2, 3, 7, 6}, Element{0, 2, 6, 4}, Element{1, 5, 7, 3}}) {
        data.elements.push_back({q[0], q[1], q[2], -1});
        data.elements.push_back({q[0], q[2], q[3], -1});
    }
    return data;
}

TEST(Remesh, KeepsTheEdgesAreaAndVolumeOfACube)
{
    const Mesh mesh = build_mesh(cube());
    const MeshData data = remesh(mesh, uniform(mesh, 0.1)).data;
    double surface = 0, volume = 0;
    for (const Element& e : data.elements) {
        const Eigen::Vector3d a = data.points.row(e[0]), b = data.points.row(e[1]), c = data.points.row(e[2]);
        surface += (b - a).cross(c - a).norm() / 2;
        volume += a.dot(b.cross(c)) / 6;
    }
    constexpr double kRounding = 1e-12; // of sums over some thousand triangles
    EXPECT_NEAR(surface, 6, kRounding);
    EXPECT_NEAR(std::abs(volume), 1, kRounding);
    EXPECT_GT(data.elements.size(), 1000U);
}

TEST(Remesh, IsTheSameForTheSameInput)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 40, 10));
    const MeshData a = remesh(mesh, uniform(mesh, 0.1)).data, b = remesh(mesh, uniform(mesh, 0.1)).data;
    EXPECT_EQ(a.elements, b.elements);
    EXPECT_EQ(a.points, b.points);
}

TEST(Remesh, NamesTheVertexWhoseSizeIsNotPositive)
{
    const Mesh mesh = build_mesh(test::uneven_square(3));
    Eigen::VectorXd sizes = uniform(mesh, 0.1);
    sizes[5] = -1;
    EXPECT_EQ(test::message_of([&] { remesh(mesh, sizes); }),
              "vertex " + std::to_string(mesh.numbering.vertex[5]) +
                  " has the target size -1, but it has to be positive");
}

} // namespace
} // namespace morph
