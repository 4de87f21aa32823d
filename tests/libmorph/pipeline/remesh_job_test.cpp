#include "libmorph/pipeline/remesh_job.h"

#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morph {
namespace {

using test::message_of;
using testing::HasSubstr;

double planar_area(const MeshData& mesh)
{
    double area = 0;
    for (const Element& e : mesh.elements)
        for (int k = 0, n = corner_count(e); k < n; ++k) {
            const auto a = mesh.points.row(e[static_cast<std::size_t>(k)]);
            const auto b = mesh.points.row(e[static_cast<std::size_t>((k + 1) % n)]);
            area += (a[0] * b[1] - a[1] * b[0]) / 2;
        }
    return area;
}

Mesh naca0012()
{
    return read_mesh(test::data_path("meshes/naca0012_inv.su2"));
}

/// A real mesh whose airfoil was turned about the middle of its chord and nothing else with it.
MeshData turned_airfoil(double degrees)
{
    MeshData mesh = to_mesh_data(naca0012());
    const double angle = degrees * std::numbers::pi / 180;
    std::vector<bool> turned(static_cast<std::size_t>(mesh.points.rows()), false);
    for (const auto& edge : find_marker(mesh.markers, "airfoil")->edges)
        for (const Index v : edge) {
            if (turned[static_cast<std::size_t>(v)])
                continue;
            turned[static_cast<std::size_t>(v)] = true;
            const double x = mesh.points(v, 0) - 0.5, y = mesh.points(v, 1);
            mesh.points(v, 0) = 0.5 + std::cos(angle) * x - std::sin(angle) * y;
            mesh.points(v, 1) = std::sin(angle) * x + std::cos(angle) * y;
        }
    return mesh;
}

TEST(RemeshJob, CutsInvertedElementsOutFirst)
{
    for (const double degrees : {5.0, 90.0}) {
        const MeshData before = turned_airfoil(degrees);
        const Mesh old = build_mesh(before);
        const RemeshedMesh result = remesh(old, RemeshJob{});
        ASSERT_TRUE(result.cut_out.has_value());
        EXPECT_GT(result.cut_out->inverted, 100);
        EXPECT_EQ(result.cut_out->inverted, quality_report(old).inverted);
        EXPECT_GT(result.cut_out->elements, result.cut_out->inverted);
        EXPECT_EQ(quality_report(result.mesh).inverted, 0);
        EXPECT_GE(triangle_summary(result.mesh)->min, 0.4);
        const double area = planar_area(before);
        EXPECT_NEAR(planar_area(to_mesh_data(result.mesh)), area, 1e-4 * area);
    }
}

TEST(RemeshJob, SaysWhereABoundaryCrossesItself)
{
    MeshData data = test::uneven_square(4);
    data.points.row(2) << 0.5, 1.2, 0;
    RemeshJob job;
    job.where = "in.su2: ";
    EXPECT_THAT(message_of([&] { remesh(build_mesh(data), job); }),
                testing::StartsWith("in.su2: the boundary of the mesh crosses itself near ("));
}

/// The uneven square cut by the line through its cells' corners at half height, which is not straight.
MeshData two_halves()
{
    MeshData mesh = test::uneven_square(20);
    mesh.groups = {{"low", {}}, {"all", {}}, {"high", {}}};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto number = static_cast<Index>(e);
        (e < mesh.elements.size() / 2 ? mesh.groups[0] : mesh.groups[2]).elements.push_back(number);
        mesh.groups[1].elements.push_back(number);
    }
    return mesh;
}

double group_area(const MeshData& mesh, const ElementGroup& group)
{
    MeshData part;
    part.points = mesh.points;
    for (const Index number : group.elements)
        part.elements.push_back(mesh.elements[static_cast<std::size_t>(number)]);
    return planar_area(part);
}

TEST(RemeshJob, KeepsGroupsAndTheLinesBetweenThem)
{
    const MeshData before = two_halves();
    for (const double scale : {0.6, 1.5}) {
        RemeshJob job;
        job.sizes.scale = scale;
        const MeshData after = to_mesh_data(remesh(build_mesh(before), job).mesh);
        ASSERT_EQ(after.groups.size(), 3U);
        for (std::size_t g = 0; g < 3; ++g) {
            EXPECT_EQ(after.groups[g].name, before.groups[g].name);
            // The border's polygon changes a little where it is not straight: by less than 1 % of a cell's
            // height.
            EXPECT_NEAR(group_area(after, after.groups[g]), group_area(before, before.groups[g]), 5e-4);
        }
        EXPECT_EQ(after.groups[0].elements.size() + after.groups[2].elements.size(), after.elements.size());
        EXPECT_EQ(after.groups[1].elements.size(), after.elements.size());
        ASSERT_EQ(after.markers.size(), before.markers.size());
    }
}

TEST(RemeshJob, MakesAboutAsManyVerticesAsAskedFor)
{
    RemeshJob job;
    job.sizes.vertices = 3000;
    const RemeshedMesh result = remesh(naca0012(), job);
    EXPECT_NEAR(vertex_count(result.mesh), 3000, 60); // 2 %, as it aims
    EXPECT_EQ(result.targets.vertices, 3000);
    EXPECT_EQ(result.targets.sizes.size(), vertex_count(result.mesh));
    EXPECT_EQ(result.targets.possible.size(), vertex_count(result.mesh));
}

TEST(RemeshJob, OnlyBadLeavesAGoodMeshAsItIs)
{
    const Mesh first = remesh(naca0012(), RemeshJob{}).mesh;
    RemeshJob job;
    job.only_bad = 0.5;
    const MeshData second = to_mesh_data(remesh(first, job).mesh);
    EXPECT_EQ(second.points, to_mesh_data(first).points);
    EXPECT_EQ(second.elements, to_mesh_data(first).elements);
}

TEST(RemeshJob, LeavesTheWholeMeshWhenAllOfItIsInAKeptZone)
{
    const MeshData before = test::annulus(1, 3, 40, 10);
    RemeshJob job;
    job.sizes.size = 0.1;
    job.zones = {{"outer", 10}};
    const MeshData after = to_mesh_data(remesh(build_mesh(before), job).mesh);
    EXPECT_EQ(after.points, before.points);
    EXPECT_EQ(after.elements, before.elements);
    job.zones = {{"oter", 10}};
    EXPECT_THAT(message_of([&] { remesh(build_mesh(before), job); }), HasSubstr("did you mean 'outer'"));
}

TEST(RemeshJob, TransfersFieldsAndSectionsThatNameNoVertices)
{
    MeshData data = test::uneven_square(10);
    data.fields = {{"x", FieldLocation::vertex, data.points.col(0)}};
    data.sections = {{"su2", "2 FFD boxes", "FFD_NBOX= 2\n", true}, {"su2", "notes", "% notes\n", false}};
    RemeshJob job;
    job.sizes.scale = 0.7;
    RemeshedMesh result = remesh(build_mesh(data), job);
    ASSERT_EQ(result.mesh.fields.size(), 1U);
    EXPECT_TRUE(result.mesh.fields[0].values.isApprox(points(result.mesh).col(0), 1e-12));
    EXPECT_THAT(result.left_out, testing::ElementsAre("2 FFD boxes"));
    ASSERT_EQ(result.mesh.sections.size(), 1U);
    EXPECT_EQ(result.mesh.sections[0].what, "notes");
    job.transfer_fields = false;
    EXPECT_TRUE(remesh(build_mesh(data), job).mesh.fields.empty());
}

} // namespace
} // namespace morph
