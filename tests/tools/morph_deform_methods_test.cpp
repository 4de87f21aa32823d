// Every method of morph-deform that carries a boundary's move into the mesh, and the options of each.
#include "formats/formats.h"
#include "tests/support/cases.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using namespace morph;
using test::run_tool;
using test::TemporaryFolder;
using ::testing::HasSubstr;

/// A method and more lines of [deform].
struct Told {
    const char* method;
    const char* more;
    bool couples; ///< x and y influence each other, or rotations are spread
};

std::ostream& operator<<(std::ostream& out, const Told& told)
{
    return out << told.method << ' ' << told.more;
}

class Method : public ::testing::TestWithParam<Told> {
protected:
    Method()
    {
        file_.motion.deform.method = from_string<morph::Method>(GetParam().method);
        test::turn(file_, 15, {0.5, 0});
    }

    test::ProcessResult deform(const std::vector<std::string>& more = {})
    {
        std::vector<std::string> arguments{
            folder_.write("case.toml", test::case_text(file_) + GetParam().more), "-o",
            folder_.file("moved.su2"), "--json", folder_.file("report.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_tool("morph-deform", arguments);
    }

    nlohmann::json report() const
    {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    }

    TemporaryFolder folder_;
    std::string mesh_ = test::example_path("naca0012_inv.su2");
    CaseFile file_ = test::fitted_case(mesh_, {"airfoil"});
};

TEST_P(Method, TurnsAnAirfoilExactlyOnTheCurve)
{
    const auto result = deform();
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(report()["method"], GetParam().method);
    EXPECT_LT(report()["boundaries"][0]["landing_error"], 1e-12);
    EXPECT_EQ(report()["quality"]["after"]["inverted"], 0);
    const MeshData before = read_mesh_data(mesh_);
    const Points after = read_mesh_data(folder_.file("moved.su2")).points;
    for (const auto& edge : find_marker(before.markers, "farfield")->edges)
        ASSERT_EQ(after.row(edge[0]), before.points.row(edge[0]));
}

TEST_P(Method, SavesWeightsThatMoveTheMeshAlikeOrSaysThatThereAreNone)
{
    const auto saved = deform({"--save-weights", folder_.file("w.vtu")});
    if (GetParam().couples) {
        EXPECT_EQ(saved.status, 1);
        EXPECT_THAT(saved.errors, HasSubstr("the move is not linear"));
        return;
    }
    ASSERT_EQ(saved.status, 0) << saved.errors;
    const Points solved = read_mesh_data(folder_.file("moved.su2")).points;
    ASSERT_EQ(deform({"--weights", folder_.file("w.vtu")}).status, 0);
    EXPECT_LT((read_mesh_data(folder_.file("moved.su2")).points - solved).cwiseAbs().maxCoeff(), 1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    Methods, Method,
    ::testing::Values(
        Told{"harmonic", "", false}, Told{"harmonic", "rotations = true\n", true}, Told{"rbf", "", false},
        Told{"rbf", "rbf = { function = \"thin-plate\", tolerance = 1e-3 }\n", false},
        Told{"rbf", "rbf = { function = \"wendland-c0\", support = 30.0, linear = false }\n", false},
        Told{"idw", "", true}, Told{"idw", "rotations = false\n", false},
        Told{"idw", "idw = { far_exponent = 2.5, near_exponent = 4, reach = 20, stiffness = 0.3 }\n", true},
        Told{"damping", "", false}, Told{"elasticity", "", true},
        Told{"elasticity", "elasticity = { modulus = \"inverse-distance\", poisson_ratio = 0.0 }\n", true},
        Told{"spring", "", true}, Told{"spring", "spring = { bracing = \"ball-vertex\" }\n", true},
        Told{"spring", "spring = { bracing = \"none\" }\n", false}, Told{"biharmonic", "", true},
        Told{"biharmonic", "biharmonic = { condition = \"clamped\" }\n", false}));

TEST(MethodOptions, SayWhatIsWrongWithThem)
{
    const TemporaryFolder folder;
    const std::string text =
        test::case_text(test::fitted_case(test::example_path("naca0012_inv.su2"), {"airfoil"}));
    const auto refusal = [&](const std::string& more) {
        const auto result = run_tool(
            "morph-deform", {folder.write("case.toml", text + more), "-o", folder.file("never.su2")});
        EXPECT_EQ(result.status, 1);
        EXPECT_THAT(folder.names(), ::testing::ElementsAre("case.toml"));
        return result.errors;
    };
    EXPECT_THAT(refusal("rbf = { radius = 3 }\n"), HasSubstr("unknown key 'radius' in [deform.rbf]"));
    EXPECT_THAT(refusal("rbf = { function = \"wendland\" }\n"), HasSubstr("must be one of wendland-c0"));
    EXPECT_THAT(refusal("rbf = { support = 0 }\n"), HasSubstr("support must be above 0"));
    EXPECT_THAT(refusal("idw = 3\n"), HasSubstr("[deform.idw] must be a table"));
    EXPECT_THAT(refusal("spring = { bracing = \"bell\" }\n"), HasSubstr("must be one of none, torsion"));
    const auto with_method = [&](const std::string& method, const std::string& more) {
        std::string changed = text;
        changed.replace(changed.find("method = \"harmonic\""), 19, "method = \"" + method + "\"");
        const auto result = run_tool(
            "morph-deform", {folder.write("case.toml", changed + more), "-o", folder.file("never.su2")});
        EXPECT_EQ(result.status, 1);
        return result.errors;
    };
    EXPECT_THAT(with_method("elasticity", "elasticity = { poisson_ratio = 0.5 }\n"), HasSubstr("ratio"));
    EXPECT_THAT(with_method("elasticity", "rotations = true\n"),
                HasSubstr("rotations go with methods that move x and y apart"));
    EXPECT_THAT(with_method("rbf", "rbf = { function = \"thin-plate\", linear = false }\n"),
                HasSubstr("linear"));
    EXPECT_THAT(with_method("elasticty", ""), HasSubstr("did you mean 'elasticity'?"));
}

} // namespace
