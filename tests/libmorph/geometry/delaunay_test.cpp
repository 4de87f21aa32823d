#include "libmorph/geometry/delaunay.h"

#include "formats/formats.h"
#include "libmorph/core/predicates.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace {

using namespace morph;

PlanePoint point(const Mesh& mesh, Index v)
{
    return {points(mesh)(v, 0), points(mesh)(v, 1)};
}

using Edge = std::array<Index, 2>;

/// The triangles next to each edge and the corners opposite to it, found without the neighbour links.
std::map<Edge, std::vector<std::array<Index, 2>>> sides(const Triangulation& triangulation)
{
    std::map<Edge, std::vector<std::array<Index, 2>>> found;
    for (std::size_t t = 0; t < triangulation.corners.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& corners = triangulation.corners[t];
            const Index a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
            found[{std::min(a, b), std::max(a, b)}].push_back({static_cast<Index>(t), corners[k]});
        }
    return found;
}

void expect_neighbours_consistent(const Triangulation& triangulation)
{
    for (const auto& [edge, triangles] : sides(triangulation)) {
        ASSERT_LE(triangles.size(), 2U) << "edge " << edge[0] << " " << edge[1];
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const auto [t, opposite] = triangles[i];
            const auto& corners = triangulation.corners[static_cast<std::size_t>(t)];
            const auto k = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), opposite) -
                                                    corners.begin());
            const Index expected = triangles.size() == 2 ? triangles[1 - i][0] : -1;
            EXPECT_EQ(triangulation.neighbours[static_cast<std::size_t>(t)][k], expected);
        }
    }
}

void expect_delaunay(const Mesh& mesh, const Triangulation& triangulation)
{
    std::size_t violations = 0, inverted = 0;
    for (const auto& [a, b, c] : triangulation.corners)
        inverted += orientation(point(mesh, a), point(mesh, b), point(mesh, c)) <= 0;
    for (const auto& [edge, triangles] : sides(triangulation))
        if (triangles.size() == 2) {
            const auto& [a, b, c] = triangulation.corners[static_cast<std::size_t>(triangles[0][0])];
            violations +=
                in_circle(point(mesh, a), point(mesh, b), point(mesh, c), point(mesh, triangles[1][1])) > 0;
        }
    EXPECT_EQ(inverted, 0U);
    EXPECT_EQ(violations, 0U);
}

double twice_area(const Mesh& mesh, const Triangulation& triangulation)
{
    double sum = 0;
    for (const auto& [a, b, c] : triangulation.corners) {
        const PlanePoint p = point(mesh, a), q = point(mesh, b), r = point(mesh, c);
        sum += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    }
    return sum;
}

TEST(Delaunay, HoldsOnEveryRealMeshAndCoversTheSameArea)
{
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const Mesh mesh = read_mesh(path);
        Triangulation triangulation = triangulate(mesh);
        const double area = twice_area(mesh, triangulation);
        make_delaunay(points(mesh), triangulation);
        expect_delaunay(mesh, triangulation);
        expect_neighbours_consistent(triangulation);
        EXPECT_NEAR(twice_area(mesh, triangulation), area, 1e-12 * area); // thousands of roundings
    }
}

TEST(Delaunay, HoldsOnASquareStretchedAHundredThousandTimes)
{
    MeshData data = test::uneven_square(30);
    data.points.col(1) *= 1e-5;
    const Mesh mesh = build_mesh(data);
    Triangulation triangulation = triangulate(mesh);
    EXPECT_GT(make_delaunay(points(mesh), triangulation), 0U);
    expect_delaunay(mesh, triangulation);
    expect_neighbours_consistent(triangulation);
}

TEST(Triangulate, CutsEveryQuadIntoTwoThatKnowEachOther)
{
    const Mesh mesh = build_mesh(test::quad_square(5));
    const Triangulation triangulation = triangulate(mesh);
    EXPECT_EQ(triangulation.corners.size(), 50U);
    expect_neighbours_consistent(triangulation);
    EXPECT_NEAR(twice_area(mesh, triangulation), 2.0, 1e-14);
}

TEST(Delaunay, LeavesAWallInPlace)
{
    MeshData data;
    data.points.resize(4, 3);
    data.points << -3, 0, 0, 0, -1, 0, 3, 0, 0, 0, 1, 0; // the long diagonal 0 2 is not Delaunay
    data.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}};
    const Mesh mesh = build_mesh(data);
    const auto& file = mesh.numbering.vertex;
    const auto inside = [&](Index v) {
        return static_cast<Index>(std::find(file.begin(), file.end(), v) - file.begin());
    };

    Triangulation walled = triangulate(mesh);
    cut_along(walled, {{inside(2), inside(0)}});
    EXPECT_EQ(make_delaunay(points(mesh), walled), 0U);

    Triangulation open = triangulate(mesh);
    EXPECT_EQ(make_delaunay(points(mesh), open), 1U);
    expect_delaunay(mesh, open);
}

TEST(Delaunay, FlipsAFlatTriangleAway)
{
    MeshData data;
    data.points.resize(4, 3);
    data.points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 1, 0;
    data.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}}; // 0 1 2 lie on a line
    const Mesh mesh = build_mesh(data);
    Triangulation triangulation = triangulate(mesh);
    EXPECT_EQ(make_delaunay(points(mesh), triangulation), 1U);
    expect_delaunay(mesh, triangulation);
}

TEST(Delaunay, EndsOnATangledMeshAndTangledNoFurther)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> shift(-0.1, 0.1); // three cells: hundreds of inverted triangles
    MeshData data = test::uneven_square(30);
    for (Index v = 0; v < data.points.rows(); ++v)
        data.points.row(v) += Eigen::RowVector3d(shift(random), shift(random), 0);
    const Mesh mesh = build_mesh(data);
    Triangulation triangulation = triangulate(mesh);
    const auto inverted = [&] {
        return std::count_if(triangulation.corners.begin(), triangulation.corners.end(), [&](const auto& t) {
            return orientation(point(mesh, t[0]), point(mesh, t[1]), point(mesh, t[2])) <= 0;
        });
    };
    const auto before = inverted();
    ASSERT_GT(before, 100);
    make_delaunay(points(mesh), triangulation);
    EXPECT_LE(inverted(), before);
}

} // namespace
