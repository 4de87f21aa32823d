#include "formats/csv/table.h"
#include "formats/formats.h"
#include "libmorph/quality/quality.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace morph {
namespace {

using test::ProcessResult;
using test::run_tool;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kCase1 = test::example_path("01_thesis_case1/case.toml");
const std::string kCase2 = test::example_path("02_thesis_case2/case.toml");

// The thesis prints its table with rounded coordinates: shared with the test of the curve itself.
constexpr double kTableTolerance = 2e-5;

/// A case around a square of side 2, in which parts can be replaced.
std::string square_case(const std::string& generate, const std::string& boundary = "nodes = 40")
{
    return "[mesh]\n" + generate + "\n[[boundary]]\nname = \"square\"\ndegree = 1\nclosed = true\n" +
           boundary + "\ncontrol_points = [[-1, -1], [1, -1], [1, 1], [-1, 1]]\n";
}

const std::string kGenerate = "generate = { box = [-5, -5, 5, 5], size = 1.0 }";

TEST(MorphMesh, MeshesTheFirstCaseOfTheThesis)
{
    const test::TemporaryFolder folder;
    const ProcessResult result = run_tool("morph-mesh", {kCase1, "-o", folder.file("mesh.su2")});

    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(result.errors, IsEmpty());
    EXPECT_THAT(result.output, HasSubstr("marker body: 100 edges"));
    const Mesh mesh = read_mesh(folder.file("mesh.su2"));
    const QualityReport quality = quality_report(mesh);
    EXPECT_EQ(quality.inverted, 0);
    EXPECT_GE(quality.min_angle, 25);
    EXPECT_GT(quality.vertices, 1000);
    EXPECT_LT(quality.vertices, 10000);
}

TEST(MorphMesh, PutsTheNodesOfTheFirstCaseWhereTheThesisPrintsThem)
{
    const test::TemporaryFolder folder;
    ASSERT_EQ(run_tool("morph-mesh", {kCase1, "-o", folder.file("mesh.su2")}).status, 0);

    const MeshData mesh = read_mesh_data(folder.file("mesh.su2"));
    const Points2 printed =
        csv_columns(read_csv_table(test::data_path("thesis/table_5_1_2.csv")), {"x", "y"});
    ASSERT_EQ(printed.rows(), 100);
    // The table starts with u = 0, and so do the vertices.
    EXPECT_LE((mesh.points.topLeftCorner(100, 2) - printed).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
              kTableTolerance);
}

TEST(MorphMesh, ReportsAsJsonWhatTheFileHolds)
{
    const test::TemporaryFolder folder;
    const ProcessResult result =
        run_tool("morph-mesh", {kCase2, "-o", folder.file("mesh.su2"), "--json", "-"});

    ASSERT_EQ(result.status, 0) << result.errors;
    const auto json = nlohmann::ordered_json::parse(result.output);
    const MeshData mesh = read_mesh_data(folder.file("mesh.su2"));
    EXPECT_EQ(json["vertices"], mesh.points.rows());
    EXPECT_EQ(json["triangles"], mesh.elements.size());
    EXPECT_GE(json["min_angle"], 25);
    ASSERT_EQ(json["markers"].size(), 3U);
    for (const Marker& marker : mesh.markers)
        EXPECT_EQ(json["markers"][marker.name], marker.edges.size()) << marker.name;
    EXPECT_EQ(json["markers"]["body1"], 100);
    EXPECT_EQ(json["markers"]["body2"], 100);
    for (const char* stage : {"read", "mesh", "write"})
        EXPECT_GE(json["seconds"][stage], 0) << stage;
}

TEST(MorphMesh, WritesTheSameBytesInEveryRunAndForEveryThreadCount)
{
    const test::TemporaryFolder folder;
    ASSERT_EQ(run_tool("morph-mesh", {kCase2, "-o", folder.file("a.su2"), "--threads", "1"}).status, 0);
    ASSERT_EQ(run_tool("morph-mesh", {kCase2, "-o", folder.file("b.su2"), "--threads", "2"}).status, 0);
    EXPECT_EQ(test::read_text(folder.file("a.su2")), test::read_text(folder.file("b.su2")));
}

TEST(MorphMesh, WritesTheFormatAskedFor)
{
    const test::TemporaryFolder folder;
    ASSERT_EQ(
        run_tool("morph-mesh", {kCase1, "-o", folder.file("mesh.dat"), "--to", "su2", "--quiet"}).status, 0);
    EXPECT_EQ(read_mesh_data(folder.file("mesh.dat"), "su2").markers.size(), 2U);
}

struct Refusal {
    std::string name;
    std::string text;
    std::string message;
};

class RefusedCase : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedCase, GivesOneLineAndNoFile)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.write("case.toml", GetParam().text);
    const ProcessResult result = run_tool("morph-mesh", {path, "-o", folder.file("mesh.su2")});

    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("morph-mesh: " + path));
    EXPECT_THAT(result.errors, HasSubstr(GetParam().message));
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_THAT(folder.names(), ElementsAre("case.toml"));
}

INSTANTIATE_TEST_SUITE_P(
    MorphMesh, RefusedCase,
    testing::Values(
        Refusal{"without_generate", square_case("file = \"mesh.su2\""), "nothing to generate"},
        Refusal{"without_nodes", square_case(kGenerate, ""), "case.toml:3: boundary 'square' needs nodes"},
        Refusal{"two_nodes", square_case(kGenerate, "nodes = 2"),
                "nodes = 2; a closed curve needs at least 3"},
        Refusal{"tiny_size", square_case("generate = { box = [-5, -5, 5, 5], size = 1e-6 }"), "size 1e-06"},
        Refusal{"outside", square_case("generate = { box = [5, 5, 9, 9], size = 1.0 }"),
                "lies outside the box"},
        Refusal{"across_the_box", square_case("generate = { box = [0, -5, 9, 5], size = 1.0 }"),
                "crosses or touches the box"}),
    [](const auto& refusal) { return refusal.param.name; });

TEST(MorphMesh, NeedsAnOutput)
{
    const ProcessResult result = run_tool("morph-mesh", {kCase1});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.errors, HasSubstr("output"));
}

TEST(MorphMesh, RefusesAnUnknownFormatBeforeMeshing)
{
    const test::TemporaryFolder folder;
    const ProcessResult result = run_tool("morph-mesh", {kCase1, "-o", folder.file("mesh.xyz")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("xyz"));
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(MorphMesh, ShowsAnExampleInItsHelp)
{
    const ProcessResult result = run_tool("morph-mesh", {"--help"});
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.output, HasSubstr("morph-mesh examples/02_thesis_case2/case.toml -o domain.su2"));
}

} // namespace
} // namespace morph
