// What keeps the mesh valid under large moves: rotations, steps, sliding markers, rigid layers, untangling.
#include "formats/formats.h"
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
using test::TemporaryFolder;
using ::testing::HasSubstr;

struct Airfoil {
    const char* file;
    const char* marker;
};

class LargeTurn : public ::testing::TestWithParam<Airfoil> {
protected:
    /// The case of a turn about the middle of the chord, by harmonic weights.
    std::string turned(double degrees, const std::string& diffusivity) const
    {
        CaseFile file = test::fitted_case(mesh_, {GetParam().marker});
        test::turn(file, degrees, {0.5, 0});
        file.motion.deform.diffusivity = from_string<Diffusivity>(diffusivity);
        return test::case_text(file);
    }

    test::ProcessResult deform(const std::string& text, const std::string& guard)
    {
        return run_tool("morph-deform", {folder_.write("case.toml", text), "-o", folder_.file(guard + ".su2"),
                                         "--guard", guard, "--json", folder_.file("report.json")});
    }

    nlohmann::json report() const
    {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    }

    TemporaryFolder folder_;
    std::string mesh_ = test::data_path(std::string("meshes/") + GetParam().file);
};

TEST_P(LargeTurn, ByNinetyDegreesInvertsNothingWithRotations)
{
    const std::string text = turned(90, "inverse-distance");
    EXPECT_EQ(deform(text, "check").status, 3);
    EXPECT_GT(report()["quality"]["after"]["inverted"], 100);
    const auto result = deform(text + "rotations = true\n", "check");
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(report()["quality"]["after"]["inverted"], 0);
    EXPECT_LT(report()["boundaries"][0]["landing_error"], 1e-12);
    EXPECT_FALSE(report().contains("safe_step")); // the move is not linear
}

TEST_P(LargeTurn, IsUntangledWithEveryBoundaryNodeWhereTheMovePutIt)
{
    const std::string text = turned(45, "uniform");
    EXPECT_EQ(deform(text, "check").status, 3);
    const int tangled = report()["quality"]["after"]["inverted"];
    EXPECT_GT(tangled, 50);
    const auto result = deform(text, "untangle");
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(report()["untangle"]["tangled"], tangled);
    EXPECT_EQ(report()["untangle"]["inverted"], 0);
    EXPECT_EQ(report()["quality"]["after"]["inverted"], 0);
    EXPECT_LT(report()["boundaries"][0]["landing_error"], 1e-12);
    const MeshData before = read_mesh_data(folder_.file("check.su2"));
    const MeshData after = read_mesh_data(folder_.file("untangle.su2"));
    for (const Marker& marker : after.markers)
        for (const auto& edge : marker.edges)
            ASSERT_EQ(after.points.row(edge[0]), before.points.row(edge[0])) << marker.name;
    // The written mesh, by a tool of its own.
    const auto quality = run_tool("morph-quality", {folder_.file("untangle.su2"), "--json", "-"});
    EXPECT_EQ(nlohmann::json::parse(quality.output)["inverted"], 0);
}

INSTANTIATE_TEST_SUITE_P(Airfoils, LargeTurn,
                         ::testing::Values(Airfoil{"naca0012_inv.su2", "airfoil"},
                                           Airfoil{"naca0012_lam_hybrid.su2", "airfoil"},
                                           Airfoil{"rae2822_turb.su2", "AIRFOIL"}));

TEST(Guard, DoesNotTryToRepairAMeshWhoseBoundaryCrossesItself)
{
    // No curve: the lattice pulls the upper side of the airfoil through the lower one.
    const TemporaryFolder folder;
    const std::string text =
        "[mesh]\nfile = \"" + test::example_path("naca0012_inv.su2") +
        "\"\n[lattice]\npoints = [3, 3]\ndegree = [1, 1]\nbox = [-0.5, -0.5, 1.5, 0.5]\n"
        "displacements = [[1, 2, 0, -1.5]]\n[deform]\nmethod = \"ffd\"\nguard = \"untangle\"\n";
    const auto result = run_tool("morph-deform", {folder.write("case.toml", text), "-o", folder.file("m.su2"),
                                                  "--json", folder.file("r.json")});
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(result.errors, HasSubstr("the moved boundary 'airfoil' crosses itself near ("));
    EXPECT_THAT(result.errors, HasSubstr("no valid mesh exists"));
    const auto report = nlohmann::json::parse(test::read_text(folder.file("r.json")));
    EXPECT_EQ(report["boundary_crossings"].size(), 1U);
    EXPECT_FALSE(report.contains("untangle"));
}

TEST(Guard, SaysThatABodyIsInsideOut)
{
    // No curve: the lattice turns its box upside down, a symmetric airfoil with it.
    const TemporaryFolder folder;
    const std::string text = "[mesh]\nfile = \"" + test::example_path("naca0012_inv.su2") +
                             "\"\n[lattice]\npoints = [2, 2]\ndegree = [1, 1]\nbox = [-0.5, -0.5, 1.5, 0.5]\n"
                             "displacements = [[0, 0, 0, 1], [1, 0, 0, 1], [0, 1, 0, -1], [1, 1, 0, -1]]\n"
                             "[deform]\nmethod = \"ffd\"\nguard = \"untangle\"\n";
    const auto result = run_tool("morph-deform", {folder.write("case.toml", text), "-o", folder.file("m.su2"),
                                                  "--json", folder.file("r.json")});
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(result.errors,
                HasSubstr("the moved boundary 'airfoil' is turned inside out: no valid mesh exists"));
    const auto report = nlohmann::json::parse(test::read_text(folder.file("r.json")));
    EXPECT_EQ(report["boundary_crossings"].size(), 1U);
    EXPECT_FALSE(report.contains("untangle"));
}

/// The unit square whose top is a curve that moves.
class MovedSide : public ::testing::Test {
protected:
    MovedSide() { write_mesh_data(square_, folder_.file("square.su2")); }

    std::string case_of(const std::string& moved, const std::string& deform) const
    {
        return "[mesh]\nfile = \"square.su2\"\n[[boundary]]\nname = \"top\"\ndegree = 1\n"
               "control_points = [[1, 1], [0, 1]]\nmoved = " +
               moved + "\n[deform]\n" + deform;
    }

    test::ProcessResult deform(const std::string& text)
    {
        return run_tool("morph-deform", {folder_.write("case.toml", text), "-o", folder_.file("moved.su2"),
                                         "--json", folder_.file("report.json")});
    }

    std::string refusal(const std::string& deform_keys)
    {
        const auto result = deform(case_of("[[1, 1.2], [0, 1.2]]", deform_keys));
        EXPECT_EQ(result.status, 1);
        return result.errors;
    }

    TemporaryFolder folder_;
    MeshData square_ = test::uneven_square(10);
};

TEST_F(MovedSide, StretchesAMeshWhoseSidesSlide)
{
    const std::string up = "[[1, 1.5], [0, 1.5]]";
    EXPECT_THAT(deform(case_of(up, "")).errors, HasSubstr("holds it fixed"));
    const auto result = deform(case_of(up, "slide = [\"left\", \"right\"]\n"));
    EXPECT_EQ(result.status, 0) << result.errors;
    const Points after = read_mesh_data(folder_.file("moved.su2")).points;
    for (Index v = 0; v < after.rows(); ++v) {
        EXPECT_NEAR(after(v, 1), 1.5 * square_.points(v, 1), 1e-12);
        EXPECT_NEAR(after(v, 0), square_.points(v, 0), 1e-12);
    }
}

TEST_F(MovedSide, SlidesNodesAlongTheirLineAlone)
{
    const std::string bulge = "[mesh]\nfile = \"square.su2\"\n[[boundary]]\nname = \"top\"\ndegree = 2\n"
                              "control_points = [[1, 1], [0.5, 1], [0, 1]]\n"
                              "displacements = [[0, 0], [0.3, 0.4], [0, 0]]\n[deform]\n";
    ASSERT_EQ(deform(bulge).status, 0);
    const Points held = read_mesh_data(folder_.file("moved.su2")).points;
    const auto result = deform(bulge + "slide = [\"right\"]\n");
    ASSERT_EQ(result.status, 0) << result.errors;
    const Points slid = read_mesh_data(folder_.file("moved.su2")).points;
    double farthest = 0;
    for (const auto& edge : find_marker(square_.markers, "right")->edges) {
        EXPECT_NEAR(slid(edge[0], 0), 1, 1e-15);
        farthest = std::max(farthest, std::abs(slid(edge[0], 1) - held(edge[0], 1)));
    }
    EXPECT_GT(farthest, 1e-3);
    for (const auto& edge : find_marker(square_.markers, "left")->edges)
        EXPECT_EQ(slid.row(edge[0]), held.row(edge[0]));
}

TEST_F(MovedSide, MovesInAsManyStepsAsAsked)
{
    const std::string bulge = "[mesh]\nfile = \"square.su2\"\n[[boundary]]\nname = \"top\"\ndegree = 2\n"
                              "control_points = [[1, 1], [0.5, 1], [0, 1]]\n"
                              "displacements = [[0, 0], [0, -0.6], [0, 0]]\n[deform]\n";
    ASSERT_EQ(deform(bulge + "steps = 7\n").status, 0);
    const auto steps = [&] {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")))["steps"].get<int>();
    };
    EXPECT_EQ(steps(), 7);
    ASSERT_EQ(deform(bulge + "steps = \"auto\"\n").status, 0);
    EXPECT_GE(steps(), 1);
    ASSERT_EQ(deform(bulge).status, 0);
    EXPECT_EQ(steps(), 1);
}

TEST_F(MovedSide, CarriesRigidLayersWithTheirWall)
{
    const std::string bulge = "[mesh]\nfile = \"square.su2\"\n[[boundary]]\nname = \"top\"\ndegree = 2\n"
                              "control_points = [[1, 1], [0.5, 1], [0, 1]]\n"
                              "displacements = [[0, 0], [0, 0.3], [0, 0]]\n[deform]\n"
                              "rigid = [{ marker = \"bottom\", distance = 0.25 }]\n";
    ASSERT_EQ(deform(bulge).status, 0);
    const Points after = read_mesh_data(folder_.file("moved.su2")).points;
    int compared = 0;
    for (Index v = 0; v < after.rows(); ++v)
        if (square_.points(v, 1) <= 0.25) {
            ++compared;
            EXPECT_EQ(after.row(v), square_.points.row(v)); // the bottom does not move
        }
    EXPECT_GT(compared, 20);
}

TEST_F(MovedSide, MovesAMarkerAsOneRigidBodyWhereItIsNamedAlone)
{
    const std::string bulge = "[mesh]\nfile = \"square.su2\"\n[[boundary]]\nname = \"top\"\ndegree = 2\n"
                              "control_points = [[1, 1], [0.5, 1], [0, 1]]\n"
                              "displacements = [[0, 0], [0, 0.3], [0, 0]]\n[deform]\n"
                              "fixed = [\"bottom\"]\nrigid = [\"top\"]\n";
    ASSERT_EQ(deform(bulge).status, 0);
    const Points after = read_mesh_data(folder_.file("moved.su2")).points;
    // The displacement is symmetric about x = 0.5, so that its best rigid motion is a shift, by its mean.
    const Index first = find_marker(square_.markers, "top")->edges[0][0];
    const double shift = after(first, 1) - 1;
    EXPECT_NEAR(shift, 0.09, 1e-12); // mean of 0.3 * 2 u (1 - u) at u = 0, 0.1, ..., 1
    for (const auto& edge : find_marker(square_.markers, "top")->edges)
        for (const Index v : edge) {
            EXPECT_NEAR(after(v, 0), square_.points(v, 0), 1e-12);
            EXPECT_NEAR(after(v, 1), 1 + shift, 1e-12);
        }
}

TEST_F(MovedSide, SaysWhatIsWrong)
{
    EXPECT_THAT(refusal("steps = 0\n"), HasSubstr("steps must be a whole number from 1"));
    EXPECT_THAT(refusal("steps = \"some\"\n"), HasSubstr("steps is 'some', but it must be one of auto"));
    EXPECT_THAT(refusal("rotations = 1\n"), HasSubstr("rotations must be true or false"));
    EXPECT_THAT(refusal("rigid = [{ distance = 1 }]\n"), HasSubstr("needs marker"));
    EXPECT_THAT(refusal("rigid = [{ marker = \"top\" }]\n"), HasSubstr("needs distance"));
    EXPECT_THAT(refusal("rigid = [{ marker = \"top\", distance = -1 }]\n"), HasSubstr("must be above 0"));
    EXPECT_THAT(refusal("rigid = [3]\n"),
                HasSubstr("must be a list of texts in quotes and tables in braces"));
    EXPECT_THAT(refusal("fixed = [\"bottom\"]\nrigid = [\"tpo\"]\n"), HasSubstr("tpo"));
    EXPECT_THAT(refusal("guard = \"untangel\"\n"), HasSubstr("did you mean 'untangle'?"));
    EXPECT_THAT(refusal("fixed = [\"bottom\"]\nslide = [\"lefd\"]\n"), HasSubstr("lefd"));
    EXPECT_THAT(refusal("method = \"ffd\"\nrotations = true\n[lattice]\npoints = [4, 4]\n"
                        "box = [0, 0, 1, 1]\n"),
                HasSubstr("go with methods that carry the boundary's move"));
    const std::string text = case_of("[[1, 1], [0, 1]]", "rotations = true\n");
    const auto weights =
        run_tool("morph-deform", {folder_.write("case.toml", text), "-o", folder_.file("m.su2"),
                                  "--save-weights", folder_.file("w.vtu")});
    EXPECT_EQ(weights.status, 1);
    EXPECT_THAT(weights.errors, HasSubstr("the move is not linear in the control points"));
    EXPECT_THAT(folder_.names(), ::testing::ElementsAre("case.toml", "square.su2"));
}

} // namespace
