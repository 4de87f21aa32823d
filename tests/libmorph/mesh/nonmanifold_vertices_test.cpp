#include "libmorph/mesh/nonmanifold_vertices.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace morph {

namespace {

/// Triangles around the origin (vertex 0) that have only that in common.
MeshData propeller(Index blades)
{
    MeshData data;
    data.points.setZero(2 * blades + 1, 3);
    data.markers = {{"tips", {}}, {"leading", {}}};
    for (Index b = 0; b < blades; ++b) {
        for (const Index end : {0, 1}) {
            const double angle = std::numbers::pi * (2 * b + end) / blades;
            data.points.row(2 * b + end + 1) << std::cos(angle), std::sin(angle), 0;
        }
        data.elements.push_back({0, 2 * b + 1, 2 * b + 2, -1});
        data.markers[0].edges.push_back({2 * b + 1, 2 * b + 2});
        data.markers[1].edges.push_back({0, 2 * b + 1});
    }
    Matrix values(data.points.rows(), 9);
    for (Index i = 0; i < values.size(); ++i)
        values.data()[i] = i;
    data.fields = {{"nine", FieldLocation::vertex, values}};
    return data;
}

/// The surfaces of two cubes of quads that touch in vertex 7 only.
MeshData touching_cubes()
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(15, 3);
    for (Index i = 0; i < 8; ++i)
        data.points.row(i) << (i & 1), (i >> 1 & 1), (i >> 2 & 1);
    for (Index i = 1; i < 8; ++i)
        data.points.row(7 + i) = data.points.row(i) + data.points.row(7);
    const std::vector<Element> faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const Element& f : faces) {
        data.elements.push_back(f);
        data.elements.push_back({f[0] + 7, f[1] + 7, f[2] + 7, f[3] + 7});
    }
    data.markers = {{"through", {{3, 7}, {7, 8}}}};
    return data;
}

/// Number of pieces that hang together by faces and vertices of the kernel.
std::size_t parts(const Mesh& mesh)
{
    std::set<Index> left;
    for (const VertexHandle v : mesh.kernel.vertices())
        left.insert(v.idx());
    std::size_t count = 0;
    while (!left.empty()) {
        ++count;
        std::vector<Index> open{*left.begin()};
        left.erase(left.begin());
        while (!open.empty()) {
            const VertexHandle v(open.back());
            open.pop_back();
            for (const VertexHandle w : mesh.kernel.vv_range(v))
                if (left.erase(w.idx()) != 0)
                    open.push_back(w.idx());
        }
    }
    return count;
}

void expect_markers_on_edges(const Mesh& mesh)
{
    for (const Marker& marker : mesh.markers)
        for (const auto& [from, to] : marker.edges)
            EXPECT_TRUE(mesh.kernel.find_halfedge(VertexHandle(from), VertexHandle(to)).is_valid());
}

TEST(SplitFans, GivesEachOfSeveralOpenFansAVertex)
{
    for (const Index blades : {2, 3, 7})
        for (const unsigned seed : {1U, 2U, 3U}) {
            const MeshData data = test::shuffled(propeller(blades), seed);
            const Mesh mesh = build_mesh(data);
            test::expect_sound(mesh);
            EXPECT_EQ(vertex_count(mesh), 3 * blades);
            EXPECT_EQ(parts(mesh), static_cast<std::size_t>(blades));
            expect_markers_on_edges(mesh);
            EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "");
        }
}

TEST(SplitFans, PutsCopiesAfterTheOthersAtTheSamePlace)
{
    const MeshData data = propeller(4);
    const Mesh mesh = build_mesh(data);
    EXPECT_EQ(mesh.numbering.file_vertices, 9);
    for (Index copy = 9; copy < 12; ++copy) {
        EXPECT_EQ(mesh.numbering.vertex[static_cast<std::size_t>(copy)], 0);
        EXPECT_EQ(points(mesh).row(copy), data.points.row(0));
        EXPECT_EQ(mesh.fields[0].values.row(copy), data.fields[0].values.row(0));
    }
}

TEST(SplitFans, SplitsClosedFansThatTouch)
{
    for (const unsigned seed : {1U, 2U, 3U}) {
        const MeshData data = test::shuffled(touching_cubes(), seed);
        const Mesh mesh = build_mesh(data);
        test::expect_sound(mesh);
        EXPECT_EQ(vertex_count(mesh), 16);
        EXPECT_EQ(parts(mesh), 2U);
        expect_markers_on_edges(mesh);
        EXPECT_NE(mesh.markers[0].edges[0][1], mesh.markers[0].edges[1][0]); // each cube has its own corner
        EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "");
    }
}

TEST(SplitFans, SplitsAnOpenFanFromAClosedOne)
{
    MeshData data = touching_cubes();
    const auto n = static_cast<Index>(data.points.rows());
    data.points.conservativeResize(n + 2, 3);
    data.points.row(n) << 1, 1, 3;
    data.points.row(n + 1) << 1, 2, 3;
    data.elements.push_back({7, n, n + 1, -1});
    const Mesh mesh = build_mesh(data);
    test::expect_sound(mesh);
    EXPECT_EQ(vertex_count(mesh), n + 4);
    EXPECT_EQ(parts(mesh), 3U);
    EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "");
}

TEST(SplitFans, ResolvesMarkerEdgesBetweenTwoSplitVertices)
{
    // Quads of a checkerboard touch in corners only, so that every inner vertex splits in two.
    for (const unsigned seed : {1U, 2U, 3U}) {
        MeshData data = test::quad_square(6);
        std::vector<Element> black;
        for (Index j = 0; j < 6; ++j)
            for (Index i = j % 2; i < 6; i += 2)
                black.push_back(data.elements[static_cast<std::size_t>(6 * j + i)]);
        data.elements = black;
        data.markers = {{"edges", {}}};
        for (const Element& e : black)
            for (std::size_t k = 0; k < 4; ++k)
                data.markers[0].edges.push_back({e[(k + 1) % 4], e[k]});
        data = test::shuffled(data, seed);
        test::turn_some(data, 0.4, seed);

        const Mesh mesh = build_mesh(data);
        test::expect_sound(mesh);
        EXPECT_EQ(vertex_count(mesh), data.points.rows() + 25);
        expect_markers_on_edges(mesh);
        EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "");
    }
}

TEST(SplitFans, GivesTheSameVerticesForAnyNumberOfThreads)
{
    const MeshData data = test::shuffled(propeller(20'000), 4);
    set_thread_count(1);
    const Mesh one = build_mesh(data);
    set_thread_count(3);
    const Mesh many = build_mesh(data);
    set_thread_count(0);
    EXPECT_EQ(vertex_count(one), 60'000);
    EXPECT_EQ(element_table(many), element_table(one));
    EXPECT_EQ(many.markers[1].edges, one.markers[1].edges);
}

} // namespace

} // namespace morph
