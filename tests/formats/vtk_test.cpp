#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::rich_meshes;
using test::written;
using testing::HasSubstr;

TEST(Vtk, BinaryFilesHoldEverythingBitForBit)
{
    for (const auto& [name, mesh] : rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtk"), "vtk")), "") << name;
}

TEST(Vtk, AsciiFilesHoldEverythingBitForBit)
{
    for (const auto& [name, mesh] : rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtk", {.binary = false}), "vtk")), "") << name;
}

TEST(Vtk, SurvivesMutatedFiles)
{
    const MeshData mesh = rich_meshes()[4].second;
    test::survive_mutations("vtk", {written(mesh, "vtk"), written(mesh, "vtk", {.binary = false})}, 600);
}

/// Every kind of field of the older files, without names of markers.
const std::string kVtk =
    "# vtk DataFile Version 2.0\r\nmade by hand\nASCII\nDATASET UNSTRUCTURED_GRID\n\n"
    "points 5 FLOAT\n0 0 0  1 0 0\t1 1 0\n\n0 1 0 +2 5e-1 0\n"
    "CELLS 4 16\n2 0 1\n4 0 1 2 3\n3 1 4 2\n3 1 4 2\nCELL_TYPES 4\n3 9 5 4\n"
    "CELL_DATA 4\nSCALARS marker int\nLOOKUP_TABLE default\n-7 0 0 12\n"
    "LOOKUP_TABLE own 2\n0 0 0 1 1 1 1 1\n"
    "POINT_DATA 5\nSCALARS two%20words double 2\nLOOKUP_TABLE own\n1 nan 3 4 5 6 7 8 9 -inf\n"
    "METADATA\nINFORMATION 0\n\n"
    "VECTORS v float\n1 2 3 4 5 6 7 8 9 10 11 12 13 14 15\n"
    "NORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1 0 0 1\n"
    "TEXTURE_COORDINATES t 2 float\n0 0 0 0 0 0 0 0 0 0\n"
    "COLOR_SCALARS c 1\n0 .5 1 1 1\n"
    "FIELD more 2\na 1 5 unsigned_char\n1 2 3 4 5\nMETADATA\nINFORMATION 0\n\nb 2 5 long\n"
    "0 1 2 3 4 5 6 7 8 9\n";

TEST(Vtk, ReadsEveryKindOfField)
{
    const MeshData mesh = read_bytes(kVtk, "vtk");
    EXPECT_EQ(mesh.dimension, 2);
    EXPECT_EQ(mesh.points.row(4), Eigen::RowVector3d(2, 0.5, 0));
    EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 1, 2, 3}, {1, 4, 2, -1}}));
    ASSERT_EQ(mesh.markers.size(), 2U);
    EXPECT_EQ(mesh.markers[0].name, "-7");
    EXPECT_EQ(mesh.markers[1].edges, (std::vector<std::array<Index, 2>>{{1, 4}, {4, 2}}));
    std::vector<std::string> names;
    for (const Field& field : mesh.fields)
        names.push_back(field.name + std::to_string(field.values.cols()));
    EXPECT_THAT(names, testing::ElementsAre("marker1", "two words2", "v3", "n3", "t2", "c1", "a1", "b2"));
    EXPECT_TRUE(std::isnan(mesh.fields[1].values(0, 1)));
    EXPECT_EQ(mesh.fields[7].values(4, 1), 9);
}

TEST(Vtk, RealMeshesComeBackBitForBit)
{
    for (const std::string& path : test::real_meshes()) {
        const MeshData mesh = read_mesh_data(path);
        for (const bool binary : {true, false})
            EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtk", {.binary = binary}), "vtk")), "")
                << path;
    }
}

TEST(Vtk, TextMayDoWithoutALookupTable)
{
    EXPECT_EQ(refusal(replaced(kVtk, "LOOKUP_TABLE default\n", ""), "vtk"), "accepted");
}

TEST(Vtk, RefusesBrokenHeadersWithTheLine)
{
    const auto message = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kVtk, from, to), "vtk");
    };
    EXPECT_THAT(refusal("", "vtk"), HasSubstr("file:1: expected '# vtk DataFile Version x.y'"));
    EXPECT_THAT(message("# vtk", "# stl"), HasSubstr("file:1: expected '# vtk DataFile Version x.y'"));
    EXPECT_THAT(message("2.0", "9.0"), HasSubstr("but 1.0 to 5.1 are supported"));
    EXPECT_THAT(message("ASCII", "TEXT"), HasSubstr("file:3: expected ASCII or BINARY, found 'TEXT'"));
    EXPECT_THAT(message("UNSTRUCTURED_GRID", "STRUCTURED_POINTS"),
                HasSubstr("file:4: only data sets of the kinds UNSTRUCTURED_GRID, POLYDATA"));
    EXPECT_THAT(
        message("points 5", "pints 5"),
        HasSubstr(
            "file:6: expected a keyword of a legacy VTK file (is a count above it wrong?), found 'pints'"));
    EXPECT_THAT(message("points 5 FLOAT", "points 5 HALF"),
                HasSubstr("file:6: the type of the numbers is not one of those supported"));
}

TEST(Vtk, RefusesWhatDoesNotFitTogether)
{
    const auto message = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kVtk, from, to), "vtk");
    };
    EXPECT_THAT(message("points 5", "points 6"),
                HasSubstr("file:10: expected number 16 of 18, found 'CELLS'"));
    EXPECT_THAT(
        message("points 5", "points 4"),
        HasSubstr(
            "file:9: expected a keyword of a legacy VTK file (is a count above it wrong?), found '+2'"));
    EXPECT_THAT(message("points 5", "points 2000000000"),
                HasSubstr("file:6: 6000000000 numbers were expected"));
    EXPECT_THAT(message("points 5", "points -5"),
                HasSubstr("file:6: expected the number of points, found '-5'"));
    EXPECT_THAT(message("CELLS 4", "CELLS 5"), HasSubstr("the list of 16 numbers ends within cell 4 of 5"));
    EXPECT_THAT(message("CELLS 4", "CELLS 3"), HasSubstr("the 3 cells take 12 numbers, but the list has 16"));
    EXPECT_THAT(message("CELLS 4 16", "CELLS 2000000000 16"), HasSubstr("ends within cell 4 of 2000000000"));
    EXPECT_THAT(message("\n4 0 1", "\n99 0 1"), HasSubstr("ends within cell 1"));
    EXPECT_THAT(message("3 1 4 2\n", "3 1 5 2\n"), HasSubstr("cell 2 names point 5, but the mesh has 5"));
    EXPECT_THAT(message("3 1 4 2\n", "3 1 -1 2\n"), HasSubstr("cell 2 names point that is no index"));
    EXPECT_THAT(message("CELL_TYPES 4\n3 9", "CELL_TYPES 4\n3 10"),
                HasSubstr("file: holds a volume mesh of 1 cells; --surface takes its boundary"));
    EXPECT_THAT(message("CELL_TYPES 4\n3 9", "CELL_TYPES 4\n3 24"),
                HasSubstr("cell 1 is a quadratic tetrahedron (type 24)"));
    EXPECT_THAT(message("CELL_TYPES 4\n3 9 5 4", "CELL_TYPES 3\n3 9 5"),
                HasSubstr("CELL_DATA is for 4 cells, but the mesh has 3"));
    EXPECT_THAT(message("5e-1", "inf"), HasSubstr("point 4 has a coordinate that is not finite"));
    EXPECT_THAT(
        message("CELL_DATA 4", "CELL_DATA 3"),
        HasSubstr(
            "file:20: expected a keyword of a legacy VTK file (is a count above it wrong?), found '12'"));
    EXPECT_THAT(message("a 1 5", "a 1 6"), HasSubstr("array 'a' has 6 rows, expected 5"));
    EXPECT_THAT(message("b 2 5", "b 12 5"), HasSubstr("field 'b' has 12 components, but 1 to 9"));
    EXPECT_THAT(message("unsigned_char", "bit"),
                HasSubstr("the type of the numbers is not one of those supported"));
    EXPECT_THAT(message("POINT_DATA 5\nSCALARS", "SCALARS"), HasSubstr("file:25: expected a keyword"));
    EXPECT_THAT(refusal(kVtk.substr(0, kVtk.size() - 4), "vtk"),
                HasSubstr("10 numbers were expected, but only"));
}

TEST(Vtk, RefusesBrokenBinaryFiles)
{
    const std::string vtk = written(test::quad_square(1), "vtk");
    EXPECT_THAT(refusal(vtk.substr(0, vtk.find("CELLS") - 20), "vtk"),
                HasSubstr("12 numbers of 8 bytes each"));
    EXPECT_THAT(refusal(replaced(vtk, "POINTS 4", "POINTS 2147483647"), "vtk"),
                HasSubstr("6442450941 numbers of 8 bytes"));
    EXPECT_THAT(refusal(replaced(vtk, "POINTS 4", "POINTS 3"), "vtk"),
                HasSubstr("expected a keyword of a legacy VTK file"));
    EXPECT_THAT(refusal(replaced(vtk, "4 string", "2147483647 string"), "vtk"),
                HasSubstr("2147483647 strings were expected"));
    std::string broken = vtk;
    broken.replace(vtk.find("bottom") - 8, 8, "\x3f\xff\xff\xff\xff\xff\xff\xff");
    EXPECT_THAT(refusal(broken, "vtk"), HasSubstr("numbers of 1 bytes each were expected"));
    broken = vtk;
    broken.replace(vtk.find("double\n") + 7, 8, "\x7f\xf8\0\0\0\0\0\0", 8);
    EXPECT_THAT(refusal(broken, "vtk"), HasSubstr("point 0 has a coordinate that is not finite"));
}

} // namespace

} // namespace morph
