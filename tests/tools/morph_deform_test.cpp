#include "formats/formats.h"
#include "libmorph/basis/closest.h"
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

// One sum of 12 products a coordinate, relative to the size of the curve.
constexpr double kLandingTolerance = 1e-12;

/// A mesh of tests/data/meshes and the markers that curves carry.
struct RealCase {
    std::string mesh;
    std::vector<std::string> markers;
};

std::ostream& operator<<(std::ostream& out, const RealCase& real)
{
    return out << real.mesh;
}

nlohmann::json report_of(const std::string& path)
{
    return nlohmann::json::parse(test::read_text(path));
}

/// Elements with a corner that does not turn left, by plain arithmetic on the flat arrays of the file.
std::vector<Index> clockwise_corners(const MeshData& mesh)
{
    std::vector<Index> found;
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto corners = static_cast<std::size_t>(corner_count(mesh.elements[e]));
        for (std::size_t k = 0; k < corners; ++k) {
            const auto a = mesh.points.row(mesh.elements[e][(k + corners - 1) % corners]);
            const auto b = mesh.points.row(mesh.elements[e][k]);
            const auto c = mesh.points.row(mesh.elements[e][(k + 1) % corners]);
            if ((c.x() - b.x()) * (a.y() - b.y()) - (c.y() - b.y()) * (a.x() - b.x()) > 0)
                continue;
            found.push_back(static_cast<Index>(e));
            break;
        }
    }
    return found;
}

void expect_same_but_for_points(const MeshData& a, const MeshData& b)
{
    EXPECT_EQ(a.elements, b.elements);
    ASSERT_EQ(a.markers.size(), b.markers.size());
    for (std::size_t i = 0; i < a.markers.size(); ++i) {
        EXPECT_EQ(a.markers[i].name, b.markers[i].name);
        EXPECT_EQ(a.markers[i].edges, b.markers[i].edges);
    }
    ASSERT_EQ(a.sections.size(), b.sections.size());
    for (std::size_t i = 0; i < a.sections.size(); ++i)
        EXPECT_EQ(a.sections[i].text, b.sections[i].text);
}

class MorphDeformRealMesh : public ::testing::TestWithParam<RealCase> {
protected:
    std::string mesh_ = test::data_path("meshes/" + GetParam().mesh);
    TemporaryFolder folder_;

    test::ProcessResult deform(const CaseFile& file, std::vector<std::string> more = {})
    {
        std::vector<std::string> arguments{folder_.write("case.toml", test::case_text(file)), "-o",
                                           folder_.file("moved.su2"), "--json", folder_.file("report.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tool("morph-deform", arguments);
    }
};

TEST_P(MorphDeformRealMesh, BendsTheBodyAndKeepsEverythingElse)
{
    CaseFile file = test::fitted_case(mesh_, GetParam().markers);
    test::turn(file, 2, {0.5, 0});
    const auto result = deform(file);
    ASSERT_EQ(result.status, 0) << result.errors;
    const MeshData before = read_mesh_data(mesh_);
    const MeshData after = read_mesh_data(folder_.file("moved.su2"));
    expect_same_but_for_points(before, after);
    EXPECT_TRUE(clockwise_corners(after).empty());
    EXPECT_GT((after.points - before.points).norm(), 0.01);
    const auto report = report_of(folder_.file("report.json"));
    EXPECT_EQ(report["quality"]["after"]["inverted"], 0);
    EXPECT_GE(report["weights"]["min"], 0.0);
    EXPECT_LE(report["weights"]["max"], 1.0 + 1e-12);
    EXPECT_LE(report["weights"]["partition_error"], 1e-12);
    for (const auto& boundary : report["boundaries"])
        EXPECT_LE(boundary["landing_error"], kLandingTolerance);
}

TEST_P(MorphDeformRealMesh, LandsEachBoundaryNodeOnTheMovedCurvePlusItsResidual)
{
    CaseFile file = test::fitted_case(mesh_, GetParam().markers);
    test::turn(file, -3, {0.2, 0.1});
    ASSERT_EQ(deform(file).status, 0);
    const MeshData before = read_mesh_data(mesh_);
    const MeshData after = read_mesh_data(folder_.file("moved.su2"));
    for (const CurveMove& entry : file.motion.curves) {
        const Curve curve(entry.curve);
        const Curve moved = curve.with_control_points(entry.curve.control_points + entry.displacements);
        for (const Index v : marker_vertices(*find_marker(before.markers, entry.marker))) {
            const Eigen::Vector2d old_position = before.points.row(v).head<2>();
            const CurveParameter on_curve = closest_parameter(curve, old_position);
            const Eigen::Vector2d new_position = after.points.row(v).head<2>();
            const Eigen::Vector2d expected = moved.point(on_curve.u) + old_position - curve.point(on_curve.u);
            EXPECT_LE((new_position - expected).norm(), 1e-9) << entry.marker << " vertex " << v;
        }
    }
}

TEST_P(MorphDeformRealMesh, MovesNothingWithoutDisplacements)
{
    const auto result = deform(test::fitted_case(mesh_, GetParam().markers));
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(read_mesh_data(folder_.file("moved.su2")).points, read_mesh_data(mesh_).points);
}

TEST_P(MorphDeformRealMesh, CountsInvertedElementsAsAnIndependentCountDoes)
{
    CaseFile file = test::fitted_case(mesh_, GetParam().markers);
    file.motion.deform.diffusivity = Diffusivity::uniform;
    test::turn(file, 60, {0.5, 0});
    const auto result = deform(file);
    EXPECT_EQ(result.status, 3);
    const auto counted = clockwise_corners(read_mesh_data(folder_.file("moved.su2")));
    ASSERT_FALSE(counted.empty());
    const auto quality = report_of(folder_.file("report.json"))["quality"]["after"];
    EXPECT_EQ(quality["inverted"], counted.size());
    const std::vector<Index> listed = quality["inverted_elements"];
    EXPECT_EQ(listed, std::vector<Index>(counted.begin(),
                                         counted.begin() +
                                             static_cast<long>(std::min<std::size_t>(counted.size(), 1000))));
    EXPECT_THAT(result.errors, HasSubstr("elements are inverted"));
    EXPECT_THAT(result.errors, HasSubstr(" of this move is safe: element "));
}

INSTANTIATE_TEST_SUITE_P(
    Meshes, MorphDeformRealMesh,
    ::testing::Values(RealCase{"naca0012_inv.su2", {"airfoil"}},
                      RealCase{"naca0012_lam_hybrid.su2", {"airfoil"}},
                      RealCase{"rae2822_turb.su2", {"AIRFOIL"}}, RealCase{"cylinder_lam.su2", {"cylinder"}},
                      RealCase{"naca0012_multiffd.su2", {"airfoil_lower", "airfoil_upper"}}));

/// The first real mesh, fitted, with a moderate move.
class MorphDeform : public ::testing::Test {
protected:
    TemporaryFolder folder_;
    std::string mesh_ = test::data_path("meshes/naca0012_inv.su2");
    CaseFile file_ = test::fitted_case(mesh_, {"airfoil"});

    std::string write_case() const { return folder_.write("case.toml", test::case_text(file_)); }
    void SetUp() override { test::turn(file_, 4, {0.5, 0}); }
};

TEST_F(MorphDeform, WritesTheSameBytesForAnyThreadCount)
{
    const std::string path = write_case();
    for (const std::string threads : {"1", "2", "3"})
        ASSERT_EQ(run_tool("morph-deform", {path, "-o", folder_.file(threads + ".su2"), "--threads", threads})
                      .status,
                  0);
    EXPECT_EQ(test::read_text(folder_.file("1.su2")), test::read_text(folder_.file("2.su2")));
    EXPECT_EQ(test::read_text(folder_.file("1.su2")), test::read_text(folder_.file("3.su2")));
}

TEST_F(MorphDeform, MovesBySavedWeightsAsByItsOwn)
{
    const std::string path = write_case();
    const std::string saved = folder_.file("weights.vtu");
    ASSERT_EQ(run_tool("morph-deform", {path, "-o", folder_.file("a.su2"), "--save-weights", saved}).status,
              0);
    ASSERT_EQ(run_tool("morph-deform", {path, "-o", folder_.file("b.su2"), "--weights", saved}).status, 0);
    EXPECT_EQ(test::read_text(folder_.file("a.su2")), test::read_text(folder_.file("b.su2")));
    const MeshData weights = read_mesh_data(saved);
    EXPECT_EQ(weights.fields.size(), 12U);
    EXPECT_NE(find_field(weights.fields, "h_airfoil_12", FieldLocation::vertex), nullptr);
    EXPECT_EQ(weights.points, read_mesh_data(mesh_).points);
}

TEST_F(MorphDeform, IsLinearInTheDisplacements)
{
    const MeshData start = read_mesh_data(mesh_);
    ASSERT_EQ(run_tool("morph-deform", {write_case(), "-o", folder_.file("one.su2")}).status, 0);
    file_.motion.curves[0].displacements *= 0.5;
    ASSERT_EQ(run_tool("morph-deform", {write_case(), "-o", folder_.file("half.su2")}).status, 0);
    const Points one = read_mesh_data(folder_.file("one.su2")).points - start.points;
    const Points half = read_mesh_data(folder_.file("half.su2")).points - start.points;
    EXPECT_LE((one - 2 * half).norm(), 1e-12 * start.points.norm());
}

TEST_F(MorphDeform, TellsHowMuchOfAMoveIsSafe)
{
    test::turn(file_, 40, {0.5, 0});
    file_.motion.deform.diffusivity = Diffusivity::uniform;
    const Points2 whole = file_.motion.curves[0].displacements;
    const auto report_with = [&](double part) {
        file_.motion.curves[0].displacements = part * whole;
        run_tool("morph-deform",
                 {write_case(), "-o", folder_.file("m.su2"), "--json", folder_.file("r.json")});
        return report_of(folder_.file("r.json"));
    };
    const nlohmann::json safe = report_with(1)["safe_step"];
    const double step = safe["step"];
    ASSERT_GT(step, 0);
    ASSERT_LT(step, 1);
    // Coordinates that are rounded shift the step by little; 1e-9 of it leaves room for that.
    const nlohmann::json below = report_with(step * (1 - 1e-9));
    EXPECT_EQ(below["quality"]["after"]["inverted"], 0);
    EXPECT_EQ(below["safe_step"]["step"], 1);
    EXPECT_TRUE(below["safe_step"]["element"].is_null());
    const nlohmann::json above = report_with(step * (1 + 1e-9));
    EXPECT_EQ(above["quality"]["after"]["inverted_elements"], nlohmann::json::array({safe["element"]}));
}

TEST_F(MorphDeform, DoesNotLookAtTheResultWithGuardNone)
{
    test::turn(file_, 60, {0.5, 0});
    file_.motion.deform.diffusivity = Diffusivity::uniform;
    const auto result =
        run_tool("morph-deform", {write_case(), "-o", folder_.file("m.su2"), "--guard", "none"});
    EXPECT_EQ(result.status, 0) << result.errors;
}

TEST_F(MorphDeform, KeepsStandardOutputForTheJsonAlone)
{
    const auto result = run_tool("morph-deform", {write_case(), "-o", folder_.file("m.su2"), "--json", "-"});
    ASSERT_EQ(result.status, 0);
    const auto report = nlohmann::json::parse(result.output);
    EXPECT_EQ(report["method"], "harmonic");
    EXPECT_EQ(report["control_points"], 12);
    for (const char* stage : {"read", "weights", "apply", "guard", "write"})
        EXPECT_GE(report["seconds"][stage], 0.0) << stage;
}

TEST_F(MorphDeform, PrintsNothingWhenQuiet)
{
    const auto result = run_tool("morph-deform", {write_case(), "-o", folder_.file("m.su2"), "--quiet"});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.output + result.errors, "");
}

TEST_F(MorphDeform, WarnsOfAMovedCurveThatCrossesItself)
{
    file_.motion.curves[0].displacements.setZero();
    file_.motion.curves[0].displacements.row(3) << 0, 0.5;
    file_.motion.curves[0].displacements.row(9) << 0, -0.5;
    const auto result = run_tool("morph-deform", {write_case(), "-o", folder_.file("m.su2")});
    EXPECT_EQ(result.status, 3);
    EXPECT_THAT(result.errors, HasSubstr("crosses itself near"));
}

/// Runs that must end with a status and a message, and leave nothing.
struct Refusal {
    std::string what;
    std::vector<std::string> arguments; ///< after the case file; @ stands for the folder
    int status;
    std::string message;
};

TEST_F(MorphDeform, RefusesBadCallsInOneLineAndLeavesNothing)
{
    const std::string path = write_case();
    folder_.write("other.vtu", "not a mesh");
    const std::vector<Refusal> refusals{
        {"no output", {}, 2, "-o OUT"},
        {"unknown option", {"-o", "@/m.su2", "--guardd", "none"}, 2, "did you mean '--guard'?"},
        {"unknown guard", {"-o", "@/m.su2", "--guard", "never"}, 2, "--guard"},
        {"unknown method", {"-o", "@/m.su2", "--method", "magic"}, 2, "--method"},
        {"threads in words", {"-o", "@/m.su2", "--threads", "two"}, 2, "--threads"},
        {"second case", {"again.toml", "-o", "@/m.su2"}, 2, "unexpected argument 'again.toml'"},
        {"unknown extension", {"-o", "@/m.xyz"}, 1, "'.xyz' is not that of a known format"},
        {"unknown format", {"-o", "@/m.su2", "--to", "su3"}, 1, "did you mean 'su2'?"},
        {"no such folder", {"-o", "@/none/m.su2"}, 1, "cannot be written"},
        {"folder as output", {"-o", "@"}, 1, ""},
        {"full disk", {"-o", "/dev/full", "--to", "su2"}, 1, "No space left on device"},
        {"report in no folder", {"-o", "@/m.su2", "--json", "@/none/r.json"}, 1, "cannot be written"},
        {"report on a full disk", {"-o", "@/m.su2", "--json", "/dev/full"}, 1, "No space left on device"},
        {"weights in no folder", {"-o", "@/m.su2", "--save-weights", "@/none/w.vtu"}, 1, "cannot be written"},
        {"missing weights", {"-o", "@/m.su2", "--weights", "@/none.vtu"}, 1, "none.vtu: cannot be read"},
        {"broken weights", {"-o", "@/m.su2", "--weights", "@/other.vtu"}, 1, "other.vtu"},
        {"weights of a mesh without them",
         {"-o", "@/m.su2", "--weights", mesh_},
         1,
         "no nodal field 'h_airfoil_1'"},
    };
    const auto names = folder_.names();
    for (const Refusal& refusal : refusals) {
        std::vector<std::string> arguments{path};
        for (std::string argument : refusal.arguments) {
            if (argument[0] == '@')
                argument = folder_.path() + argument.substr(1);
            arguments.push_back(argument);
        }
        const auto result = run_tool("morph-deform", arguments);
        EXPECT_EQ(result.status, refusal.status) << refusal.what << ": " << result.errors;
        EXPECT_THAT(result.errors, HasSubstr(refusal.message)) << refusal.what;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1)
            << refusal.what << result.errors;
        EXPECT_EQ(folder_.names(), names) << refusal.what;
    }
}

TEST_F(MorphDeform, RefusesCasesThatDoNotGoWithTheMesh)
{
    const auto complaint = [&](const CaseFile& file) {
        const auto result = run_tool(
            "morph-deform", {folder_.write("bad.toml", test::case_text(file)), "-o", folder_.file("m.su2")});
        EXPECT_EQ(result.status, 1) << result.errors;
        return result.errors;
    };
    CaseFile file = file_;
    file.motion.curves[0].marker = "airfiol";
    EXPECT_THAT(complaint(file), HasSubstr("did you mean 'airfoil'?"));
    file = file_;
    file.motion.curves[0].curve.closed = false;
    file.motion.curves[0].curve.knots.clear();
    EXPECT_THAT(complaint(file), HasSubstr("boundary 'airfoil'"));
    file = file_;
    file.motion.curves[0].curve.knots.clear();
    file.motion.curves[0].curve.control_points.row(2).swap(file.motion.curves[0].curve.control_points.row(8));
    EXPECT_THAT(complaint(file), HasSubstr("crosses itself"));
    file = file_;
    file.mesh_file = folder_.path();
    EXPECT_THAT(complaint(file), HasSubstr(folder_.path()));
}

TEST_F(MorphDeform, LeavesAFileThatWasThereUnchangedWhenItFails)
{
    const std::string kept = folder_.write("m.su2", "precious");
    file_.mesh_file = folder_.file("missing.su2");
    const auto result = run_tool("morph-deform", {write_case(), "-o", kept});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(test::read_text(kept), "precious");
}

TEST_F(MorphDeform, HelpEndsWithAWorkedExample)
{
    const auto result = run_tool("morph-deform", {"--help"});
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.output, HasSubstr("Example:"));
}

class ThesisCase : public ::testing::TestWithParam<std::string> {};

TEST_P(ThesisCase, RunsFromOneCommand)
{
    const TemporaryFolder folder;
    const auto result =
        run_tool("morph-deform", {test::example_path(GetParam() + "/case.toml"), "-o",
                                  folder.file("moved.su2"), "--json", folder.file("report.json")});
    ASSERT_EQ(result.status, 0) << result.errors << result.output;
    const auto report = report_of(folder.file("report.json"));
    EXPECT_EQ(report["quality"]["after"]["inverted"], 0);
    for (const auto& boundary : report["boundaries"]) {
        EXPECT_EQ(boundary["nodes"], 100);
        EXPECT_LE(boundary["max_distance"], 1e-12);
        EXPECT_LE(boundary["landing_error"], kLandingTolerance);
    }
}

INSTANTIATE_TEST_SUITE_P(Both, ThesisCase, ::testing::Values("01_thesis_case1", "02_thesis_case2"));

} // namespace
