#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
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
    const ProcessResult one = quality({mesh, "--json", "-", "--threads", "1"});
    const ProcessResult three = quality({mesh, "--json", "-", "--threads", "3"});
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
