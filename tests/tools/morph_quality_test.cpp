#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

namespace morph {
namespace {

using nlohmann::json;
using test::ProcessResult;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;

ProcessResult quality(const std::vector<std::string>& arguments)
{
    return test::run_tool("morph-quality", arguments);
}

std::string real(const std::string& name)
{
    return test::data_path("meshes/" + name);
}

/// A real mesh with its vertices moved at random by up to @p amount, as a file; returns its arrays.
MeshData shaken(const std::string& mesh, double amount, const std::string& path)
{
    MeshData data = read_mesh_data(real(mesh));
    std::mt19937 random(4);
    std::uniform_real_distribution<double> shift(-amount, amount);
    for (Index v = 0; v < data.points.rows(); ++v) {
        data.points(v, 0) += shift(random);
        data.points(v, 1) += shift(random);
    }
    write_mesh_data(data, path);
    return data;
}

double twice_area(const MeshData& data, Index a, Index b, Index c)
{
    const auto& p = data.points;
    return (p(b, 0) - p(a, 0)) * (p(c, 1) - p(a, 1)) - (p(b, 1) - p(a, 1)) * (p(c, 0) - p(a, 0));
}

/// The inverted elements, counted the plain way; in none of the meshes here does rounding decide. The file
/// lists its elements counter-clockwise if @p turn is 1 and clockwise if it is -1.
std::vector<Index> plain_count(const MeshData& data, double turn)
{
    std::vector<Index> inverted;
    for (std::size_t e = 0; e < data.elements.size(); ++e) {
        const Element& q = data.elements[e];
        const auto n = static_cast<std::size_t>(corner_count(q));
        bool bad = false;
        for (std::size_t k = 0; k < n; ++k)
            bad = bad || turn * twice_area(data, q[k], q[(k + 1) % n], q[(k + n - 1) % n]) <= 0;
        if (bad)
            inverted.push_back(static_cast<Index>(e));
    }
    return inverted;
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> cells_of(const std::string& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line + ","); // a last cell may be empty
    for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(cell);
    return cells;
}

TEST(MorphQuality, FindsNothingWrongWithTheRealMeshes)
{
    for (const std::string& path : test::real_meshes()) {
        const ProcessResult result = quality({path, "--json", "-"});
        ASSERT_EQ(result.status, 0) << path << result.errors;
        const json report = json::parse(result.output);
        const MeshData data = read_mesh_data(path);
        EXPECT_EQ(report["vertices"], data.points.rows());
        EXPECT_EQ(report["triangles"].get<int>() + report["quads"].get<int>(), data.elements.size());
        EXPECT_EQ(report["inverted"], 0);
        EXPECT_GT(report["min_scaled_jacobian"], 0);
        EXPECT_FALSE(report.contains("min_size_skew"));
    }
}

TEST(MorphQuality, CountsListsAndReportsInvertedElementsAsAPlainCountDoes)
{
    for (const char* mesh : {"naca0012_inv.su2", "naca0012_lam_hybrid.su2", "ls89.su2"}) {
        const TemporaryFolder folder;
        const std::string moved = folder.file("moved.su2");
        const MeshData data = shaken(mesh, std::string(mesh) == "ls89.su2" ? 1e-5 : 1e-3, moved);
        // The listing's own direction is that of most elements of the mesh before it was shaken.
        const auto unmoved = read_mesh_data(real(mesh));
        const double turn = plain_count(unmoved, 1).size() < unmoved.elements.size() / 2 ? 1 : -1;
        const std::vector<Index> expected = plain_count(data, turn);
        ASSERT_FALSE(expected.empty());

        const ProcessResult result =
            quality({moved, "--list", folder.file("bad.csv"), "--vtu", folder.file("metrics.vtu"), "--json",
                     folder.file("report.json")});

        EXPECT_EQ(result.status, 3) << mesh << result.errors;
        const json report = json::parse(test::read_text(folder.file("report.json")));
        EXPECT_EQ(report["inverted"], expected.size());
        auto listed = expected;
        listed.resize(std::min<std::size_t>(listed.size(), 1000));
        EXPECT_EQ(report["inverted_elements"].get<std::vector<Index>>(), listed);

        const auto lines = lines_of(test::read_text(folder.file("bad.csv")));
        EXPECT_THAT(lines[0], testing::StartsWith("id,type,x,y,z,area,min_corner_jacobian,scaled_jacobian"));
        ASSERT_EQ(lines.size(), expected.size() + 1);
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_THAT(lines[i + 1], testing::StartsWith(std::to_string(expected[i]) + ","));

        const MeshData metrics = read_mesh_data(folder.file("metrics.vtu"));
        const Field* inverted = find_field(metrics.fields, "inverted", FieldLocation::element);
        ASSERT_NE(inverted, nullptr);
        EXPECT_EQ(inverted->values.sum(), static_cast<double>(expected.size()));
        EXPECT_EQ(inverted->values(expected.front(), 0), 1);
        EXPECT_NE(find_field(metrics.fields, "scaled_jacobian", FieldLocation::element), nullptr);
    }
}

TEST(MorphQuality, GivesTheSameBytesForAnyNumberOfThreads)
{
    const std::string mesh = real("rae2822_turb.su2");
    const ProcessResult one = quality({mesh, "--reference", mesh, "--json", "-", "--threads", "1"});
    const ProcessResult three = quality({mesh, "--reference", mesh, "--json", "-", "--threads", "3"});
    EXPECT_EQ(one.status, 0);
    EXPECT_EQ(one.output, three.output);
}

TEST(MorphQuality, ComparesWithTheMeshBeforeItWasMoved)
{
    const TemporaryFolder folder;
    MeshData square = test::quad_square(1);
    write_mesh_data(square, folder.file("reference.su2"));
    square.points *= 2; // a square still, of four times the area: f_ss = sqrt(1/4)
    write_mesh_data(square, folder.file("moved.su2"));
    const ProcessResult result =
        quality({folder.file("moved.su2"), "--reference", folder.file("reference.su2"), "--json", "-"});
    ASSERT_EQ(result.status, 0) << result.errors;
    const json report = json::parse(result.output);
    EXPECT_DOUBLE_EQ(report["min_size_skew"], 0.5);
    EXPECT_DOUBLE_EQ(report["mean_size_skew"], 0.5);
}

TEST(MorphQuality, MatchesTheReferenceByTheNumbersOfTheFiles)
{
    const TemporaryFolder folder;
    const std::string mesh = real("naca0012_lam_hybrid.su2");
    MeshData turned = read_mesh_data(mesh);
    // A quarter turn changes no shape or size, but the order of the vertices along a space-filling curve.
    const Eigen::VectorXd x = turned.points.col(0);
    turned.points.col(0) = -turned.points.col(1);
    turned.points.col(1) = x;
    write_mesh_data(turned, folder.file("turned.su2"));
    const json with_itself = json::parse(quality({mesh, "--reference", mesh, "--json", "-"}).output);
    const json with_turned =
        json::parse(quality({folder.file("turned.su2"), "--reference", mesh, "--json", "-"}).output);
    constexpr double kTurnTol = 1e-9; // areas of 1e-10 and so from differences of coordinates of size 1
    EXPECT_NEAR(with_turned["mean_size_skew"], with_itself["mean_size_skew"].get<double>(), kTurnTol);
    EXPECT_NEAR(with_turned["min_size_skew"], with_itself["min_size_skew"].get<double>(), kTurnTol);
}

TEST(MorphQuality, WritesEveryMetricOfEveryElementAsCsvAndVtu)
{
    for (const std::string& mesh : {real("naca0012_lam_hybrid.su2"), real("ls89.su2")}) {
        const TemporaryFolder folder;
        const ProcessResult result = quality({mesh, "--reference", mesh, "--csv", folder.file("all.csv"),
                                              "--vtu", folder.file("all.vtu"), "--quiet"});
        ASSERT_EQ(result.status, 0) << result.errors;
        const MeshData data = read_mesh_data(mesh);
        const MeshData metrics = read_mesh_data(folder.file("all.vtu"));
        const auto lines = lines_of(test::read_text(folder.file("all.csv")));
        ASSERT_EQ(lines.size(), data.elements.size() + 1);
        const auto names = cells_of(lines[0]);
        EXPECT_EQ(names.size(), 5U + 12U + 4U);
        for (const std::size_t id : {std::size_t{0}, data.elements.size() / 2, data.elements.size() - 1}) {
            const auto cells = cells_of(lines[id + 1]);
            ASSERT_EQ(cells.size(), names.size());
            EXPECT_EQ(cells[0], std::to_string(id));
            for (std::size_t c = 5; c < names.size(); ++c) {
                const Field* field = find_field(metrics.fields, names[c], FieldLocation::element);
                ASSERT_NE(field, nullptr) << names[c];
                const double value = field->values(static_cast<Index>(id), 0);
                if (cells[c].empty())
                    EXPECT_TRUE(std::isnan(value)) << names[c];
                else
                    EXPECT_EQ(value, std::stod(cells[c])) << names[c];
            }
        }
    }
}

TEST(MorphQuality, TellsTheWorstElementsWithTheirPlace)
{
    const TemporaryFolder folder;
    const MeshData data = shaken("naca0012_lam_hybrid.su2", 1e-3, folder.file("moved.su2"));
    const ProcessResult result =
        quality({folder.file("moved.su2"), "--json", folder.file("r.json"), "--csv", folder.file("all.csv")});
    ASSERT_EQ(result.status, 3) << result.errors;
    const json report = json::parse(test::read_text(folder.file("r.json")));
    const auto lines = lines_of(test::read_text(folder.file("all.csv")));
    std::vector<std::pair<double, Index>> ranked;
    for (std::size_t id = 0; id < data.elements.size(); ++id)
        ranked.emplace_back(std::stod(cells_of(lines[id + 1])[7]), static_cast<Index>(id));
    std::sort(ranked.begin(), ranked.end());
    ASSERT_EQ(report["worst"].size(), 10U);
    for (std::size_t i = 0; i < 10; ++i) {
        const json& worst = report["worst"][i];
        const Element& element = data.elements[worst["id"].get<std::size_t>()];
        const int corners = corner_count(element);
        EXPECT_EQ(worst["id"], ranked[i].second);
        EXPECT_EQ(worst["scaled_jacobian"], ranked[i].first);
        EXPECT_EQ(worst["type"], corners == 3 ? "triangle" : "quad");
        EXPECT_EQ(worst["corner_jacobians"].size(), static_cast<std::size_t>(corners));
        EXPECT_EQ(worst["inverted"], true);
        double x = 0;
        for (int k = 0; k < corners; ++k)
            x += data.points(element[static_cast<std::size_t>(k)], 0) / corners;
        EXPECT_NEAR(worst["centroid"][0], x, 1e-12);
        EXPECT_EQ(worst["nearest_marker"], "airfoil"); // its cells are far smaller than the shaking
        EXPECT_THAT(result.output, HasSubstr(std::to_string(ranked[i].second) + " "));
    }
}

TEST(MorphQuality, CountsEveryElementInItsHistograms)
{
    const TemporaryFolder folder;
    const MeshData data = shaken("naca0012_inv.su2", 1e-3, folder.file("moved.su2"));
    const ProcessResult result = quality({folder.file("moved.su2"), "--json", folder.file("r.json")});
    const json report = json::parse(test::read_text(folder.file("r.json")));
    for (const char* metric : {"scaled_jacobian", "min_angle"}) {
        const json histogram = report["histograms"][metric];
        EXPECT_EQ(histogram["edges"].size(), histogram["counts"].size() + 1);
        std::size_t counted = report["inverted"];
        for (const json& count : histogram["counts"])
            counted += count.get<std::size_t>();
        EXPECT_EQ(counted, data.elements.size());
    }
    const std::string inverted = report["inverted"].dump();
    EXPECT_THAT(result.output, HasSubstr("inverted" + std::string(10 - inverted.size(), ' ') + inverted));
    EXPECT_THAT(result.output, HasSubstr("0.9 to   1"));
    EXPECT_THAT(result.output, HasSubstr(std::string(40, '#') + "\n"));
}

TEST(MorphQuality, TellsWhatAMoveDidToTheCellsBesideTheWalls)
{
    const TemporaryFolder folder;
    MeshData mesh = test::quad_square(4);
    for (Index v = 0; v < mesh.points.rows(); ++v) // an even grid
        mesh.points.row(v) << 0.25 * (v % 5), 0.25 * std::floor(v / 5.0), 0;
    write_mesh_data(mesh, folder.file("before.su2"));
    mesh.points.col(1) *= 0.9;
    mesh.points.col(0) += mesh.points.col(1); // a shear of 45 degrees
    write_mesh_data(mesh, folder.file("after.su2"));
    const ProcessResult result = quality({folder.file("after.su2"), "--reference", folder.file("before.su2"),
                                          "--json", folder.file("r.json")});
    ASSERT_EQ(result.status, 0) << result.errors;
    constexpr double kTol = 1e-12; // coordinates of size one pass through a file that holds all digits
    const json walls = json::parse(test::read_text(folder.file("r.json")))["walls"];
    ASSERT_EQ(walls.size(), 4U);
    for (const json& wall : walls) {
        if (wall["marker"] != "bottom" && wall["marker"] != "top")
            continue;
        EXPECT_EQ(wall["cells"], 4);
        EXPECT_NEAR(wall["first_cell_height"]["mean"], 0.225, kTol);
        EXPECT_NEAR(wall["orthogonality"]["max"], 45, kTol * 90);
        EXPECT_NEAR(wall["height_change"]["max"], 0.1, kTol);
        EXPECT_NEAR(wall["orthogonality_change"]["max"], 45, kTol * 90);
    }
    EXPECT_THAT(result.output, HasSubstr("next to bottom: first cells 0.225 to 0.225 high"));
    EXPECT_THAT(result.output, HasSubstr("changed at most by 10 % (element "));
}

TEST(MorphQuality, DrawsTheWorstSpotOfAValidMeshToo)
{
    const TemporaryFolder folder;
    const ProcessResult result = quality({real("naca0012_inv.su2"), "--picture", folder.file("worst.svg")});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(test::read_text(folder.file("worst.svg")), testing::StartsWith("<?xml"));
    ASSERT_EQ(quality({real("naca0012_inv.su2"), "--picture", folder.file("worst.png")}).status, 0);
    const std::string png = test::read_text(folder.file("worst.png"));
    EXPECT_THAT(png, testing::StartsWith("\x89PNG"));
    // Two panels side by side are 2100 pixels wide; one alone would have 1600.
    EXPECT_EQ(png.substr(16, 4), std::string("\0\0\x08\x34", 4));
    const ProcessResult refused = quality({real("naca0012_inv.su2"), "--picture", folder.file("worst.gif")});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, HasSubstr("written as .png or .svg, not '.gif'"));
}

TEST(MorphQuality, SaysBothCountsWhenTheReferenceIsAnotherMesh)
{
    const ProcessResult result =
        quality({real("naca0012_inv.su2"), "--reference", real("cylinder_lam.su2"), "--json", "-"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("has 13336 vertices and 26192 elements"));
    EXPECT_THAT(result.errors, HasSubstr("has 5233 vertices and 10216 elements"));
    EXPECT_EQ(result.output, "");
}

TEST(MorphQuality, RefusesAReferenceWithOtherElements)
{
    const TemporaryFolder folder;
    MeshData mesh = test::uneven_square(3);
    write_mesh_data(mesh, folder.file("mesh.su2"));
    std::swap(mesh.elements[2], mesh.elements[5]);
    write_mesh_data(mesh, folder.file("other.su2"));
    const ProcessResult result = quality({folder.file("mesh.su2"), "--reference", folder.file("other.su2")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("element 2 has other vertices"));
}

TEST(MorphQuality, LeavesNoFileWhenItFails)
{
    const TemporaryFolder folder;
    const std::string broken = folder.write("broken.su2", "NDIME= 2\nNPOIN= 3\n0 0\n1 0\n");
    const ProcessResult result = quality({broken, "--list", folder.file("bad.csv"), "--vtu",
                                          folder.file("metrics.vtu"), "--json", folder.file("report.json")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("broken.su2"));
    EXPECT_THAT(folder.names(), ElementsAre("broken.su2"));
}

TEST(MorphQuality, NamesAPlaceThatCannotBeWritten)
{
    const TemporaryFolder folder;
    const ProcessResult result =
        quality({real("naca0012_inv.su2"), "--list", folder.file("no/such/folder/bad.csv")});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("bad.csv"));
    EXPECT_TRUE(folder.names().empty());
}

TEST(MorphQuality, TellsWrongUsage)
{
    EXPECT_EQ(quality({}).status, 2);
    const ProcessResult result = quality({real("naca0012_inv.su2"), "--referense", "x.su2"});
    EXPECT_EQ(result.status, 2);
    EXPECT_THAT(result.errors, HasSubstr("did you mean '--reference'?"));
}

} // namespace
} // namespace morph
