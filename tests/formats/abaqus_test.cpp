// Abaqus input files, by the Abaqus Keywords Reference Guide.
#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

/// The unit square and a triangle to its right, a group and two markers. The tests below count its lines.
const std::string kSmall = "*HEADING\n"                              // 1
                           "*NODE\n"                                 // 2
                           "1,0,0\n"                                 // 3
                           "2,1,0\n"                                 // 4
                           "3,1,1\n"                                 // 5
                           "4,0,1\n"                                 // 6
                           "5,2,0.5\n"                               // 7
                           "*ELEMENT, TYPE=CPS4\n"                   // 8
                           "1,1,2,3,4\n"                             // 9
                           "*ELEMENT, TYPE=CPS3\n"                   // 10
                           "2,2,5,3\n"                               // 11
                           "*ELSET, ELSET=wing\n"                    // 12
                           "1\n"                                     // 13
                           "** name wall_below wall below\n"         // 14
                           "*ELEMENT, TYPE=T2D2, ELSET=wall_below\n" // 15
                           "3,1,2\n"                                 // 16
                           "4,2,5\n"                                 // 17
                           "*ELEMENT, TYPE=T2D2, ELSET=tip\n"        // 18
                           "5,5,3\n";                                // 19

MeshData small_mesh()
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.groups = {{"wing", {0}}};
    mesh.markers = {{"wall below", {{0, 1}, {1, 4}}}, {"tip", {{4, 2}}}};
    return mesh;
}

MeshData without_fields(MeshData mesh)
{
    mesh.fields.clear();
    return mesh;
}

std::vector<std::string> warnings(const std::string& text)
{
    ReadNotes notes;
    find_format("file", "abaqus").read({"file", text, {}, &notes});
    return notes.warnings;
}

MeshData surface_of_volume(const std::string& text)
{
    return find_format("file", "abaqus").read({"file", text, {.surface = true, .zone = ""}});
}

TEST(Abaqus, WritesTheBytesOfTheSpecification)
{
    EXPECT_EQ(written(small_mesh(), "abaqus"), kSmall);
}

TEST(Abaqus, ReadsTheBytesOfTheSpecification)
{
    EXPECT_EQ(difference(read_bytes(kSmall, "abaqus"), small_mesh()), "");
}

TEST(Abaqus, HoldsEveryRichMeshBitForBitButForFields)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        EXPECT_EQ(difference(without_fields(mesh), read_bytes(written(mesh, "abaqus"), "abaqus")), "")
            << name;
}

TEST(Abaqus, ReadsWhatMeshioWrote)
{
    MeshData expected = test::square_and_triangle(0);
    expected.markers = {{"lines", {{0, 1}, {1, 4}}}};
    EXPECT_EQ(difference(read_mesh_data(test::data_path("abaqus/meshio.inp")), expected), "");
}

TEST(Abaqus, ReadsPhysicalGroupsThatGmshWrote)
{
    ReadNotes notes;
    const MeshData mesh = read_mesh_data(test::data_path("abaqus/gmsh.inp"), "", {}, &notes);
    EXPECT_THAT(notes.warnings, IsEmpty());
    EXPECT_EQ(mesh.points.rows(), 12);
    ASSERT_TRUE(find_marker(mesh.markers, "wall"));
    EXPECT_THAT(find_marker(mesh.markers, "wall")->edges, ElementsAre(Edge{0, 4}, Edge{4, 1}));
    ASSERT_TRUE(find_marker(mesh.markers, "far_field"));
    EXPECT_EQ(find_marker(mesh.markers, "far_field")->edges.size(), 6U);
    EXPECT_EQ(mesh.markers.size(), 6U) << "four lines as well as the two groups";
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[1].name, "domain");
    EXPECT_EQ(mesh.groups[1].elements.size(), 14U);
}

TEST(Abaqus, HoldsGroupsThatShareElementsAndNames)
{
    MeshData mesh = test::uneven_square(3);
    mesh.groups = {{"some", {0, 1, 2, 5, 9, 10}},
                   {"none", {}},
                   {"turned", {17, 4, 2}},
                   {"SOME", {3}},
                   {"all", {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17}}};
    EXPECT_EQ(difference(read_bytes(written(mesh, "abaqus"), "abaqus"), mesh), "");
}

TEST(Abaqus, ReadsTheSameMeshInEverySpelling)
{
    MeshData plain = small_mesh();
    plain.markers[0].name = "below";
    std::vector<std::string> spellings;
    // small letters, blanks, comments, Windows line ends, shells, ids with gaps, lines that run on
    spellings.push_back("** by hand\r\n*Heading\r\n a title, 1, 2\r\n*node, nset=nall\r\n 10, 0., 0.\r\n\r\n"
                        "20,\t1.0, 0.0, 0.0, 0., 0., 1.\r\n** between\r\n300, +1, 1.D0,\r\n40, 0, 1\r\n"
                        "5000000, 2, .5\r\n*element,\r\n type=s4r5, elset=wing\r\n7, 10, 20,\r\n 300, 40\r\n"
                        "*Element, Type = STRI3\r\n8, 20, 5000000, 300\r\n"
                        "*Element, type=B21, elset=below\r\n1, 10, 20\r\n2, 20, 5000000\r\n"
                        "*ELEMENT,TYPE=T3D2H,ELSET=\"tip\"\r\n3,5000000,300");
    // elements first, a part and its instance, sets by range, of sets and at an instance, sides of elements
    spellings.push_back(
        "*PART, NAME=p\n*ELEMENT, TYPE=CPE4R\n1, 1, 2, 3, 4\n*ELEMENT, TYPE=CPE3\n2, 2, 5, 3\n"
        "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n5, 2, .5\n*ELSET, ELSET=one, GENERATE\n1, 1, 1\n"
        "*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n"
        "*ELSET, ELSET=wing, INSTANCE=i\none, i.1\n*SURFACE, NAME=below, TYPE=ELEMENT\n"
        "i.wing, S1\n2, S1\n*SURFACE, NAME=tip\n2, s2\n*END ASSEMBLY\n*MATERIAL, NAME=m\n*ELASTIC\n"
        "2e11, 0.3\n");
    spellings[1] = replaced(spellings[1], "*ELSET, ELSET=one, GENERATE\n1, 1, 1\n*END PART\n", "*END PART\n");
    spellings[1] = replaced(spellings[1], "one, i.1\n", "i.1\n");
    // shells with named edges, sets of nodes that boundary edges make up
    spellings.push_back(
        "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,2,.5\n*NSET, NSET=below\n1, 2, 5\n*NSET,NSET=inner\n2, 3\n"
        "*NSET, NSET=tip, GENERATE\n3, 5, 2\n*ELEMENT, TYPE=S4, ELSET=wing\n1,1,2,3,4\n"
        "*ELEMENT, TYPE=S3\n2,2,5,3\n");
    for (const std::string& text : spellings)
        EXPECT_EQ(difference(read_bytes(text, "abaqus"), plain), "") << text;
    EXPECT_THAT(warnings(spellings[1]),
                ElementsAre("file: keywords that are no mesh were left out: '*ELASTIC', '*MATERIAL'"));
    EXPECT_THAT(warnings(spellings[2]),
                ElementsAre("file: the set of nodes 'inner' is not made of boundary edges and was left out"));
}

TEST(Abaqus, SetsNameIdsRangesAndOtherSets)
{
    const std::string text =
        written(test::uneven_square(3), "abaqus") +
        "*ELSET, ELSET=odd, GENERATE\n1, 17, 2\n*ELSET, ELSET=far, GENERATE\n18, 2000000000, 1\n"
        "*ELSET, ELSET=both\nODD, 1, 2, later\n*ELSET, ELSET=later\n4,both\n"
        "*ELSET, ELSET=odd\n2\n";
    const std::vector<ElementGroup> groups = read_bytes(text, "abaqus").groups;
    ASSERT_EQ(groups.size(), 4U);
    EXPECT_THAT(groups[0].elements, ElementsAre(0, 2, 4, 6, 8, 10, 12, 14, 16, 1));
    EXPECT_THAT(groups[1].elements, ElementsAre(17));
    EXPECT_THAT(groups[2].elements, ElementsAre(0, 2, 4, 6, 8, 10, 12, 14, 16, 1, 3));
    EXPECT_THAT(groups[3].elements, ElementsAre(3)) << "a set that names a set that names it adds nothing";
}

TEST(Abaqus, EdgesOfShellsAndTheirFacesMakeSurfaces)
{
    const std::string shells =
        "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,1\n4,0,1,1\n*ELEMENT,TYPE=S4,ELSET=s\n9,1,2,3,4\n"
        "*SURFACE,NAME=rim\n9,E2\ns,E4\n*SURFACE,NAME=skin\ns,SPOS\n"
        "*SURFACE,TYPE=NODE,NAME=n\n1\n*ELEMENT,TYPE=MASS,ELSET=m\n50,1\n";
    const MeshData mesh = read_bytes(shells, "abaqus");
    EXPECT_EQ(mesh.dimension, 3);
    ASSERT_EQ(mesh.markers.size(), 1U);
    EXPECT_THAT(mesh.markers[0].edges, ElementsAre(Edge{1, 2}, Edge{3, 0}));
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[1].name, "skin");
    EXPECT_THAT(mesh.groups[1].elements, ElementsAre(0));
    EXPECT_THAT(warnings(shells),
                ElementsAre("file: keywords that are no mesh were left out: '*ELEMENT, TYPE=MASS', "
                            "'*SURFACE that is not of TYPE=ELEMENT'"));
    EXPECT_EQ(refusal(shells + "*SURFACE,NAME=x\n9,E5\n", "abaqus"), "file:18: element 9 has no side 'E5'");
    EXPECT_EQ(refusal(shells + "*SURFACE,NAME=x\nq,E1\n", "abaqus"),
              "file:18: the surface 'x' names the elements 'q', which are not there");
}

TEST(Abaqus, TakesTheSurfaceOfAVolumeMeshWithItsSidesAsGroups)
{
    const std::string nodes =
        "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";
    const std::string cube = nodes +
                             "*ELEMENT, TYPE=C3D8R, ELSET=all\n1,1,2,3,4,5,6,7,\n8\n"
                             "*SURFACE, NAME=top\nall, S2\n*SURFACE, NAME=sides\n1,S3\n1,S4\n1,S5\n1,S6\n";
    EXPECT_EQ(refusal(cube, "abaqus"), "file: holds a volume mesh of 1 cells; --surface takes its boundary");
    const MeshData mesh = surface_of_volume(cube);
    EXPECT_EQ(mesh.elements.size(), 6U);
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "top");
    ASSERT_EQ(mesh.groups[0].elements.size(), 1U);
    for (const Index v : mesh.elements[static_cast<std::size_t>(mesh.groups[0].elements[0])])
        EXPECT_EQ(mesh.points(v, 2), 1);
    EXPECT_EQ(mesh.groups[1].elements.size(), 4U);
    // every side of every shape is a face of its cell: then nothing is warned of
    const std::array<std::pair<std::string, int>, 4> cells{{{"C3D4\n1,1,2,3,5\n", 4},
                                                            {"C3D5\n1,1,2,3,4,5\n", 5},
                                                            {"C3D6\n1,1,2,3,5,6,7\n", 5},
                                                            {"C3D8\n1,1,2,3,4,5,6,7,8\n", 6}}};
    for (const auto& [cell, sides] : cells) {
        std::string text = nodes + "*ELEMENT, TYPE=" + cell + "*SURFACE, NAME=skin\n";
        for (int side = 1; side <= sides; ++side)
            text += "1, S" + std::to_string(side) + "\n";
        const MeshData surface = surface_of_volume(text);
        EXPECT_EQ(surface.elements.size(), static_cast<std::size_t>(sides)) << cell;
        EXPECT_EQ(surface.groups.at(0).elements.size(), static_cast<std::size_t>(sides)) << cell;
    }
}

struct Refusal {
    std::string from, to, message;
};

TEST(Abaqus, SaysWhatIsWrongAndWhere)
{
    const std::vector<Refusal> cases{
        {"*HEADING", "*INCLUDE, INPUT=a.inp",
         "file:1: *INCLUDE is not supported; write the mesh out in full"},
        {"*NODE", "*NODE, INPUT=a.inp",
         "file:2: *NODE reads the file 'a.inp', which is not supported; put its lines in place"},
        {"*NODE", "*NODE, SYSTEM=C",
         "file:2: nodes in cylindrical or spherical coordinates are not supported"},
        {"*NODE", "*SYSTEM", "file:2: *SYSTEM is not supported; write the mesh out in full"},
        {"*HEADING", "*", "file:1: expected a keyword behind '*'"},
        {"2,1,0\n", "x,1,0\n", "file:4: expected the id of a node, found 'x,1,0'"},
        {"2,1,0\n", "2,1 0\n", "file:4: expected a comma, found '0'"},
        {"2,1,0\n", "1,1,0\n", "file:4: node 1 is there again, after line 3"},
        {"2,1,0\n", "2,1,zero\n", "file:4: expected a coordinate, found 'zero'"},
        {"TYPE=CPS4", "TYPE=CPS8",
         "file:8: elements of the type 'CPS8' are not supported; supported are linear triangles, quads and "
         "lines, "
         "and the surface of linear cells"},
        {"1,1,2,3,4", "1,1,2,3", "file:9: expected a node of the element, found the end of the line"},
        {"1,1,2,3,4", "1,1,2,3,", "file:9: expected a node of the element, found the end of the line"},
        {"1,1,2,3,4", "1,1,2,3,4,5",
         "file:9: expected the end of the line after the nodes of the element, found '5'"},
        {"1,1,2,3,4", "1,1,2,3,6", "file:9: the element names node 6, but there is none of this id"},
        {"2,2,5,3", "1,2,5,3", "file:11: element 1 is there again, after line 9"},
        {"ELSET=wing", "", "file:12: *ELSET without ELSET="},
        {"wing\n1\n", "wing\n1, 9\n",
         "file:13: the set 'wing' names element 9, but there is none of this id"},
        {"wing\n1\n", "wing\nbody\n", "file:13: the set 'wing' names the set 'body', which is not there"},
        {"wing\n1\n", "wing, GENERATE\n3,1\n", "file:13: the range 3 to 1 by 1 has no members"},
        {"wing\n1\n", "wing, GENERATE\n3\n",
         "file:13: expected the last id of a range, found the end of the line"},
        {"*HEADING\n", "*PART, NAME=a\n*NODE\n9,0,0\n*END PART\n*PART, NAME=b\n",
         "file:6: the nodes of a second part begin here, but one part is supported"},
        {"*HEADING\n", "*INSTANCE, NAME=i, PART=p\n1., 0., 0.\n",
         "file:2: instances that are moved or turned are not supported"},
    };
    for (const Refusal& c : cases)
        EXPECT_EQ(refusal(replaced(kSmall, c.from, c.to), "abaqus"), c.message) << c.to;
    EXPECT_EQ(refusal("", "abaqus"), "file: no keyword such as *NODE in it, so this is no Abaqus input file");
    EXPECT_EQ(refusal("no mesh\n", "abaqus"),
              "file: no keyword such as *NODE in it, so this is no Abaqus input file");
}

TEST(Abaqus, HoldsAMeshOfManyTimesTheBufferOfTheFile)
{
    const MeshData mesh = test::uneven_square(250);
    EXPECT_EQ(difference(read_bytes(written(mesh, "abaqus"), "abaqus"), mesh), "");
}

TEST(Abaqus, SurvivesMutatedFiles)
{
    test::survive_mutations(
        "abaqus",
        {kSmall, written(test::rich_meshes()[4].second, "abaqus"),
         "*NODE, NSET=n\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n*ELEMENT, TYPE=S4, ELSET=s\n1,1,2,3,4\n"
         "*NSET, NSET=m, GENERATE\n1,4,1\n*ELSET, ELSET=t\ns, 1\n*SURFACE, NAME=f\ns, E1\n1, E2\n"},
        2000);
}

} // namespace
