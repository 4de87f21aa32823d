// Direct control of morph-deform: [[pull]] and --gradient.
#include "formats/csv/table.h"
#include "formats/formats.h"
#include "tests/support/cases.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using namespace morph;
using test::run_tool;
using test::TemporaryFolder;
using ::testing::HasSubstr;

class DirectControl : public ::testing::Test {
protected:
    DirectControl() : file_(test::fitted_case(mesh_, {"airfoil"})) {}

    std::string write_case(const std::string& more = "")
    {
        return folder_.write("case.toml", test::case_text(file_) + more);
    }

    Points moved(const std::string& more = "")
    {
        const auto result = run_tool("morph-deform", {write_case(more), "-o", folder_.file("moved.su2"),
                                                      "--json", folder_.file("report.json")});
        EXPECT_EQ(result.status, 0) << result.errors;
        return read_mesh_data(folder_.file("moved.su2")).points;
    }

    std::string refusal(const std::string& more)
    {
        const auto result = run_tool("morph-deform", {write_case(more), "-o", folder_.file("never.su2")});
        EXPECT_EQ(result.status, 1);
        return result.errors;
    }

    TemporaryFolder folder_;
    std::string mesh_ = test::example_path("naca0012_inv.su2");
    Points before_ = read_mesh_data(mesh_).points;
    CaseFile file_;
};

TEST_F(DirectControl, BringsPulledVerticesWhereTheyAreWanted)
{
    // Vertices of the body and one inside the mesh.
    const Points after =
        moved("[[pull]]\nvertices = [20, 100, 160]\ndisplacements = [[0.001, 0.01], [0, -0.005], [0, 0]]\n"
              "[[pull]]\npoints = [[0.5, 0.3]]\ndisplacements = [[0, 0.004]]\n");
    EXPECT_LT((after.row(20) - before_.row(20) - Eigen::RowVector3d(0.001, 0.01, 0)).norm(), 1e-10);
    EXPECT_LT((after.row(100) - before_.row(100) - Eigen::RowVector3d(0, -0.005, 0)).norm(), 1e-10);
    EXPECT_LT((after.row(160) - before_.row(160)).norm(), 1e-10);
    Index nearest = 0;
    (before_.rowwise() - Eigen::RowVector3d(0.5, 0.3, 0)).rowwise().norm().minCoeff(&nearest);
    EXPECT_LT((after.row(nearest) - before_.row(nearest) - Eigen::RowVector3d(0, 0.004, 0)).norm(), 1e-10);
    const auto report = nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    EXPECT_EQ(report["pull"]["points"], 4);
    EXPECT_EQ(report["pull"]["rank"], 4);
    EXPECT_LT(report["pull"]["max_residual"], 1e-10);
    EXPECT_EQ(report["pull"]["residuals"][1]["vertex"], 100);
    EXPECT_LT(report["boundaries"][0]["landing_error"],
              1e-12); // the boundary is still a curve of the control points
}

TEST_F(DirectControl, ReportsWhatCannotBeReached)
{
    // The farfield is fixed: no control point moves it.
    Index far = 0;
    before_.col(0).maxCoeff(&far);
    moved("[[pull]]\nvertices = [" + std::to_string(far) + "]\ndisplacements = [[0.25, 0]]\n");
    const auto report = nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    EXPECT_EQ(report["pull"]["rank"], 0);
    EXPECT_DOUBLE_EQ(report["pull"]["max_residual"], 0.25);
}

TEST_F(DirectControl, SaysWhatIsWrongWithAPull)
{
    EXPECT_THAT(refusal("[[pull]]\nvertices = [99999]\ndisplacements = [[0, 1]]\n"),
                HasSubstr("[[pull]] names vertex 99999, but the mesh has 5233"));
    EXPECT_THAT(refusal("[[pull]]\nvertices = [1]\ndisplacements = [[0, 1], [0, 2]]\n"),
                HasSubstr("[[pull]] displacements has 2 rows, but there are 1 points"));
    EXPECT_THAT(refusal("[[pull]]\ndisplacements = [[0, 1]]\n"),
                HasSubstr("[[pull]] needs either vertices or points"));
    EXPECT_THAT(refusal("[[pull]]\nvertices = [1]\n"), HasSubstr("[[pull]] needs displacements"));
    EXPECT_THAT(refusal("[[pull]]\nvertices = [1]\nmove = 3\ndisplacements = [[0, 1]]\n"),
                HasSubstr("unknown key 'move'"));
    EXPECT_THAT(refusal("[[pull]]\nvertices = [0.5]\ndisplacements = [[0, 1]]\n"),
                HasSubstr("must be whole numbers"));
}

/// A smooth objective of the vertices, its value and its derivatives.
double objective(const Points& x)
{
    return (x.col(0).array() * x.col(1).array() * 3 + x.col(1).array().square()).sum();
}

std::string derivatives(const Points& x)
{
    std::string csv = "id,dx,dy\n";
    for (Index v = static_cast<Index>(x.rows()); v-- > 0;) { // in any order
        std::array<char, 120> line{};
        std::snprintf(line.data(), line.size(), "%d,%.17g,%.17g\n", v, 3 * x(v, 1),
                      3 * x(v, 0) + 2 * x(v, 1));
        csv += line.data();
    }
    return csv;
}

TEST_F(DirectControl, GradientsAgreeWithFiniteDifferences)
{
    const std::string by_vertex = folder_.write("dJdX.csv", derivatives(before_));
    const auto result =
        run_tool("morph-deform", {write_case(), "--gradient", by_vertex, "-o", folder_.file("dJdP.csv")});
    ASSERT_EQ(result.status, 0) << result.errors;
    const std::string text = test::read_text(folder_.file("dJdP.csv"));
    EXPECT_THAT(text, ::testing::StartsWith("boundary,i,dx,dy\nairfoil,1,"));
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    std::vector<std::array<double, 2>> gradient;
    while (std::getline(lines, line)) {
        int number = 0;
        gradient.emplace_back();
        ASSERT_EQ(std::sscanf(line.c_str(), "airfoil,%d,%lf,%lf", &number, &gradient.back()[0],
                              &gradient.back()[1]),
                  3);
        ASSERT_EQ(number, static_cast<int>(gradient.size()));
    }
    ASSERT_EQ(gradient.size(), 12U);
    // J is quadratic in the control points, so that central differences are exact but for rounding.
    constexpr double kStep = 1e-3;
    for (const Index k : {0, 4, 9})
        for (Eigen::Index c = 0; c < 2; ++c) {
            file_.motion.curves[0].displacements(k, c) = kStep;
            const double above = objective(moved());
            file_.motion.curves[0].displacements(k, c) = -kStep;
            const double below = objective(moved());
            file_.motion.curves[0].displacements(k, c) = 0;
            const double difference = (above - below) / (2 * kStep);
            const double exact = gradient[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)];
            EXPECT_NEAR(exact, difference, 1e-8 * std::max(1.0, std::abs(exact)));
        }
}

TEST_F(DirectControl, TakesMissingVerticesForZeroAndRefusesOthers)
{
    const auto gradient = [&](const std::string& text) {
        return run_tool("morph-deform", {write_case(), "--gradient", folder_.write("g.csv", text), "-o",
                                         folder_.file("p.csv")});
    };
    ASSERT_EQ(gradient("id,dx,dy\n").status, 0);
    EXPECT_THAT(test::read_text(folder_.file("p.csv")), HasSubstr("airfoil,12,0,0\n"));
    EXPECT_THAT(gradient("id,dx,dy\n5233,0,0\n").errors,
                HasSubstr("g.csv:2: id must be a vertex, a whole number from 0 to 5232"));
    EXPECT_THAT(gradient("id,dx,dy\n7,0,0\n7,1,1\n").errors,
                HasSubstr("g.csv:3: vertex 7 is there a second time; the first was in line 2"));
    EXPECT_THAT(gradient("id,dx\n7,0\n").errors, HasSubstr("has no column 'dy'"));
    EXPECT_EQ(run_tool("morph-deform", {write_case(), "--gradient", folder_.file("g.csv")}).status, 2);
}

} // namespace
