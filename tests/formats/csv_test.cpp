// Points with nodal fields as comma-separated numbers, and SU2's restart file, which is such a table.
#include "formats/formats.h"
#include "tests/support/errors.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

using test::difference;
using test::message_of;
using test::read_bytes;
using test::refusal;
using test::TemporaryFolder;
using test::written;
using testing::ElementsAre;
using testing::IsEmpty;

/// The mesh without what a table of points has no place for.
MeshData points_and_nodal_fields(MeshData mesh)
{
    mesh.elements.clear();
    mesh.markers.clear();
    std::erase_if(mesh.fields, [](const Field& field) { return field.location == FieldLocation::element; });
    return mesh;
}

std::vector<std::string> field_names(const MeshData& mesh)
{
    std::vector<std::string> names;
    for (const Field& field : mesh.fields)
        names.push_back(field.name);
    return names;
}

MeshData one_point(std::vector<Field> fields)
{
    MeshData mesh;
    mesh.points = Points::Zero(1, 3);
    mesh.fields = std::move(fields);
    return mesh;
}

Field one_value(const std::string& name, Eigen::Index components = 1)
{
    return {name, FieldLocation::vertex, Matrix::Constant(1, components, 7)};
}

TEST(Csv, PointsAndNodalFieldsComeBackBitForBit)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        for (const std::string format : {"csv", "su2_restart"})
            EXPECT_EQ(difference(points_and_nodal_fields(mesh), read_bytes(written(mesh, format), format)),
                      "")
                << name << " as " << format;
}

TEST(Csv, NamesWithCommasQuotesAndOuterBlanksComeBack)
{
    for (const std::string name :
         {"a,b", "\"", "say \"hi\"", " T ", "\tT", "\"\",\"", "#", "Flügel", "v_1", "_0"})
        for (const std::string format : {"csv", "su2_restart"})
            EXPECT_THAT(field_names(read_bytes(written(one_point({one_value(name)}), format), format)),
                        ElementsAre(name))
                << format;
}

TEST(Csv, WritesTheShortestNumbersUnderPlainNames)
{
    MeshData mesh;
    mesh.points.resize(2, 3);
    mesh.points << 0, 0.1, 0, 1e22, -0.0, 0;
    Matrix velocity(2, 2);
    velocity << 1, 2, 3, 4.5;
    mesh.fields = {{"velocity", FieldLocation::vertex, velocity},
                   {"T", FieldLocation::vertex, Matrix::Constant(2, 1, 300)}};
    EXPECT_EQ(written(mesh, "csv"), "x,y,velocity_0,velocity_1,T\n0,0.1,1,2,300\n1e+22,-0,3,4.5,300\n");
    mesh.dimension = 3;
    mesh.fields.erase(mesh.fields.begin());
    EXPECT_EQ(written(mesh, "csv"), "x,y,z,T\n0,0.1,0,300\n1e+22,-0,0,300\n");
}

TEST(Csv, NamesWhatPointsCannotHold)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("out.csv");
    MeshData mesh = test::uneven_square(1);
    mesh.markers.resize(1);
    mesh.fields = {{"p", FieldLocation::element, Matrix::Zero(2, 1)}};
    EXPECT_THAT(write_mesh_data(mesh, path), ElementsAre(path + ": csv cannot hold 2 element(s)",
                                                         path + ": csv cannot hold 1 marker(s) bottom",
                                                         path + ": csv cannot hold 1 element field(s) p"));
    EXPECT_THAT(write_mesh_data(points_and_nodal_fields(mesh), path), IsEmpty());
}

TEST(Csv, RefusesFieldsWhoseColumnsWouldNotReadBack)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("out.csv");
    const auto message = [&](std::vector<Field> fields) {
        return message_of([&] { write_mesh_data(one_point(std::move(fields)), path); });
    };
    EXPECT_EQ(message({one_value("Z")}),
              path + ": csv cannot hold a field called 'Z', because the column z has a meaning of its own; "
                     "rename it");
    EXPECT_EQ(message({one_value("pointid")}),
              path +
                  ": csv cannot hold a field called 'pointid', because the column PointID has a meaning of "
                  "its own; rename it");
    EXPECT_EQ(message({one_value("v", 2), one_value("v_1")}),
              path + ": csv cannot hold two fields that both need the column 'v_1'; rename one");
    for (const std::string name : {"", "two\nlines", "two\rlines"})
        EXPECT_EQ(message({one_value(name)}),
                  path + ": csv cannot hold a field whose name is empty or has a line end; rename it");
    EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(Csv, ReadsCrLfTabsCommentsQuotesBlankLinesAndFortranExponents)
{
    const MeshData mesh = read_bytes("\xEF\xBB\xBF# by hand\r\n\r\n\"T\" ,\tY, \"a, b\",X\r\n"
                                     "1,\t2 , +3, -4D-1\r\n \t\r\n# half\r\n\"5\",1e-400,.5,8.\r\n",
                                     "csv");
    ASSERT_EQ(mesh.points.rows(), 2);
    EXPECT_EQ(mesh.dimension, 2);
    EXPECT_EQ(mesh.points, (Points(2, 3) << -0.4, 2, 0, 8, 0, 0).finished());
    ASSERT_THAT(field_names(mesh), ElementsAre("T", "a, b"));
    EXPECT_EQ(mesh.fields[0].values, (Matrix(2, 1) << 1, 5).finished());
    EXPECT_EQ(mesh.fields[1].values, (Matrix(2, 1) << 3, 0.5).finished());
}

TEST(Csv, IsPlanarUnlessSomeZIsNotZero)
{
    EXPECT_EQ(read_bytes("x,y,z\n1,2,0\n3,4,-0\n", "csv").dimension, 2);
    const MeshData surface = read_bytes("z,x,y\n0,1,2\n5,3,4\n", "csv");
    EXPECT_EQ(surface.dimension, 3);
    EXPECT_EQ(surface.points, (Points(2, 3) << 1, 2, 0, 3, 4, 5).finished());
}

TEST(Csv, ATableWithoutRowsIsAMeshWithoutPoints)
{
    const MeshData mesh = read_bytes("T,x,y,v_0,v_1", "csv");
    EXPECT_EQ(mesh.points.rows(), 0);
    ASSERT_THAT(field_names(mesh), ElementsAre("T", "v"));
    EXPECT_EQ(mesh.fields[1].values.rows(), 0);
    EXPECT_EQ(mesh.fields[1].values.cols(), 2);
}

TEST(Csv, NumberedColumnsThatFollowOneAnotherAreOneField)
{
    const MeshData mesh = read_bytes("x,v_0,v_1,v_2,y,w_0,T,w_1,u_1,u_2\n0,1,2,3,0,4,5,6,7,8\n", "csv");
    ASSERT_THAT(field_names(mesh), ElementsAre("v", "w_0", "T", "w_1", "u_1", "u_2"));
    EXPECT_EQ(mesh.fields[0].values, (Matrix(1, 3) << 1, 2, 3).finished());
    EXPECT_EQ(mesh.fields[1].values(0, 0), 4);
}

TEST(Csv, NumberedColumnsStaySingleWhenTheyAreMoreThanNineOrTheNameIsTaken)
{
    std::string header = "x,y";
    std::string row = "0,0";
    for (int c = 0; c < 10; ++c) {
        header += ",v_" + std::to_string(c);
        row += "," + std::to_string(c);
    }
    const MeshData ten = read_bytes(header + "\n" + row + "\n", "csv");
    ASSERT_EQ(ten.fields.size(), 10U);
    EXPECT_EQ(ten.fields[9].name, "v_9");
    EXPECT_EQ(ten.fields[9].values(0, 0), 9);
    EXPECT_THAT(field_names(read_bytes("x,y,v_0,v_1,v\n0,0,1,2,3\n", "csv")), ElementsAre("v_0", "v_1", "v"));
}

TEST(Csv, PointIdOrdersTheRows)
{
    const MeshData mesh = read_bytes("y,T,pointid,x\n10,100,2,1\n11,101,0,2\n12,102,1,3\n", "csv");
    EXPECT_EQ(mesh.points, (Points(3, 3) << 2, 11, 0, 3, 12, 0, 1, 10, 0).finished());
    ASSERT_THAT(field_names(mesh), ElementsAre("T"));
    EXPECT_EQ(mesh.fields[0].values, (Matrix(3, 1) << 101, 102, 100).finished());
}

TEST(Csv, EveryBrokenFileIsRefusedWithItsLine)
{
    const auto broken = [](const std::string& text) { return refusal(text, "csv"); };
    EXPECT_EQ(broken(""), "file: is empty, but a line of column names was expected");
    EXPECT_EQ(broken("\n# nothing\n"), "file: is empty, but a line of column names was expected");
    EXPECT_EQ(broken("# made by hand\nT,p\n1,2\n"),
              "file:2: has no columns x and y, which say where the points are, but T, p");
    EXPECT_EQ(broken("x;y;T\n"), "file:1: has no columns x and y, which say where the points are, but x;y;T");
    EXPECT_EQ(broken("x,T\n1,2\n"), "file:1: has a column x, but none y");
    EXPECT_EQ(broken("Y,T\n1,2\n"), "file:1: has a column y, but none x");
    EXPECT_EQ(broken("x,y,T,T\n"), "file:1: names the column 'T' twice");
    EXPECT_EQ(broken("x,y,X\n"),
              "file:1: has two columns 'x' and 'X', which are the same but for letter case");
    EXPECT_EQ(broken("x,y,\n1,2,3\n"), "file:1: column 3 has no name");
    EXPECT_EQ(broken("x,y\n1,2\n\n3\n"), "file:4: has 1 values, but the header names 2 columns");
    EXPECT_EQ(broken("x,y\n1,2,\n"), "file:2: has 3 values, but the header names 2 columns");
    EXPECT_EQ(broken("x,y\n1,2\n3,\n"), "file:3: column 'y' is '', but a finite number was expected");
    EXPECT_EQ(broken("x,y\n1,1e-3x\n"), "file:2: column 'y' is '1e-3x', but a finite number was expected");
    EXPECT_EQ(broken("x,y\n+-1,2\n"), "file:2: column 'x' is '+-1', but a finite number was expected");
    EXPECT_EQ(broken("x,y\n1,a\tb\x1b\n"), "file:2: column 'y' is 'a?b?', but a finite number was expected");
    for (const std::string text : {"nan", "NaN", "-inf", "1e999"})
        EXPECT_EQ(broken("x,y,T\n1,2,3\n4,5," + text + "\n"),
                  "file:3: column 'T' is '" + text + "', but a finite number was expected");
}

TEST(Csv, PointIdsThatAreNoNumberingAreRefusedWithTheirLine)
{
    const auto broken = [](const std::string& ids) { return refusal("PointID,x,y\n" + ids, "csv"); };
    EXPECT_EQ(broken("1,0,0\n2,0,0\n"),
              "file:3: PointID is 2, but the 2 row(s) must have the numbers from 0, each once");
    EXPECT_EQ(broken("0,0,0\n-1,0,0\n"),
              "file:3: PointID is -1, but the 2 row(s) must have the numbers from 0, each once");
    EXPECT_EQ(broken("0.5,0,0\n"),
              "file:2: PointID is 0.5, but the 1 row(s) must have the numbers from 0, each once");
    EXPECT_EQ(broken("1,0,0\n0,0,0\n\n1,0,0\n"), "file:5: PointID 1 is there again, after line 2");
}

TEST(Csv, SurvivesMutatedFiles)
{
    const std::string small = "x,y,\"z\",v_0,v_1\n1,2,3,4,5e1\n# half\n6,7,8,9,+1D1\n";
    test::survive_mutations("csv", {small, written(test::rich_meshes()[0].second, "csv")}, 600);
    test::survive_mutations("su2_restart", {written(test::rich_meshes()[3].second, "su2_restart")}, 600);
}

/// The first lines of a restart file as SU2 8 writes it.
const std::string kRestart = "\"PointID\",\"x\",\"y\",\"Density\",\"Momentum_x\",\"Nu_Tilde\"\n"
                             "0, 1.000000000000000e+00, 0.000000000000000e+00, 1.1e+00, 1.2e+02, 1.3e-05\n"
                             "1, 5.000000000000000e-01, 2.500000000000000e-01, 2.1e+00, 2.2e+02, 2.3e-05\n";

TEST(Su2Restart, ReadsWhatSu2Writes)
{
    const MeshData mesh = read_bytes(kRestart, "su2_restart");
    EXPECT_EQ(mesh.points, (Points(2, 3) << 1, 0, 0, 0.5, 0.25, 0).finished());
    ASSERT_THAT(field_names(mesh), ElementsAre("Density", "Momentum_x", "Nu_Tilde"));
    EXPECT_EQ(mesh.fields[2].values, (Matrix(2, 1) << 1.3e-5, 2.3e-5).finished());
    EXPECT_EQ(difference(read_bytes(kRestart, "csv"), mesh), "");
}

TEST(Su2Restart, PassesOverTheNotesOfOlderVersions)
{
    const std::string noted = kRestart + "AOA= 1.25\nDCD_DCL_VALUE= -0.5\n\nEXT_ITER= 250\n";
    EXPECT_EQ(difference(read_bytes(noted, "su2_restart"), read_bytes(kRestart, "su2_restart")), "");
    EXPECT_EQ(refusal("x,y\nAOA= 1.25\n", "csv"), "file:2: has 1 values, but the header names 2 columns");
}

TEST(Su2Restart, WritesIdsCoordinatesAndFieldsInTheirOrderUnderQuotedNames)
{
    MeshData mesh = read_bytes(kRestart, "su2_restart");
    mesh.fields.push_back({"remap_status", FieldLocation::vertex, Matrix::Zero(2, 1)});
    EXPECT_EQ(written(mesh, "su2_restart"),
              "\"PointID\",\"x\",\"y\",\"Density\",\"Momentum_x\",\"Nu_Tilde\",\"remap_status\"\n"
              "0,1,0,1.1,120,1.3e-05,0\n1,0.5,0.25,2.1,220,2.3e-05,0\n");
}

TEST(Su2Restart, HasPointIdsAndNoExtensionOfItsOwn)
{
    EXPECT_EQ(refusal("\nx,y,T\n1,2,3\n", "su2_restart"),
              "file:2: has no column PointID, which every SU2 restart file has");
    EXPECT_EQ(find_format("restart_flow.csv", "").name, "csv");
    EXPECT_EQ(find_format("restart_flow.csv", "su2_restart").name, "su2_restart");
}

} // namespace

} // namespace morph
