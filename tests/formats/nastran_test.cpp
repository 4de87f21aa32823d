// Nastran bulk data, by the MSC Nastran Quick Reference Guide.
#include "formats/formats.h"
#include "formats/nastran/write.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace morph;
using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::written;
using testing::ElementsAre;
using testing::IsEmpty;

using Edge = std::array<Index, 2>;

/// The unit square and a triangle to its right, a group and a marker. The tests below count its lines.
const std::string kSmall = "CEND\n"                                                                     // 1
                           "BEGIN BULK\n"                                                               // 2
                           "$ ungrouped 1\n"                                                            // 3
                           "$ group 2 wing\n"                                                           // 4
                           "$ marker 3 wall below\n"                                                    // 5
                           "GRID*                  1                              0.              0.\n" // 6
                           "*                     0.\n"                                                 // 7
                           "GRID*                  2                              1.              0.\n" // 8
                           "*                     0.\n"                                                 // 9
                           "GRID*                  3                              1.              1.\n" // 10
                           "*                     0.\n"                                                 // 11
                           "GRID*                  4                              0.              1.\n" // 12
                           "*                     0.\n"                                                 // 13
                           "GRID*                  5                              2.              .5\n" // 14
                           "*                     0.\n"                                                 // 15
                           "CQUAD4         1       2       1       2       3       4\n"                 // 16
                           "CTRIA3         2       1       2       5       3\n"                         // 17
                           "CROD           3       3       1       2\n"                                 // 18
                           "CROD           4       3       2       5\n"                                 // 19
                           "ENDDATA\n";

MeshData small_mesh()
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.markers = {{"wall below", {{0, 1}, {1, 4}}}};
    mesh.groups = {{"wing", {0}}};
    return mesh;
}

MeshData without_fields(MeshData mesh)
{
    mesh.fields.clear();
    return mesh;
}

MeshData read_with_notes(const std::string& text, ReadNotes& notes)
{
    return find_format("file", "nastran").read({"file", text, {}, &notes});
}

MeshData surface_of_volume(const std::string& text)
{
    return find_format("file", "nastran").read({"file", text, {.surface = true, .zone = ""}});
}

TEST(Nastran, WritesTheBytesOfTheSpecification)
{
    EXPECT_EQ(written(small_mesh(), "nastran"), kSmall);
}

TEST(Nastran, ReadsTheBytesOfTheSpecification)
{
    EXPECT_EQ(difference(read_bytes(kSmall, "nastran"), small_mesh()), "");
}

TEST(Nastran, HoldsEveryRichMeshBitForBitButForFields)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        EXPECT_EQ(difference(without_fields(mesh), read_bytes(written(mesh, "nastran"), "nastran")), "")
            << name;
}

TEST(Nastran, ReadsWhatMeshioWrote)
{
    MeshData expected = test::square_and_triangle(0);
    expected.markers = {{"CBAR", {{0, 1}, {1, 4}}}};
    EXPECT_EQ(difference(read_mesh_data(test::data_path("nastran/meshio.bdf")), expected), "");
}

TEST(Nastran, ReadsTheSameMeshFromEveryFieldFormatOfGmsh)
{
    constexpr double small_field = 1e-6; // eight columns hold six digits behind the point
    const MeshData large = read_mesh_data(test::data_path("nastran/gmsh_large.bdf"));
    EXPECT_EQ(large.elements.size(), 14U);
    ASSERT_EQ(large.markers.size(), 4U);
    for (const Marker& marker : large.markers)
        EXPECT_EQ(marker.edges.size(), 2U);
    for (const char* other : {"nastran/gmsh_small.bdf", "nastran/gmsh_free.bdf"}) {
        const MeshData mesh = read_mesh_data(test::data_path(other));
        ASSERT_EQ(mesh.points.rows(), large.points.rows());
        EXPECT_LE((mesh.points - large.points).norm(), small_field * std::sqrt(12.0)) << other;
        EXPECT_EQ(mesh.elements, large.elements);
    }
}

TEST(Nastran, NamesTheElementsOfSeveralGroups)
{
    MeshData mesh = small_mesh();
    mesh.groups.push_back({"all", {0, 1}});
    mesh.groups.push_back({"none", {}});
    const test::TemporaryFolder folder;
    EXPECT_THAT(write_mesh_data(mesh, folder.file("out.bdf")),
                ElementsAre(folder.file("out.bdf") +
                            ": nastran cannot hold 1 element(s) of group 'all', which are in "
                            "another group too"));
    mesh.groups[1].elements = {1};
    EXPECT_EQ(difference(read_mesh_data(folder.file("out.bdf")), mesh), "");
}

std::string real_text(double value)
{
    std::string text(16, '?');
    put_nastran_real(text.data(), value);
    return text.substr(text.find_first_not_of(' '));
}

TEST(Nastran, WritesRealsOfSixteenColumnsWithAPoint)
{
    EXPECT_EQ(real_text(1), "1.");
    EXPECT_EQ(real_text(-0.0), "-0.");
    EXPECT_EQ(real_text(0.25), ".25");
    EXPECT_EQ(real_text(-0.25), "-.25");
    EXPECT_EQ(real_text(1e22), "1.+22");
    EXPECT_EQ(real_text(-1.5e-7), "-1.5-7");
    EXPECT_EQ(real_text(1.0 / 3), ".333333333333333");
    EXPECT_EQ(real_text(-1e-300 / 3), "-3.333333333-301");
    EXPECT_EQ(real_text(-12345678.123456789), "-12345678.123457");
}

TEST(Nastran, ExactDigitsInTheCommentCountOnlyWhileTheyAgreeWithTheCard)
{
    MeshData mesh = small_mesh();
    mesh.points(4, 1) = 1.0 / 3;
    const std::string text = written(mesh, "nastran");
    EXPECT_EQ(read_bytes(text, "nastran").points(4, 1), 1.0 / 3);
    EXPECT_EQ(read_bytes(replaced(text, ".333333333333333", ".444444444444444"), "nastran").points(4, 1),
              0.444444444444444);
    EXPECT_EQ(read_bytes(replaced(text, "$ exact 5", "$ exact 4"), "nastran").points(4, 1),
              0.333333333333333);
}

TEST(Nastran, ReadsTheSameMeshInEverySpelling)
{
    const MeshData plain = [] {
        MeshData mesh = small_mesh();
        mesh.groups = {{"property 1", {1}}, {"wing", {0}}};
        return mesh;
    }();
    std::vector<std::string> spellings;
    // small field, executive and case control before it, tabs, Windows line ends, ids with gaps, HyperMesh's
    // names
    spellings.push_back(
        "SOL 101\r\nCEND\r\n  DISP = ALL\r\nSUBCASE 1\r\nbegin bulk\r\n"
        "$HMNAME PROP                   2\"wing\" 4\r\n$HMNAME PROP       3\"wall below\"\r\n"
        "grid\t10\t\t0.\t0.\t0.\r\nGRID         200       0  1.0+0   0.0-3      0.\r\n"
        "GRID         300             1.0     1.0\r\n\r\nGRID         400        0.0     1.D0\r\n"
        "GRID     5000000             2.0    5.-1\r\n"
        "CQUAD4         1       2      10     200     300     400\r\n"
        "CTRIA3         2       1     200 5000000     300\r\n"
        "CBAR           3       3      10     200     1.0     0.0     0.0\r\n"
        "CBAR           4       3     200 5000000     1.0     0.0     0.0\r\nENDDATA\r\njunk");
    spellings[0] = replaced(spellings[0], "        0.0     1.D0", "             0.0    1.D0");
    // free field, no BEGIN BULK, elements first, ANSA's names, comments behind cards
    spellings.push_back("$ANSA_NAME_COMMENT;2;PSHELL;wing;NO;NO;NO;NO;\n$ANSA_NAME;3;PROD;~\n$wall below\n"
                        "CQUAD4,1,2,1,2,3,4 $ the square\nCTRIA3,2,1,2,5,3\nCROD,3,3,1,2\nCROD,4,3,2,5\n"
                        "GRID,1,,0.,0.,0.\nGRID,2,,1,0\nGRID,3,0,+1.0,1.0E+0\nGRID,4,,-0,.1+1\n"
                        "GRID*,5,,2.0,0.5,+\n*,0.0\n");
    spellings[1] = replaced(spellings[1], "-0,", "0,");
    // large field with marks of continuation, large and small mixed, Femap's names
    spellings.push_back(
        "$ Femap Property 2 : wing\n$ Femap Property 3 : wall below\n"
        "GRID*                  1                             0.0             0.0*A\n*A      0.0\n"
        "GRID           2              1.      0.                                +B\n+B\n"
        "GRID*                  3                              1.             1.0\n*\n"
        "GRID           4              0.      1.      0.       0\n"
        "GRID           5              2.      .5\n"
        "CQUAD4*                1               2               1               2*\n"
        "*                      3               4\n"
        "CTRIA3         2       1       2       5       3     0.0      0.        +\n+             0.1\n"
        "CONM2         77       1            12.5\n"
        "CBEAM          3       3       1       2\nCTUBE          4       3       2       5\n");
    for (const std::string& text : spellings)
        EXPECT_EQ(difference(read_bytes(text, "nastran"), plain), "") << text;
    ReadNotes notes;
    read_with_notes(spellings[2], notes);
    EXPECT_THAT(notes.warnings, ElementsAre("file: cards that are no mesh were left out: 'CONM2' (1)"));
}

TEST(Nastran, OnePropertyWithoutANameIsNoGroup)
{
    const std::string text =
        "GRID,1\nGRID,2,,1.\nGRID,3,,1.,1.\nGRID,4,,0.,1.\nCTRIA3,1,7,1,2,3\nCTRIA3,2,7,1,3,4\n"
        "PLOTEL,3,1,2\nPLOTEL,4,2,3\nCONROD,5,3,4,1,0.1\nCROD,6,9,4,1\n";
    const MeshData mesh = read_bytes(text, "nastran");
    EXPECT_THAT(mesh.groups, IsEmpty());
    ASSERT_EQ(mesh.markers.size(), 3U);
    EXPECT_EQ(mesh.markers[0].name, "property 9");
    EXPECT_EQ(mesh.markers[1].name, "CONROD");
    EXPECT_EQ(mesh.markers[2].name, "PLOTEL");
    EXPECT_THAT(mesh.markers[2].edges, ElementsAre(Edge{0, 1}, Edge{1, 2}));
    EXPECT_THAT(read_bytes("$HMNAME COMP 7\"skin\"\n" + text, "nastran").groups.at(0).elements,
                ElementsAre(0, 1));
}

TEST(Nastran, ReadsASpaceSurfaceWithoutPropertiesAsOneOfThreeDimensions)
{
    const MeshData mesh = read_bytes("GRID,1\nGRID,2,,1.\nGRID,3,,1.,1.,2.5-1\nCTRIA3,1,,1,2,3\n", "nastran");
    EXPECT_EQ(mesh.dimension, 3);
    EXPECT_EQ(mesh.points(2, 2), 0.25);
    EXPECT_THAT(mesh.groups, IsEmpty());
}

TEST(Nastran, TakesTheSurfaceOfAVolumeMesh)
{
    const std::string grid =
        "GRID,1\nGRID,2,,1.\nGRID,3,,1.,1.\nGRID,4,,0.,1.\nGRID,5,,0.,0.,1.\nGRID,6,,1.,0.,1.\n"
        "GRID,7,,1.,1.,1.\nGRID,8,,0.,1.,1.\n";
    const std::string cube = grid + "CHEXA,1,1,1,2,3,4,5,6,+\n+,7,8\nCQUAD4,2,5,1,4,3,2\n$ group 5 floor\n";
    EXPECT_EQ(refusal(cube, "nastran"), "file: holds a volume mesh of 1 cells; --surface takes its boundary");
    const MeshData mesh = surface_of_volume(cube);
    EXPECT_EQ(mesh.elements.size(), 6U);
    ASSERT_EQ(mesh.groups.size(), 1U);
    EXPECT_EQ(mesh.groups[0].elements.size(), 1U);
    EXPECT_EQ(surface_of_volume(grid + "CPENTA,1,1,1,2,3,5,6,7\n").elements.size(), 5U);
    EXPECT_EQ(surface_of_volume(grid + "CPYRAM,1,1,1,2,3,4,5\n").elements.size(), 5U);
    EXPECT_EQ(surface_of_volume(grid + "CTETRA,1,1,1,2,3,5\n").elements.size(), 4U);
    EXPECT_EQ(refusal(grid + "CTETRA,1,1,1,2,3,5,6,7\n", "nastran"),
              "file:9: CTETRA has more than 4 grid points: elements of higher order are not supported");
    EXPECT_EQ(refusal(grid + "CTETRA,1,1,1,2,3,9\n", "nastran"),
              "file:9: the element names grid point 9, but there is none of this id");
}

struct Refusal {
    std::string from, to, message;
};

TEST(Nastran, SaysWhatIsWrongAndWhere)
{
    const std::vector<Refusal> cases{
        {"GRID*                  2                ", "GRID*                  2               7",
         "file:8: the points are in the coordinate system 7, but only the basic one (0) is supported"},
        {"GRID*                  2", "GRID*                 -2",
         "file:8: expected the id of a grid point in field 2 of 'GRID', found '-2'"},
        {"GRID*                  2", "GRID*                   ",
         "file:8: expected the id of a grid point in field 2 of 'GRID', found nothing"},
        {"GRID*                  2", "GRID*                  1",
         "file:8: GRID 1 is there again, after line 6"},
        {"GRID*                  2", "GRID*          77777777",
         "file:16: the element names grid point 2, but there is none of this id"},
        {" 2.              .5", " 2.             .5x",
         "file:14: expected a coordinate in field 5 of 'GRID', found '.5x'"},
        {" 2.              .5", " 2.          1.+400",
         "file:14: expected a coordinate in field 5 of 'GRID', found '1.+400'"},
        {"CTRIA3         2       1       2", "CTRIA3         2       1     2.0",
         "file:17: expected a grid point in field 4 of 'CTRIA3', found '2.0'"},
        {"CTRIA3         2       1", "CTRIA3         2     one",
         "file:17: expected a property in field 3 of 'CTRIA3', found 'one'"},
        {"CTRIA3 ", "CTRIA6 ",
         "file:17: CTRIA6 elements are not supported; supported are CTRIA3, CQUAD4 and lines, and the "
         "surface of "
         "CTETRA, CPYRAM, CPENTA and CHEXA"},
        {"CROD           4       3       2       5", "CROD           4       3       2       6",
         "file:19: the element names grid point 6, but there is none of this id"},
        {"BEGIN BULK\n", "BEGIN BULK\n+       1\n", "file:3: a continuation line without a card before it"},
        {"BEGIN BULK\n", "BEGIN BULK\nINCLUDE 'a.bdf'\n",
         "file:3: INCLUDE is not supported; put the file in its place"},
        {"BEGIN BULK\n", "BEGIN BULK\nGRDSET,,3\n",
         "file:3: the points are in the coordinate system 3, but only the basic one (0) is supported"},
    };
    for (const Refusal& c : cases)
        EXPECT_EQ(refusal(replaced(kSmall, c.from, c.to), "nastran"), c.message) << c.to;
    EXPECT_EQ(refusal("", "nastran"),
              "file: neither BEGIN BULK nor a GRID in it, so this is no Nastran bulk data");
}

TEST(Nastran, FindsIdsThatAreFarApart)
{
    const std::string text = "GRID,2000000000\nGRID,7,,1.\nGRID,900,,1.,1.\nCTRIA3,1,1,2000000000,7,900\n";
    EXPECT_THAT(read_bytes(text, "nastran").elements, ElementsAre(Element{0, 1, 2, -1}));
    EXPECT_EQ(refusal(text + "GRID,900\n", "nastran"), "file:5: GRID 900 is there again, after line 3");
    EXPECT_EQ(refusal(text + "CTRIA3,2,1,7,900,8\n", "nastran"),
              "file:5: the element names grid point 8, but there is none of this id");
}

TEST(Nastran, HoldsAMeshOfManyTimesTheBufferOfTheFile)
{
    const MeshData mesh = test::uneven_square(250);
    EXPECT_EQ(difference(read_bytes(written(mesh, "nastran"), "nastran"), mesh), "");
}

TEST(Nastran, SurvivesMutatedFiles)
{
    test::survive_mutations(
        "nastran",
        {kSmall, written(test::rich_meshes()[4].second, "nastran"),
         "$HMNAME COMP 7\"skin\"\n$ANSA_NAME;3;PROD;~\n$wall\nGRID,1\nGRID,2,,1.\nGRID,3,,1.,1.\n"
         "GRID,4,,0.,1.-3\nCTRIA3,1,7,1,2,3\nCTRIA3,2,7,1,3,4\nPLOTEL,3,1,2\nCROD,6,9,4,1\n"},
        2000);
}

} // namespace
