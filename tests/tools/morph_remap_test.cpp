#include "formats/formats.h"
#include "tests/support/errors.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace {

using namespace morph;
using test::run_tool;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

double linear(double x, double y)
{
    return 1 + 2 * x - y;
}

/// The mesh with a linear nodal field p, a vector field v and a field of the elements' numbers.
MeshData with_fields(MeshData mesh)
{
    Field p{"p", FieldLocation::vertex, Matrix(mesh.points.rows(), 1)};
    Field v{"v", FieldLocation::vertex, Matrix(mesh.points.rows(), 2)};
    for (Index i = 0; i < mesh.points.rows(); ++i) {
        p.values(i, 0) = linear(mesh.points(i, 0), mesh.points(i, 1));
        v.values.row(i) << mesh.points(i, 1), -mesh.points(i, 0);
    }
    Field cell{"cell", FieldLocation::element, Matrix(static_cast<Index>(mesh.elements.size()), 1)};
    for (Index e = 0; e < cell.values.rows(); ++e)
        cell.values(e, 0) = e;
    mesh.fields = {p, v, cell};
    return mesh;
}

class MorphRemap : public ::testing::Test {
protected:
    MorphRemap()
    {
        write_mesh_data(with_fields(test::uneven_square(8)), source_);
        write_mesh_data(test::quad_square(5), target_);
    }

    test::ProcessResult remap(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.end(), {"--json", folder_.file("report.json")});
        return run_tool("morph-remap", arguments);
    }

    nlohmann::json report() const
    {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    }

    /// The error line of a run that must fail and leave no file.
    std::string refusal(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.end(), {"-o", folder_.file("never.vtu")});
        const auto before = folder_.names();
        const auto result = run_tool("morph-remap", arguments);
        EXPECT_EQ(result.status, 1) << result.errors;
        EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
        EXPECT_EQ(folder_.names(), before);
        return result.errors;
    }

    TemporaryFolder folder_;
    std::string source_ = folder_.file("source.vtu");
    std::string target_ = folder_.file("target.su2");
};

TEST_F(MorphRemap, CarriesEveryFieldAndKeepsTheTargetAsItIs)
{
    const std::string out = folder_.file("out.vtu");
    const auto result = remap({source_, target_, "-o", out});
    ASSERT_EQ(result.status, 0) << result.errors;
    MeshData carried = read_mesh_data(out);
    const MeshData target = read_mesh_data(target_);
    const Field* p = find_field(carried.fields, "p", FieldLocation::vertex);
    const Field* v = find_field(carried.fields, "v", FieldLocation::vertex);
    const Field* status = find_field(carried.fields, "remap_status", FieldLocation::vertex);
    ASSERT_TRUE(p && v && status && find_field(carried.fields, "cell", FieldLocation::element));
    EXPECT_EQ(status->values, Matrix::Zero(target.points.rows(), 1));
    for (Index i = 0; i < target.points.rows(); ++i) {
        EXPECT_NEAR(p->values(i, 0), linear(target.points(i, 0), target.points(i, 1)), 1e-13);
        EXPECT_NEAR(v->values(i, 1), -target.points(i, 0), 1e-13);
    }
    carried.fields.clear();
    EXPECT_EQ(test::difference(carried, target), "");
}

TEST_F(MorphRemap, ReportsCountsRangesAndSeconds)
{
    ASSERT_EQ(remap({source_, target_, "-o", folder_.file("out.vtu")}).status, 0);
    const auto json = report();
    EXPECT_EQ(json["targets"], 36);
    EXPECT_EQ(json["inside"], 36);
    EXPECT_EQ(json["outside"], 0);
    EXPECT_EQ(json["fields"], nlohmann::json({"p", "v", "cell"}));
    EXPECT_EQ(json["elements"]["inside"], 25);
    EXPECT_DOUBLE_EQ(json["changes"][0]["source"]["max"][0], 3);
    EXPECT_NEAR(json["changes"][0]["source"]["integral"][0], 1.5,
                1e-13); // of a linear function over the square
    EXPECT_NEAR(json["changes"][0]["target"]["integral"][0], 1.5, 1e-13);
    for (const char* stage : {"read", "locate", "interpolate", "write"})
        EXPECT_GE(json["seconds"][stage], 0.0) << stage;
}

TEST_F(MorphRemap, TakesPointsAndWritesATable)
{
    const std::string probes = folder_.write("probes.csv", "x,y\n0.5,0.25\n1,1\n2,1\n0.5,0.25\n");
    const auto result =
        remap({source_, probes, "-o", folder_.file("out.csv"), "--fields", "p,v", "--outside", "project"});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(result.errors,
                HasSubstr("warning: 1 of 4 targets (25 %) lie outside the source, the farthest, "
                          "number 2 at (2, 1), by 1"));
    const std::string text = test::read_text(folder_.file("out.csv"));
    EXPECT_THAT(text, StartsWith("x,y,p,v_0,v_1,remap_status,remap_distance\n0.5,0.25,1.75"));
    const MeshData table = read_mesh_data(folder_.file("out.csv"));
    ASSERT_EQ(table.fields.size(), 4U);
    EXPECT_EQ(table.fields[0].values(2, 0), linear(1, 1));
    EXPECT_EQ(table.fields[0].values(3, 0), table.fields[0].values(0, 0));
    EXPECT_EQ(table.fields[2].values, (Matrix(4, 1) << 0, 0, 1, 0).finished());
    EXPECT_EQ(table.fields[3].values, (Matrix(4, 1) << 0, 0, 1, 0).finished());
    EXPECT_EQ(report()["farthest_outside"]["target"], 2);
}

TEST_F(MorphRemap, TurnsARestartFileIntoOneForTheTarget)
{
    const MeshData mesh = test::uneven_square(3);
    write_mesh_data(mesh, folder_.file("coarse.su2"));
    std::string restart = "\"PointID\",\"x\",\"y\",\"Density\",\"Momentum_x\"\n";
    for (Index v = static_cast<Index>(mesh.points.rows()); v-- > 0;) { // rows in any order
        const double x = mesh.points(v, 0), y = mesh.points(v, 1);
        std::array<char, 200> line{};
        std::snprintf(line.data(), line.size(), "%d, %.17e, %.17e, %.17e, %.17e\n", v, x, y, linear(x, y), x);
        restart += line.data();
    }
    const std::string fields = folder_.write("restart_flow.csv", restart + "AOA= 1.25\n");
    const auto result = remap(
        {folder_.file("coarse.su2"), target_, "--source-fields", fields, "-o", folder_.file("restart.csv")});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(result.errors, "");
    EXPECT_THAT(
        test::read_text(folder_.file("restart.csv")),
        StartsWith("\"PointID\",\"x\",\"y\",\"Density\",\"Momentum_x\",\"remap_status\"\n0,0,0,1,0,0\n1,"));
    const MeshData carried = read_mesh_data(folder_.file("restart.csv"), "su2_restart");
    for (Index v = 0; v < carried.points.rows(); ++v)
        EXPECT_NEAR(carried.fields[0].values(v, 0), linear(carried.points(v, 0), carried.points(v, 1)),
                    1e-13);
}

TEST_F(MorphRemap, ReadsAndWritesTheFilesOfTheThesis)
{
    ASSERT_EQ(remap({source_, target_, "-o", folder_.file("out.txt"), "--fields", "p"}).status, 0);
    EXPECT_THAT(folder_.names(), ::testing::IsSupersetOf(
                                     {"out.txt", "out.neighbours.txt", "out.p.txt", "out.remap_status.txt"}));
    folder_.write("destinations.txt", "2\n0.5 0.5\n0.25 1\n");
    const auto result = remap({folder_.file("out.txt"), folder_.file("destinations.txt"), "--source-fields",
                               folder_.file("out.p.txt"), "--source-neighbors",
                               folder_.file("out.neighbours.txt"), "-o", folder_.file("values.csv")});
    ASSERT_EQ(result.status, 0) << result.errors;
    const MeshData values = read_mesh_data(folder_.file("values.csv"));
    EXPECT_EQ(values.fields[0].name, "f");
    EXPECT_NEAR(values.fields[0].values(0, 0), linear(0.5, 0.5), 1e-13);
    EXPECT_NEAR(values.fields[0].values(1, 0), linear(0.25, 1), 1e-13);
}

TEST_F(MorphRemap, KeepsIntegralsWhenAskedTo)
{
    const auto result =
        remap({source_, target_, "-o", folder_.file("out.vtu"), "--conservative", "--cells", "conservative"});
    ASSERT_EQ(result.status, 0) << result.errors;
    const auto json = report();
    EXPECT_NEAR(json["nodal_conservation"]["common_area"], 1, 1e-13);
    EXPECT_EQ(json["nodal_conservation"]["uncovered_vertices"], 0);
    EXPECT_EQ(json["element_conservation"]["uncovered_target_area"], 0);
    const auto& cell = json["element_conservation"]["fields"][0];
    EXPECT_NEAR(cell["source_integral"][0], cell["target_integral"][0], 1e-12 * 128);
    // On meshes that cover the same square the whole integrals agree as well.
    const auto& change = json["changes"][2];
    EXPECT_NEAR(change["source"]["integral"][0], change["target"]["integral"][0], 1e-12 * 128);
}

TEST_F(MorphRemap, GivesTheSameBytesForAnyNumberOfThreads)
{
    for (const std::string mode : {"--quads=split", "--conservative"}) {
        const std::string one = folder_.file("one.vtu"), three = folder_.file("three.vtu");
        ASSERT_EQ(remap({source_, target_, "-o", one, mode, "--threads", "1"}).status, 0);
        ASSERT_EQ(remap({source_, target_, "-o", three, mode, "--threads", "3"}).status, 0);
        EXPECT_EQ(test::read_text(one), test::read_text(three));
    }
}

TEST_F(MorphRemap, GivesEveryBitBackOnTheSameMesh)
{
    ASSERT_EQ(remap({source_, source_, "-o", folder_.file("same.vtu")}).status, 0);
    MeshData same = read_mesh_data(folder_.file("same.vtu"));
    std::erase_if(same.fields, [](const Field& field) { return field.name == "remap_status"; });
    MeshData source = read_mesh_data(source_);
    const auto by_name = [](const Field& a, const Field& b) { return a.name < b.name; };
    std::sort(same.fields.begin(), same.fields.end(), by_name);
    std::sort(source.fields.begin(), source.fields.end(), by_name);
    EXPECT_EQ(test::difference(same, source), "");
}

TEST_F(MorphRemap, CarriesAlongRealMeshes)
{
    for (const std::string& path : test::real_meshes()) {
        MeshData mesh = read_mesh_data(path);
        const std::string fields = folder_.file("real.vtu");
        write_mesh_data(with_fields(mesh), fields);
        const auto result = remap({fields, path, "-o", folder_.file("real_out.vtu"), "--quiet"});
        ASSERT_EQ(result.status, 0) << path << result.errors;
        const auto json = report();
        EXPECT_EQ(json["outside"], 0) << path;
        EXPECT_EQ(json["elements"]["outside"], 0) << path;
        const MeshData carried = read_mesh_data(folder_.file("real_out.vtu"));
        EXPECT_EQ(find_field(carried.fields, "p", FieldLocation::vertex)->values,
                  find_field(with_fields(mesh).fields, "p", FieldLocation::vertex)->values)
            << path;
        const Matrix& cells = find_field(carried.fields, "cell", FieldLocation::element)->values;
        for (Index e = 0; e < cells.rows(); ++e)
            ASSERT_EQ(cells(e, 0), e) << path;
    }
}

TEST_F(MorphRemap, ProjectsOnSurfacesByDefaultAndTellsTheDistance)
{
    MeshData tilted = with_fields(test::uneven_square(6));
    tilted.dimension = 3;
    tilted.points.col(2) = tilted.points.col(0);
    write_mesh_data(tilted, folder_.file("tilted.vtu"));
    const std::string probes = folder_.write("probes.csv", "x,y,z\n0.25,0.5,0.75\n0.5,0.5,0.5\n");
    ASSERT_EQ(remap({folder_.file("tilted.vtu"), probes, "-o", folder_.file("out.csv")}).status, 0);
    const MeshData table = read_mesh_data(folder_.file("out.csv"));
    const Field* distance = find_field(table.fields, "remap_distance", FieldLocation::vertex);
    ASSERT_TRUE(distance);
    EXPECT_NEAR(distance->values(0, 0), std::sqrt(0.125), 1e-14);
    EXPECT_NEAR(distance->values(1, 0), 0, 1e-14);
    EXPECT_NEAR(table.fields[0].values(0, 0), linear(0.5, 0.5), 1e-13);
}

TEST_F(MorphRemap, SaysWhatIsWrongInOneLineAndWritesNothing)
{
    EXPECT_THAT(refusal({source_, target_, "--fields", "p,q"}),
                HasSubstr("source.vtu: has no field 'q', but p, v, cell; did you mean 'p'?"));
    EXPECT_THAT(refusal({target_, target_}),
                HasSubstr("target.su2: has no fields to carry; --source-fields"));
    EXPECT_THAT(refusal({target_, target_, "--source-fields", source_}),
                HasSubstr("source.vtu: holds fields of 81 vertices, but the mesh has 36"));
    folder_.write("far.csv", "x,y\n100,100\n");
    EXPECT_THAT(refusal({source_, folder_.file("far.csv")}),
                HasSubstr("none of the 1 targets lies in the source"));
    folder_.write("near.csv", "x,y\n0.5,0.5\n1.5,0.5\n");
    EXPECT_THAT(refusal({source_, folder_.file("near.csv"), "--outside", "fail"}),
                HasSubstr("1 of 2 targets lie outside the source, the farthest at (1.5, 0.5) by 0.5"));
    EXPECT_THAT(refusal({source_, folder_.file("near.csv"), "--conservative"}),
                HasSubstr("the target has no elements"));
    EXPECT_THAT(refusal({source_, folder_.file("missing.su2")}), HasSubstr("missing.su2: cannot be read"));
    folder_.write("cut.vtu", test::read_text(source_).substr(0, 700));
    EXPECT_THAT(refusal({folder_.file("cut.vtu"), target_}), HasSubstr("cut.vtu:"));
    folder_.write("nan.csv", "PointID,x,y,p\n0,0,0,nan\n");
    EXPECT_THAT(refusal({source_, target_, "--source-fields", folder_.file("nan.csv")}),
                HasSubstr("nan.csv:2: "));
    EXPECT_THAT(refusal({folder_.file("near.csv"), target_}), HasSubstr("near.csv: has no fields to carry"));
    folder_.write("points.csv", "x,y,p\n0.5,0.5,1\n");
    EXPECT_THAT(refusal({folder_.file("points.csv"), target_}),
                HasSubstr("the source has no element to take values from"));
}

TEST_F(MorphRemap, NamesTheVertexOfAValueThatIsNotANumber)
{
    MeshData mesh = with_fields(test::uneven_square(2));
    mesh.fields[0].values(5, 0) = NAN;
    write_mesh_data(mesh, folder_.file("nan.vtu"));
    EXPECT_THAT(refusal({folder_.file("nan.vtu"), target_}),
                HasSubstr("field 'p' of the source is not finite at vertex 5"));
}

TEST_F(MorphRemap, TellsWrongUsage)
{
    EXPECT_EQ(run_tool("morph-remap", {source_}).status, 2);
    EXPECT_EQ(remap({source_, target_, "-o", folder_.file("x.vtu"), "--outside", "guess"}).status, 2);
    EXPECT_EQ(remap({source_, target_, "-o", folder_.file("x.vtu"), "--power", "-1"}).status, 2);
    const auto unknown = remap({source_, target_, "-o", folder_.file("x.vtu"), "--neighbours", "3"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.errors, HasSubstr("did you mean '--neighbors'?"));
}

// Weights of the thesis's second case, solved on a coarse mesh and carried to a finer one.
class CarryOver : public ::testing::Test {
protected:
    CarryOver()
    {
        const std::string text = test::read_text(test::example_path("02_thesis_case2/case.toml"));
        coarse_ = folder_.write("coarse.toml", text);
        std::string refined = text;
        for (std::size_t at = 0; (at = refined.find("nodes = 100", at)) != std::string::npos; ++at)
            refined.replace(at, 11, "nodes = 200");
        folder_.write("refined.toml", refined);
        EXPECT_EQ(
            run_tool("morph-mesh", {folder_.file("refined.toml"), "-o", folder_.file("fine.su2")}).status, 0);
        std::string on_file = text;
        const std::size_t generate = on_file.find("generate");
        on_file.replace(generate, on_file.find('\n', generate) - generate, "file = \"fine.su2\"");
        fine_ = folder_.write("fine.toml", on_file);
    }

    Points moved(const std::vector<std::string>& more)
    {
        std::vector<std::string> arguments{fine_, "-o", folder_.file("moved.su2"), "--json",
                                           folder_.file("report.json")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto result = run_tool("morph-deform", arguments);
        EXPECT_TRUE(result.status == 0 || result.status == 3) << result.errors;
        return read_mesh_data(folder_.file("moved.su2")).points;
    }

    TemporaryFolder folder_;
    std::string coarse_, fine_;
};

TEST_F(CarryOver, WeightsOfACoarseMeshMoveAFineOneAndLandOnTheCurve)
{
    const auto saved = run_tool("morph-deform", {coarse_, "-o", folder_.file("coarse.su2"), "--save-weights",
                                                 folder_.file("weights.vtu")});
    ASSERT_TRUE(saved.status == 0 || saved.status == 3) << saved.errors;
    const auto carried = run_tool("morph-remap", {folder_.file("weights.vtu"), folder_.file("fine.su2"), "-o",
                                                  folder_.file("fine_weights.vtu"), "--quiet"});
    ASSERT_EQ(carried.status, 0) << carried.errors;

    const Points before = read_mesh_data(folder_.file("fine.su2")).points;
    const Points by_carried = moved({"--weights", folder_.file("fine_weights.vtu")});
    const auto report = nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    for (const auto& boundary : report["boundaries"])
        EXPECT_LT(boundary["landing_error"], 1e-12); // nodes of the curves have the curve's own weights
    const Points by_solved = moved({});
    const double largest = (by_solved - before).rowwise().norm().maxCoeff();
    const double difference = (by_carried - by_solved).rowwise().norm().maxCoeff();
    EXPECT_GT(difference, 0); // they are not the weights of the fine mesh
    EXPECT_LT(difference, 0.02 * largest);
}

} // namespace
