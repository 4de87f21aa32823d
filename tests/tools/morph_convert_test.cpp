#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace {

using namespace morph;
using test::difference;
using test::run_tool;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class MorphConvert : public ::testing::Test {
protected:
    MorphConvert() { write_mesh_data(mesh_, in_); }

    test::ProcessResult convert(std::vector<std::string> arguments)
    {
        arguments.insert(arguments.end(), {"--json", folder_.file("report.json")});
        return run_tool("morph-convert", arguments);
    }

    nlohmann::json report() const
    {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    }

    MeshData converted(std::vector<std::string> options)
    {
        const std::string out = folder_.file("out.vtu");
        options.insert(options.begin(), {in_, out});
        const test::ProcessResult result = convert(options);
        EXPECT_EQ(result.status, 0) << result.errors;
        return read_mesh_data(out);
    }

    static MeshData hybrid_with_fields()
    {
        MeshData mesh = test::quad_square(3);
        mesh.elements.push_back({0, 1, 5, -1});
        mesh.elements.erase(mesh.elements.begin());
        mesh.elements.push_back({0, 5, 4, -1});
        const auto elements = static_cast<Index>(mesh.elements.size());
        mesh.fields = {{"p", FieldLocation::vertex, Matrix::Random(mesh.points.rows(), 1)},
                       {"T", FieldLocation::element, Matrix::Random(elements, 2)}};
        return mesh;
    }

    test::TemporaryFolder folder_;
    MeshData mesh_ = hybrid_with_fields();
    std::string in_ = folder_.file("in.vtu");
};

TEST_F(MorphConvert, KeepsEverythingBitForBitWhereBothFormatsHoldIt)
{
    EXPECT_EQ(difference(converted({}), mesh_), "");
    EXPECT_EQ(difference(converted({"--ascii"}), mesh_), "");
    EXPECT_EQ(difference(converted({"--check"}), mesh_), "");
}

TEST_F(MorphConvert, NamesWhatTheNewFormatCannotHold)
{
    const test::ProcessResult result = convert({in_, folder_.file("out.su2")});
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.errors, AllOf(HasSubstr("out.su2: su2 cannot hold 1 nodal field(s) p"),
                                     HasSubstr("out.su2: su2 cannot hold 1 element field(s) T")));
    EXPECT_EQ(report()["warnings"].size(), 2U);
}

TEST_F(MorphConvert, ScalesThenTurnsThenMoves)
{
    const MeshData moved = converted({"--scale", "2,1", "--rotate", "90", "--translate", "10,0"});
    for (Index v = 0; v < mesh_.points.rows(); ++v) {
        EXPECT_EQ(moved.points(v, 0), 10 - mesh_.points(v, 1));
        EXPECT_EQ(moved.points(v, 1), 2 * mesh_.points(v, 0));
    }
    EXPECT_EQ(moved.dimension, 2);
    const MeshData upright = converted({"--rotate", "x:90"});
    EXPECT_EQ(upright.dimension, 3);
    EXPECT_EQ(upright.points.col(2), mesh_.points.col(1));
}

TEST_F(MorphConvert, SplitsQuads)
{
    const MeshData split = converted({"--triangulate"});
    EXPECT_EQ(split.elements.size(), mesh_.elements.size() + 8);
    for (const Element& element : split.elements)
        EXPECT_EQ(corner_count(element), 3);
    EXPECT_EQ(split.fields[1].values.rows(), static_cast<Index>(split.elements.size()));
}

TEST_F(MorphConvert, RenamesMarkersAllAtOnce)
{
    const MeshData renamed = converted({"--rename-marker", "left=right", "--rename-marker", "right=left"});
    EXPECT_EQ(find_marker(renamed.markers, "left")->edges, find_marker(mesh_.markers, "right")->edges);
    EXPECT_EQ(find_marker(renamed.markers, "right")->edges, find_marker(mesh_.markers, "left")->edges);
    const test::ProcessResult missing = convert({in_, folder_.file("x.vtu"), "--rename-marker", "lft=a"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_THAT(missing.errors, AllOf(HasSubstr("in.vtu: has no marker or group 'lft' to rename"),
                                      HasSubstr("did you mean 'left'?")));
    const test::ProcessResult taken = convert({in_, folder_.file("x.vtu"), "--rename-marker", "left=right"});
    EXPECT_EQ(taken.status, 1);
    EXPECT_THAT(taken.errors, HasSubstr("would have two markers 'right' after renaming"));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("x.vtu")));
}

TEST_F(MorphConvert, DropsFieldsByNameOrAll)
{
    const MeshData named = converted({"--drop-fields", "p"});
    ASSERT_EQ(named.fields.size(), 1U);
    EXPECT_EQ(named.fields[0].name, "T");
    EXPECT_TRUE(converted({"--drop-fields"}).fields.empty());
    EXPECT_TRUE(converted({"--drop-fields", "p,T"}).fields.empty());
    const test::ProcessResult missing = convert({in_, folder_.file("x.vtu"), "--drop-fields", "q"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_THAT(missing.errors, HasSubstr("in.vtu: has no field 'q' to drop, but p, T"));
}

TEST_F(MorphConvert, TakesFieldsFromARestartFileBesideTheMesh)
{
    const std::string mesh = folder_.file("mesh.su2");
    const std::string restart = folder_.file("restart.csv");
    MeshData bare = mesh_;
    bare.fields.clear();
    write_mesh_data(bare, mesh);
    ASSERT_EQ(convert({in_, restart, "--to", "su2_restart", "--drop-fields", "T"}).status, 0);
    const std::string out = folder_.file("out.vtu");
    ASSERT_EQ(convert({mesh, out, "--fields", restart}).status, 0);
    MeshData expected = mesh_;
    expected.fields.pop_back();
    EXPECT_EQ(difference(read_mesh_data(out), expected), "");
}

TEST_F(MorphConvert, MergesVerticesWithinTheTolerance)
{
    MeshData mesh = mesh_;
    mesh.points.conservativeResize(mesh.points.rows() + 1, 3);
    mesh.points.row(mesh.points.rows() - 1) = mesh.points.row(0);
    mesh.elements.back()[0] = static_cast<Index>(mesh.points.rows()) - 1;
    mesh.fields.clear();
    write_mesh_data(mesh, in_);
    EXPECT_EQ(converted({"--merge-tolerance", "1e-9"}).points, mesh_.points);
}

TEST_F(MorphConvert, ABatchGoesOnAfterABadFileAndSaysSo)
{
    const std::string bad = folder_.write("bad.su2", "NDIME= 7\n");
    const std::string good = test::real_meshes().front();
    std::filesystem::create_directory(folder_.file("into"));
    const test::ProcessResult result =
        convert({in_, bad, good, "--into-dir", folder_.file("into"), "--to", "su2"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("bad.su2:1: "));
    EXPECT_THAT(result.output, HasSubstr("2 of 3 file(s) converted"));
    EXPECT_EQ(report()["failed"], 1);
    EXPECT_EQ(report()["files"].size(), 3U);
    EXPECT_FALSE(std::filesystem::exists(folder_.file("into/bad.su2")));
    const std::string out = folder_.file("into/") + std::filesystem::path(good).filename().string();
    EXPECT_EQ(difference(read_mesh_data(out), read_mesh_data(good)), "");
    EXPECT_EQ(convert({good, "--into-dir", folder_.file("into"), "--to", "vtu"}).status, 0);
}

TEST_F(MorphConvert, ABatchDoesNotWriteOneFileTwice)
{
    std::filesystem::create_directory(folder_.file("a"));
    std::filesystem::copy_file(in_, folder_.file("a/in.vtu"));
    std::filesystem::create_directory(folder_.file("into"));
    const test::ProcessResult result =
        convert({in_, folder_.file("a/in.vtu"), "--into-dir", folder_.file("into"), "--to", "vtk"});
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.errors, HasSubstr("into/in.vtk, as another input is"));
}

TEST_F(MorphConvert, TellsWhatAFileHolds)
{
    const test::ProcessResult result = convert({"--info", in_});
    EXPECT_EQ(result.status, 0);
    EXPECT_THAT(result.output, AllOf(HasSubstr("16 vertices, 2 triangles, 8 quads"),
                                     HasSubstr("from (0, 0) to (1, 1)"), HasSubstr("marker 'left': 3 edges"),
                                     HasSubstr("vertex field 'p': "), HasSubstr("element field 'T': ")));
    const nlohmann::json info = report()["files"][0];
    EXPECT_EQ(info["triangles"], 2);
    EXPECT_EQ(info["fields"][1]["ranges"][1][0], mesh_.fields[1].values.col(1).minCoeff());
    EXPECT_EQ(info["fields"][1]["ranges"][1][1], mesh_.fields[1].values.col(1).maxCoeff());
}

TEST_F(MorphConvert, ListsEveryFormat)
{
    const test::ProcessResult result = convert({"--list"});
    EXPECT_EQ(result.status, 0);
    for (const Format* format : all_formats())
        EXPECT_THAT(result.output,
                    AllOf(HasSubstr(std::string(format->name)), HasSubstr(std::string(format->description))));
    EXPECT_EQ(report()["formats"].size(), all_formats().size());
}

TEST_F(MorphConvert, TakesWhatNoHalfedgeStructureHoldsUnlessAskedToCheck)
{
    MeshData fins = test::uneven_square(1); // an edge of three triangles
    fins.dimension = 3;
    fins.points.conservativeResize(6, 3);
    fins.points.row(4) << 0.5, 0.5, 1;
    fins.points.row(5) << 0.5, 0.5, -1;
    fins.elements.push_back({fins.elements[0][0], fins.elements[0][1], 4, -1});
    fins.elements.push_back({fins.elements[0][0], fins.elements[0][1], 5, -1});
    fins.markers.clear();
    write_mesh_data(fins, in_);
    EXPECT_EQ(converted({}).elements, fins.elements);
    const test::ProcessResult checked = convert({in_, folder_.file("x.vtu"), "--check"});
    EXPECT_EQ(checked.status, 1);
    EXPECT_THAT(checked.errors, HasSubstr("in.vtu: "));
    EXPECT_FALSE(std::filesystem::exists(folder_.file("x.vtu")));
}

TEST_F(MorphConvert, WrongUsageIsToldApartFromBadInput)
{
    const std::string out = folder_.file("x.vtu");
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
        {{in_}, "expected IN and OUT, found 1 file(s)"},
        {{in_, out, in_}, "found 3 file(s)"},
        {{}, "found 0 file(s)"},
        {{"--info"}, "--info needs a file"},
        {{in_, "--into-dir", folder_.path()}, "--to NAME"},
        {{in_, out, "--scale", "0"}, "--scale needs one positive factor"},
        {{in_, out, "--scale", "1,2,3,4"}, "--scale needs"},
        {{in_, out, "--rotate", "w:3"}, "--rotate needs degrees"},
        {{in_, out, "--translate", "1"}, "--translate needs two or three lengths"},
        {{in_, out, "--merge-tolerance", "-1"}, "--merge-tolerance"},
        {{in_, out, "--rename-marker", "left"}, "--rename-marker needs OLD=NEW, not 'left'"},
        {{in_, folder_.file("x.su2"), "--binary"}, "--binary: su2 is written as text only"},
        {{in_, out, "--ascii", "--binary"}, "--ascii"},
        {{in_, out, "--trianglate"}, "did you mean '--triangulate'?"},
    };
    for (const auto& [arguments, message] : cases) {
        const test::ProcessResult result = convert(arguments);
        EXPECT_EQ(result.status, 2) << message;
        EXPECT_THAT(result.errors, HasSubstr(message));
    }
    EXPECT_EQ(folder_.names(), (std::vector<std::string>{"in.vtu"}));
}

TEST_F(MorphConvert, BadInputIsOneLineAndLeavesNoFile)
{
    const std::string bad =
        folder_.write("bad.su2", "NDIME= 2\nNELEM= 1\n5 0 1 7\nNPOIN= 3\n0 0\n1 0\n0 1\n");
    const test::ProcessResult result = convert({bad, folder_.file("x.vtu")});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1);
    EXPECT_THAT(result.errors, HasSubstr("bad.su2:3: "));
    EXPECT_EQ(convert({folder_.file("none.su2"), folder_.file("x.vtu")}).status, 1);
    EXPECT_THAT(folder_.names(), ElementsAre("bad.su2", "in.vtu"));
}

} // namespace
