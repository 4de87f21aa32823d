#include "formats/case/case_file.h"
#include "formats/formats.h"
#include "libmorph/basis/closest.h"
#include "libmorph/mesh/chain.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace {

using namespace morph;
using test::ProcessResult;
using test::run_tool;
using test::TemporaryFolder;
using testing::HasSubstr;

std::string mesh_path(const std::string& name)
{
    return test::data_path("meshes/" + name + ".su2");
}

/// A body of a real mesh, and how near 12 and 20 control points must come; the bodies have a size of 1.
struct Body {
    std::string mesh;
    std::vector<std::string> markers;
    std::size_t corners;
    double with_12;
    double with_20;
};

std::vector<Body> bodies()
{
    return {
        {"naca0012_inv", {"airfoil"}, 1, 1e-3, 1e-4},
        {"naca0012_lam_hybrid", {"airfoil"}, 1, 1e-3, 1e-4},
        {"rae2822_turb", {"AIRFOIL"}, 1, 1.5e-3, 3e-4},
        {"cylinder_lam", {"cylinder"}, 0, 3e-4, 3e-4}, // its nodes lie 2e-4 off a circle
        {"naca0012_multiffd", {"airfoil_lower", "airfoil_upper"}, 0, 1e-4, 1e-5},
    };
}

std::vector<std::string> arguments(const Body& body, int points, const std::string& output)
{
    std::vector<std::string> list{mesh_path(body.mesh), "--points", std::to_string(points), "-o", output};
    for (const std::string& marker : body.markers)
        list.insert(list.end(), {"--marker", marker});
    return list;
}

ProcessResult fit(const std::vector<std::string>& arguments)
{
    return run_tool("morph-fit", arguments);
}

TEST(MorphFit, FitsTheBodiesOfRealMeshes)
{
    const TemporaryFolder folder;
    for (const Body& body : bodies())
        for (const int points : {12, 20}) {
            const std::string json = folder.file("report.json");
            std::vector<std::string> list = arguments(body, points, folder.file("case.toml"));
            list.insert(list.end(), {"--json", json});
            const ProcessResult result = fit(list);
            ASSERT_EQ(result.status, 0) << result.errors;
            EXPECT_EQ(result.errors, "");
            EXPECT_THAT(result.output, HasSubstr("largest"));
            const auto report = nlohmann::json::parse(test::read_text(json));
            EXPECT_LE(report["max_distance"], points == 12 ? body.with_12 : body.with_20) << body.mesh;
            EXPECT_LE(report["mean_distance"], report["max_distance"]);
            ASSERT_EQ(report["boundaries"].size(), body.markers.size());
            for (const auto& boundary : report["boundaries"])
                EXPECT_EQ(boundary["corners"], body.corners) << body.mesh;
        }
}

TEST(MorphFit, WritesACaseFileWhoseCurvesAreAsNearAsItSays)
{
    const TemporaryFolder folder;
    for (const Body& body : bodies()) {
        const std::string path = folder.file("case.toml");
        std::vector<std::string> list = arguments(body, 12, path);
        list.insert(list.end(), {"--json", "-"});
        const ProcessResult result = fit(list);
        ASSERT_EQ(result.status, 0) << result.errors;
        const auto report = nlohmann::json::parse(result.output);
        const CaseFile file = read_case_file(path);
        EXPECT_TRUE(std::filesystem::equivalent(file.mesh_file, mesh_path(body.mesh)));
        EXPECT_EQ(file.motion.deform.diffusivity, Diffusivity::inverse_distance);
        ASSERT_EQ(file.motion.curves.size(), body.markers.size());
        const Mesh mesh = read_mesh(file.mesh_file);
        double largest = 0;
        for (const CurveMove& entry : file.motion.curves) {
            EXPECT_EQ(entry.displacements, Points2::Zero(12, 2));
            const Chain chain = marker_chain(marker(mesh, entry.marker), mesh.numbering);
            EXPECT_EQ(entry.curve.closed, chain.closed);
            const Points2 nodes = points(mesh)(chain.vertices, {0, 1});
            for (const CurveParameter& place : node_parameters(Curve(entry.curve), nodes, chain.closed))
                largest = std::max(largest, place.distance);
        }
        EXPECT_EQ(largest, report["max_distance"]) << "numbers in the file read back as the same bits";
    }
}

TEST(MorphFit, WritesDegreeAndClosedOnLinesOfTheirOwn)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("case.toml");
    ASSERT_EQ(fit({mesh_path("cylinder_lam"), "--marker", "cylinder", "--degree", "2", "-o", path}).status,
              0);
    const std::string text = test::read_text(path);
    EXPECT_THAT(text, HasSubstr("\ndegree = 2\n"));
    EXPECT_THAT(text, HasSubstr("\nclosed = true\n"));
    EXPECT_THAT(text, HasSubstr("\ndiffusivity = \"inverse-distance\"\n"));
}

TEST(MorphFit, TakesTheCornerAngle)
{
    const TemporaryFolder folder;
    const auto corners = [&](const std::string& angle) {
        const ProcessResult result = fit({mesh_path("wedge"), "--marker", "lower", "--corner-angle", angle,
                                          "--json", "-", "-o", folder.file("case.toml")});
        return nlohmann::json::parse(result.output)["boundaries"][0]["corners"].get<int>();
    };
    EXPECT_EQ(corners("5"), 1) << "the ramp of 10 degrees";
    EXPECT_EQ(corners("15"), 0);
}

TEST(MorphFit, NamesTheMarkerThatWasMeant)
{
    const TemporaryFolder folder;
    const ProcessResult result =
        fit({mesh_path("naca0012_inv"), "--marker", "airfiol", "-o", folder.file("case.toml")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("did you mean 'airfoil'?"));
    EXPECT_TRUE(folder.names().empty()) << "no output on failure";
}

TEST(MorphFit, RefusesWhatItCannotFit)
{
    const TemporaryFolder folder;
    const std::string out = folder.file("case.toml");
    const std::string naca = mesh_path("naca0012_inv");
    const auto error = [&](std::vector<std::string> list, int status) {
        list.insert(list.end(), {"-o", out});
        const ProcessResult result = fit(list);
        EXPECT_EQ(result.status, status) << result.errors;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        return result.errors;
    };
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--degree", "0"}, 1),
                HasSubstr("degree 0 is not supported"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--degree", "8"}, 1), HasSubstr("expected 1 to 7"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--points", "2"}, 1), HasSubstr("needs at least 4"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--points", "201"}, 1), HasSubstr("has 200 nodes"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--points", "-5"}, 1), HasSubstr("too few"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--points", "many"}, 2), HasSubstr("--points"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--corner-angle", "nan"}, 1), HasSubstr("corner angle"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--marker", "airfoil"}, 2), HasSubstr("given twice"));
    EXPECT_THAT(error({naca}, 2), HasSubstr("--marker"));
    EXPECT_THAT(error({naca, "--marker", "airfoil", "--point", "9"}, 2),
                HasSubstr("did you mean '--points'?"));
    EXPECT_THAT(error({folder.file("none.su2"), "--marker", "airfoil"}, 1), HasSubstr("none.su2"));
    EXPECT_TRUE(folder.names().empty());
    EXPECT_THAT(fit({naca, "--marker", "airfoil", "-o", folder.path()}).errors, HasSubstr(folder.path()));
}

TEST(MorphFit, RefusesASurfaceAndAMarkerThatIsNoChain)
{
    const TemporaryFolder folder;
    MeshData data = test::uneven_square(4);
    data.markers[0].edges.push_back({2, 7});
    write_mesh_data(data, folder.file("branch.su2"));
    const ProcessResult branch =
        fit({folder.file("branch.su2"), "--marker", "bottom", "-o", folder.file("case.toml")});
    EXPECT_EQ(branch.status, 1);
    EXPECT_THAT(branch.errors, HasSubstr("branches at vertex 2"));

    data = test::uneven_square(4);
    data.dimension = 3;
    data.points.col(2).setConstant(0.5);
    write_mesh_data(data, folder.file("surface.vtu"));
    const ProcessResult surface =
        fit({folder.file("surface.vtu"), "--marker", "bottom", "-o", folder.file("case.toml")});
    EXPECT_EQ(surface.status, 1);
    EXPECT_THAT(surface.errors, HasSubstr("surface mesh"));
}

} // namespace
