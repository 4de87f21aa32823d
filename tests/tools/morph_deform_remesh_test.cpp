// The last resort of a large move: elements that no position of the vertices can repair are remeshed.
#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "tests/support/cases.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace {

using namespace morph;
using test::run_tool;
using ::testing::HasSubstr;

class RemeshGuard : public ::testing::Test {
protected:
    test::ProcessResult deform(const std::string& text, const std::string& guard, const std::string& output)
    {
        return run_tool("morph-deform", {folder_.write("case.toml", text), "-o", folder_.file(output),
                                         "--guard", guard, "--json", folder_.file("report.json")});
    }

    nlohmann::json report() const
    {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    }

    MeshData written(const std::string& name) const { return read_mesh_data(folder_.file(name)); }

    double worst_quality(const std::string& name) const
    {
        const auto all = triangle_qualities(read_mesh(folder_.file(name)));
        return *std::min_element(all.begin(), all.end());
    }

    test::TemporaryFolder folder_;
};

/// The unit square whose top bulges out over its left side, so that the angle in the upper left corner grows
/// beyond 180 degrees: the one triangle there, whose vertices are all on the boundary, turns over.
std::string bulge(const std::string& mesh)
{
    return "[mesh]\nfile = \"" + mesh +
           "\"\n[[boundary]]\nname = \"top\"\ndegree = 2\ncontrol_points = [[1, 1], [0.5, 1], [0, 1]]\n"
           "displacements = [[0, 0], [-0.8, 0.6], [0, 0]]\n[deform]\n";
}

/// The edges of a marker by where their ends are.
std::vector<std::array<double, 4>> places(const MeshData& mesh, const Marker& marker)
{
    std::vector<std::array<double, 4>> found;
    for (const auto& [a, b] : marker.edges)
        found.push_back({mesh.points(a, 0), mesh.points(a, 1), mesh.points(b, 0), mesh.points(b, 1)});
    return found;
}

TEST_F(RemeshGuard, MendsAnElementWhoseVerticesAreAllHeld)
{
    MeshData square = test::uneven_square(10);
    square.groups = {{"low", {}}, {"high", {}}};
    for (Index e = 0; e < 200; ++e)
        square.groups[e < 100 ? 0 : 1].elements.push_back(e);
    square.fields = {{"x", FieldLocation::vertex, square.points.col(0)}};
    write_mesh_data(square, folder_.file("square.vtu"));
    const std::string text = bulge("square.vtu");
    const auto untangled = deform(text, "untangle", "untangled.vtu");
    EXPECT_EQ(untangled.status, 3);
    EXPECT_THAT(untangled.errors, HasSubstr("try guard = \"remesh\""));
    EXPECT_EQ(report()["untangle"]["hopeless"].size(), 1U);

    const auto result = deform(text, "remesh", "remeshed.vtu");
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr("elements were remeshed: numbers of vertices and elements differ"));
    EXPECT_EQ(report()["quality"]["after"]["inverted"], 0);
    const MeshData before = written("untangled.vtu"), after = written("remeshed.vtu");
    EXPECT_EQ(quality_report(build_mesh(after)).inverted, 0);
    EXPECT_EQ(report()["remeshed"]["vertices_before"], before.points.rows());
    EXPECT_EQ(report()["remeshed"]["vertices_after"], after.points.rows());
    EXPECT_LT(report()["remeshed"]["elements"], 120); // of 200
    ASSERT_EQ(after.markers.size(), 4U);
    for (std::size_t m = 0; m < 4; ++m) {
        EXPECT_EQ(after.markers[m].name, before.markers[m].name);
        EXPECT_EQ(places(after, after.markers[m]), places(before, before.markers[m]));
    }
    ASSERT_EQ(after.groups.size(), 2U);
    EXPECT_EQ(after.groups[0].elements.size(), 100U); // far from the top
    EXPECT_EQ(after.groups[0].elements.size() + after.groups[1].elements.size(), after.elements.size());
    ASSERT_EQ(after.fields.size(), 1U);
    EXPECT_EQ(after.fields[0].values.rows(), after.points.rows());
}

TEST_F(RemeshGuard, TurnsARealMeshByNinetyDegreesInOneStep)
{
    CaseFile file = test::fitted_case(test::data_path("meshes/naca0012_inv.su2"), {"airfoil"});
    test::turn(file, 90, {0.5, 0});
    const std::string text = test::case_text(file);
    ASSERT_EQ(deform(text, "check", "tangled.su2").status, 3);
    const auto result = deform(text, "remesh", "remeshed.su2");
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(report()["quality"]["after"]["inverted"], 0);
    EXPECT_LT(report()["boundaries"][0]["landing_error"], 1e-12);
    EXPECT_GE(worst_quality("remeshed.su2"), 0.2);
    const MeshData before = written("tangled.su2"), after = written("remeshed.su2");
    for (std::size_t m = 0; m < before.markers.size(); ++m)
        EXPECT_EQ(places(after, after.markers[m]), places(before, before.markers[m]));
}

TEST_F(RemeshGuard, LeavesAGoodMeshToItself)
{
    write_mesh_data(test::uneven_square(10), folder_.file("square.su2"));
    std::string text = bulge("square.su2");
    text.replace(text.find("-0.8, 0.6"), 9, "0.01, 0.1");
    ASSERT_EQ(deform(text, "check", "checked.su2").status, 0);
    EXPECT_EQ(deform(text, "remesh", "remeshed.su2").status, 0);
    EXPECT_FALSE(report().contains("remeshed"));
    EXPECT_EQ(written("checked.su2").points, written("remeshed.su2").points);
    EXPECT_EQ(written("checked.su2").elements, written("remeshed.su2").elements);
}

TEST_F(RemeshGuard, DoesNotTryWhereTheBoundaryCrossesItself)
{
    write_mesh_data(test::uneven_square(10), folder_.file("square.su2"));
    std::string text = bulge("square.su2");
    text.replace(text.find("-0.8, 0.6"), 9, "0.0, -5.0");
    EXPECT_EQ(deform(text, "remesh", "crossed.su2").status, 3);
    EXPECT_FALSE(report().contains("remeshed"));
    EXPECT_GE(report()["boundary_crossings"].size(), 1U);
}

} // namespace
