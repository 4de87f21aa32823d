#include "libmorph/remesh/retriangulate.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace morph {
namespace {

// Sums of some hundred products of rounded numbers.
constexpr double kAreaTol = 1e-13;

double area(const MeshData& data)
{
    double sum = 0;
    for (const Element& e : data.elements)
        for (int k = 0, n = corner_count(e); k < n; ++k) {
            const auto a = data.points.row(e[static_cast<std::size_t>(k)]);
            const auto b = data.points.row(e[static_cast<std::size_t>((k + 1) % n)]);
            sum += (a[0] * b[1] - a[1] * b[0]) / 2;
        }
    return sum;
}

std::vector<bool> none_kept(const Mesh& mesh)
{
    return std::vector<bool>(static_cast<std::size_t>(element_count(mesh)), false);
}

std::vector<bool> all_kept(const Mesh& mesh)
{
    return std::vector<bool>(static_cast<std::size_t>(element_count(mesh)), true);
}

Index inverted(const MeshData& data)
{
    return quality_report(build_mesh(data)).inverted;
}

void expect_kept_elements_in_place(const MeshData& before, const Retriangulated& after)
{
    Index kept = 0;
    for (std::size_t e = 0; e < after.made.size(); ++e)
        if (!after.made[e]) {
            ++kept;
            EXPECT_EQ(after.data.elements[e], before.elements[e]) << e;
        }
    EXPECT_EQ(kept + after.cut_out, static_cast<Index>(before.elements.size()));
}

/// The uneven square with a vertex of its inside pulled far over its neighbours.
MeshData tangled_square()
{
    MeshData data = test::uneven_square(12);
    const Index v = 6 * 13 + 6;
    data.points.row(v) += Eigen::RowVector3d(0.13, 0.05, 0);
    return data;
}

TEST(Retriangulate, LeavesAValidMeshAsItIsWhenAllOfItIsKept)
{
    const MeshData before = test::uneven_square(5);
    const Mesh mesh = build_mesh(before);
    const Retriangulated after = retriangulate(mesh, all_kept(mesh));
    EXPECT_EQ(after.data.elements, before.elements);
    EXPECT_EQ(after.data.points, before.points);
    EXPECT_EQ(after.cut_out, 0);
}

TEST(Retriangulate, RepairsATangleAndKeepsTheNumbersOfTheRest)
{
    const MeshData before = tangled_square();
    const Mesh mesh = build_mesh(before);
    ASSERT_GT(quality_report(mesh).inverted, 0);
    const Retriangulated after = retriangulate(mesh, all_but_bad(mesh, 0, 2));
    EXPECT_EQ(inverted(after.data), 0);
    EXPECT_NEAR(area(after.data), 1, kAreaTol);
    EXPECT_LT(after.cut_out, 150); // of 288
    EXPECT_EQ(after.data.elements.size(), before.elements.size());
    EXPECT_EQ(after.data.points, before.points);
    expect_kept_elements_in_place(before, after);
}

TEST(Retriangulate, FillsARingWithItsHoleOpen)
{
    const MeshData before = test::annulus(1, 3, 40, 10);
    const Mesh mesh = build_mesh(before);
    for (const bool inner_vertices : {true, false}) {
        RetriangulateSettings settings;
        settings.inner_vertices = inner_vertices;
        const Retriangulated after = retriangulate(mesh, none_kept(mesh), settings);
        EXPECT_NEAR(area(after.data), area(before), 1e-12); // sums of some hundred numbers up to 9
        EXPECT_EQ(inverted(after.data), 0);
        // 80 nodes on both circles; a triangulated ring has 2 inner + boundary triangles.
        const Eigen::Index count = inner_vertices ? before.points.rows() : 80;
        EXPECT_EQ(after.data.points.rows(), count);
        EXPECT_EQ(after.data.elements.size(), static_cast<std::size_t>(2 * (count - 80) + 80));
        EXPECT_EQ(after.data.markers.size(), 2U);
    }
}

/// The triangle (0 0, 1 0, 0 1) cut off by the corner of an uneven square, its right angle pushed inwards
/// past the opposite side: all its vertices are on the boundary.
MeshData hopeless_corner()
{
    MeshData data = test::uneven_square(6);
    for (Element& e : data.elements) {
        const bool of_corner = std::count(e.begin(), e.end(), 0) > 0;
        if (of_corner)
            e = std::count(e.begin(), e.end(), 1) > 0 ? Element{0, 1, 7, -1} : Element{1, 8, 7, -1};
    }
    data.points.row(0) << 0.13, 0.13, 0;
    return data;
}

TEST(Retriangulate, MendsATriangleAllOfWhoseVerticesAreOnTheBoundary)
{
    const MeshData before = hopeless_corner();
    const Mesh mesh = build_mesh(before);
    ASSERT_EQ(quality_report(mesh).inverted, 1);
    const Retriangulated after = retriangulate(mesh, all_but_bad(mesh, 0, 1));
    EXPECT_EQ(inverted(after.data), 0);
    EXPECT_NEAR(area(after.data), area(before), kAreaTol);
    expect_kept_elements_in_place(before, after);
}

TEST(Retriangulate, GrowsWhereTheOutlineOfWhatIsCutOutCrossesItself)
{
    // The inverted elements alone have an outline that the vertex pulled out is a part of.
    const Mesh mesh = build_mesh(tangled_square());
    const Retriangulated after = retriangulate(mesh, all_kept(mesh));
    EXPECT_GT(after.cut_out, quality_report(mesh).inverted);
    EXPECT_EQ(inverted(after.data), 0);
    EXPECT_NEAR(area(after.data), 1, kAreaTol);
}

TEST(Retriangulate, LeavesOutVerticesOutsideTheOutline)
{
    MeshData before = test::uneven_square(12);
    const Index lost = 6 * 13 + 6;
    before.points.row(lost) << 5, 5, 0;
    const Mesh mesh = build_mesh(before);
    const Retriangulated after = retriangulate(mesh, all_but_bad(mesh, 0.01, 0));
    EXPECT_EQ(after.data.points.rows(), before.points.rows() - 1);
    EXPECT_EQ(std::count(after.vertex.begin(), after.vertex.end(), lost), 0);
    EXPECT_EQ(inverted(after.data), 0);
    EXPECT_NEAR(area(after.data), 1, kAreaTol);
}

TEST(Retriangulate, KeepsEdgesOfMarkersInside)
{
    MeshData before = test::uneven_square(8);
    Marker across{"across", {}};
    for (Index i = 0; i < 8; ++i)
        across.edges.push_back({4 * 9 + i, 4 * 9 + i + 1});
    before.markers.push_back(across);
    const Mesh mesh = build_mesh(before);
    RetriangulateSettings settings;
    settings.inner_vertices = false;
    const Retriangulated after = retriangulate(mesh, none_kept(mesh), settings);
    EXPECT_EQ(after.data.points.rows(), 32 + 7);
    const Mesh built = build_mesh(after.data); // which looks for the marker's edges
    EXPECT_EQ(marker(built, "across").edges.size(), 8U);
    EXPECT_EQ(quality_report(built).inverted, 0);
}

TEST(Retriangulate, CutsInvertedQuadsIntoTriangles)
{
    MeshData before = test::quad_square(6);
    before.points.row(3 * 7 + 3) += Eigen::RowVector3d(0.3, 0.02, 0);
    const Mesh mesh = build_mesh(before);
    ASSERT_GT(quality_report(mesh).inverted, 0);
    const Retriangulated after = retriangulate(mesh, all_kept(mesh));
    EXPECT_EQ(inverted(after.data), 0);
    EXPECT_NEAR(area(after.data), 1, kAreaTol);
    EXPECT_EQ(quality_report(build_mesh(after.data)).quads, 36 - after.cut_out);
    expect_kept_elements_in_place(before, after);
}

TEST(Retriangulate, CarriesGroupsAndFieldsOfTheNearestElement)
{
    MeshData before = test::uneven_square(10);
    before.groups = {{"low", {}}, {"high", {}}};
    Field half{"half", FieldLocation::element, Matrix(before.elements.size(), 1)};
    Field height{"height", FieldLocation::vertex, before.points.col(1)};
    Marker between{"between", {}}; // so that no new triangle is in both halves
    for (Index i = 0; i < 10; ++i)
        between.edges.push_back({5 * 11 + i, 5 * 11 + i + 1});
    before.markers.push_back(between);
    for (Index e = 0; e < static_cast<Index>(before.elements.size()); ++e) {
        const bool low = e < static_cast<Index>(before.elements.size()) / 2;
        before.groups[low ? 0 : 1].elements.push_back(e);
        half.values(e, 0) = low ? 1 : 2;
    }
    before.fields = {half, height};
    const Mesh mesh = build_mesh(before);
    const MeshData after = retriangulate(mesh, none_kept(mesh)).data;
    ASSERT_EQ(after.groups.size(), 2U);
    EXPECT_EQ(after.groups[0].elements.size(), 100U);
    EXPECT_EQ(after.groups[1].elements.size(), 100U);
    for (const Index e : after.groups[1].elements)
        EXPECT_EQ(after.fields[0].values(e, 0), 2);
    EXPECT_EQ(after.fields[1].values.col(0), after.points.col(1));
}

TEST(Retriangulate, SaysWhereTheBoundaryCrossesItself)
{
    MeshData data = test::uneven_square(4);
    data.points.row(2) << 0.5, 1.2, 0; // from the middle of the bottom through the top
    const Mesh mesh = build_mesh(data);
    EXPECT_THAT(test::message_of([&] { retriangulate(mesh, all_kept(mesh)); }),
                ::testing::StartsWith("the boundary of the mesh crosses itself near ("));
}

TEST(Retriangulate, RefusesMarksOfTheWrongNumber)
{
    const Mesh mesh = build_mesh(test::uneven_square(2));
    EXPECT_EQ(test::message_of([&] { retriangulate(mesh, {true}); }),
              "there are 1 marks of elements to keep, but the mesh has 8 elements");
}

} // namespace
} // namespace morph
