#include "formats/formats.h"
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
using ::testing::Not;

class MorphCompare : public ::testing::Test {
protected:
    nlohmann::json compare(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.begin(), case_);
        arguments.insert(arguments.end(), {"--json", folder_.file("report.json"), "--quiet"});
        const auto result = run_tool("morph-compare", arguments);
        EXPECT_EQ(result.status, 0) << result.errors;
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    }

    TemporaryFolder folder_;
    std::string case_ = test::example_path("compare/naca0012_inv.toml");
};

TEST_F(MorphCompare, SaysOfEachMethodWhatMorphDeformSays)
{
    const auto row = compare({"--methods", "harmonic-distance"})["moves"][0]["methods"][0];
    const auto deformed =
        run_tool("morph-deform", {case_, "-o", folder_.file("moved.su2"), "--diffusivity", "inverse-distance",
                                  "--json", folder_.file("deform.json")});
    ASSERT_EQ(deformed.status, 0) << deformed.errors;
    const auto report = nlohmann::json::parse(test::read_text(folder_.file("deform.json")));
    for (const char* key : {"inverted", "min_scaled_jacobian", "mean_scaled_jacobian", "min_angle"})
        EXPECT_EQ(row["quality"][key], report["quality"]["after"][key]) << key;
    EXPECT_EQ(row["control_variables"], 2 * report["control_points"].get<int>());
    EXPECT_LT(row["boundary_error"], 1e-12); // harmonic weights make the curve exactly
    EXPECT_EQ(row["memory_bytes"], 8 * 5233 * 12);
}

TEST_F(MorphCompare, MakesTheMoveSeveralTimesAsLarge)
{
    const auto moves = compare({"--methods", "harmonic,harmonic-area", "--moves", "0.5,1,2"})["moves"];
    ASSERT_EQ(moves.size(), 3U);
    // The displacement is linear in the move, so its energy is quadratic.
    for (std::size_t method = 0; method < 2; ++method) {
        const double one = moves[1]["methods"][method]["energy"];
        EXPECT_NEAR(moves[0]["methods"][method]["energy"], one / 4, 1e-12 * one);
        EXPECT_NEAR(moves[2]["methods"][method]["energy"], 4 * one, 1e-12 * one);
    }
    // Laplace's equation has the least energy of all.
    EXPECT_LT(moves[1]["methods"][0]["energy"], moves[1]["methods"][1]["energy"]);
}

TEST_F(MorphCompare, WritesAPageThatNeedsNoOtherFile)
{
    compare({"--methods", "harmonic,harmonic-area", "--page", folder_.file("page.html")});
    const std::string page = test::read_text(folder_.file("page.html"));
    EXPECT_THAT(page, HasSubstr("<td>harmonic-area</td>"));
    EXPECT_THAT(page, Not(HasSubstr("http")));
    std::size_t pictures = 0, embedded = 0;
    for (std::size_t at = 0; (at = page.find("<img ", at)) != std::string::npos; ++at)
        ++pictures;
    for (std::size_t at = 0;
         (at = page.find("src=\"data:image/png;base64,iVBORw0KGgo", at)) != std::string::npos; ++at)
        ++embedded;
    EXPECT_EQ(pictures, 4U); // each method: the body, and its worst element from near
    EXPECT_EQ(embedded, pictures);
}

TEST_F(MorphCompare, RepairsWhatAMethodLeavesInverted)
{
    const auto rows = compare({"--methods", "harmonic,harmonic+untangle,harmonic-rotations", "--moves",
                               "3"})["moves"][0]["methods"];
    EXPECT_GT(rows[0]["quality"]["inverted"], 100);
    EXPECT_EQ(rows[1]["method"], "harmonic+untangle");
    EXPECT_EQ(rows[1]["quality"]["inverted"], 0);
    EXPECT_GT(rows[1]["quality"]["min_scaled_jacobian"], 0);
    EXPECT_EQ(rows[1]["boundary_error"], rows[0]["boundary_error"]); // the boundary is held
    EXPECT_EQ(rows[2]["quality"]["inverted"], 0);
    EXPECT_GT(rows[2]["quality"]["mean_size_skew"], rows[0]["quality"]["mean_size_skew"]);
}

TEST_F(MorphCompare, PrintsATableByDefaultOfEveryMethod)
{
    const auto result = run_tool("morph-compare", {case_});
    ASSERT_EQ(result.status, 0) << result.errors;
    for (const char* text : {"method", "min f_ss", "harmonic ", "harmonic-distance", "harmonic-area"})
        EXPECT_THAT(result.output, HasSubstr(text));
}

TEST_F(MorphCompare, RefusesMethodsItDoesNotKnow)
{
    const auto result =
        run_tool("morph-compare", {case_, "--methods", "harmonics", "--page", folder_.file("x.html")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("method 'harmonics' is not known"));
    EXPECT_THAT(result.errors, HasSubstr("did you mean 'harmonic'?"));
    EXPECT_TRUE(folder_.names().empty());
}

} // namespace
