#include "libmorph/mesh/merge_vertices.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace {

using namespace morph;
using testing::ElementsAre;

/// Points on the x axis.
MeshData points_at(const std::vector<double>& x)
{
    MeshData mesh;
    mesh.points = Points::Zero(static_cast<Index>(x.size()), 3);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        mesh.points(v, 0) = x[static_cast<std::size_t>(v)];
    return mesh;
}

std::vector<double> xs(const MeshData& mesh)
{
    std::vector<double> x;
    for (Index v = 0; v < mesh.points.rows(); ++v)
        x.push_back(mesh.points(v, 0));
    return x;
}

TEST(MergeVertices, VerticesGoToTheFirstKeptOneWithinTheToleranceAndDoNotDriftAlongChains)
{
    MeshData mesh = points_at({0, 0.9, 1.8, 2.7, 1.0});
    const Merged merged = merge_vertices(mesh, 1.0);
    EXPECT_THAT(xs(mesh), ElementsAre(0, 1.8));
    EXPECT_EQ(merged.vertices, 3);
}

TEST(MergeVertices, TwoSquaresThatTouchBecomeOneMeshWithoutAnInnerBoundary)
{
    MeshData left = test::quad_square(4);
    MeshData both = left;
    const auto n = static_cast<Index>(left.points.rows());
    both.points.conservativeResize(2 * n, 3);
    for (Index v = 0; v < n; ++v) {
        both.points.row(n + v) = left.points.row(v);
        both.points(n + v, 0) = 2 - left.points(v, 0) + 1e-9; // mirrored, so that turned the other way round
    }
    for (const Element& e : left.elements)
        both.elements.push_back({n + e[3], n + e[2], n + e[1], n + e[0]});
    const Merged merged = merge_vertices(both, 1e-6);
    EXPECT_EQ(merged.vertices, 5);
    EXPECT_EQ(merged.elements, 0);
    const Mesh mesh = build_mesh(both);
    EXPECT_EQ(vertex_count(mesh), 2 * n - 5);
    // Euler: one piece without holes.
    EXPECT_EQ(vertex_count(mesh) - static_cast<Index>(mesh.kernel.n_edges()) + element_count(mesh), 1);
}

TEST(MergeVertices, WhatCollapsesGoesWithItsRowsAndIsCounted)
{
    MeshData mesh = points_at({0, 1, 1, 0, 0});
    mesh.points(2, 1) = mesh.points(3, 1) = 1;
    mesh.points(4, 1) = 1e-9; // next to vertex 0
    mesh.elements = {{0, 1, 2, 3}, {0, 3, 4, -1}, {0, 1, 3, 4}};
    mesh.markers = {{"wall", {{0, 4}, {0, 1}}}};
    mesh.groups = {{"all", {0, 1, 2}}};
    Field cell{"cell", FieldLocation::element, Matrix(3, 1)};
    cell.values << 5, 6, 7;
    Field node{"node", FieldLocation::vertex, Matrix(5, 1)};
    node.values << 0, 1, 2, 3, 4;
    mesh.fields = {cell, node};
    const Merged merged = merge_vertices(mesh, 1e-6);
    EXPECT_EQ(merged.vertices, 1);
    EXPECT_EQ(merged.elements, 1);
    EXPECT_EQ(merged.edges, 1);
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, 3}, Element{0, 1, 3, -1}));
    EXPECT_EQ(mesh.fields[0].values, (Matrix(2, 1) << 5, 7).finished());
    EXPECT_EQ(mesh.fields[1].values, (Matrix(4, 1) << 0, 1, 2, 3).finished());
    EXPECT_THAT(mesh.groups[0].elements, ElementsAre(0, 1));
    EXPECT_EQ(mesh.markers[0].edges, (std::vector<std::array<Index, 2>>{{0, 1}}));
}

TEST(MergeVertices, AgreesWithComparingEveryPair)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 1);
    constexpr Index kPoints = 800;
    constexpr double kTolerance = 0.05;
    MeshData mesh;
    mesh.points.resize(kPoints, 3);
    for (Index v = 0; v < kPoints; ++v)
        mesh.points.row(v) << place(random), place(random), place(random);
    std::vector<Index> kept;
    for (Index v = 0; v < kPoints; ++v)
        if (std::none_of(kept.begin(), kept.end(), [&](Index w) {
                return (mesh.points.row(v) - mesh.points.row(w)).norm() <= kTolerance;
            }))
            kept.push_back(v);
    const Points expected = mesh.points(kept, Eigen::all);
    merge_vertices(mesh, kTolerance);
    ASSERT_LT(kept.size(), static_cast<std::size_t>(kPoints));
    EXPECT_EQ(mesh.points, expected);
}

} // namespace
