// Tecplot's ASCII files, by the Data Format Guide of Tecplot, Inc.
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

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
using testing::HasSubstr;
using testing::IsEmpty;

using Edge = std::array<Index, 2>;

/// The unit square and a triangle to its right, with a value at each vertex and element.
const std::string kSmall = "VARIABLES = \"X\"\n" // 1
                           "\"Y\"\n"             // 2
                           "\"p\"\n"             // 3
                           "\"region\"\n"        // 4
                           "ZONE T=\"mesh\"\n"   // 5
                           "NODES=5, ELEMENTS=2, DATAPACKING=BLOCK, ZONETYPE=FEQUADRILATERAL\n"
                           "VARLOCATION=([4]=CELLCENTERED)\n" // 7
                           "0 1 1 0 2\n"                      // 8
                           "0 0 1 1 0.5\n"                    // 9
                           "0.1 0.2 0.3 0.4 0.5\n"            // 10
                           "7 8\n"                            // 11
                           "1 2 3 4\n"                        // 12
                           "2 5 3 3\n"                        // 13
                           "ZONE T=\"wall\"\n"                // 14
                           "NODES=5, ELEMENTS=2, DATAPACKING=BLOCK, ZONETYPE=FELINESEG\n"
                           "VARSHARELIST=([1-3]=1)\n"
                           "PASSIVEVARLIST=[4]\n"
                           "1 2\n" // 18
                           "2 5\n";

MeshData small_mesh()
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.markers = {{"wall", {{0, 1}, {1, 4}}}};
    Matrix p(5, 1);
    p << 0.1, 0.2, 0.3, 0.4, 0.5;
    Matrix region(2, 1);
    region << 7, 8;
    mesh.fields = {{"p", FieldLocation::vertex, p}, {"region", FieldLocation::element, region}};
    return mesh;
}

MeshData without_fields(MeshData mesh)
{
    mesh.fields.clear();
    return mesh;
}

/// What the reader reports in addition to the mesh.
std::vector<std::string> warnings(const std::string& text, const ReadOptions& options = {})
{
    ReadNotes notes;
    find_format("file", "tecplot").read({"file", text, options, &notes});
    return notes.warnings;
}

MeshData read_with(const std::string& text, const ReadOptions& options)
{
    return find_format("file", "tecplot").read({"file", text, options});
}

MeshData read_zone(const std::string& text, const std::string& zone)
{
    return read_with(text, {.surface = false, .zone = zone});
}

TEST(Tecplot, WritesTheBytesOfTheSpecification)
{
    EXPECT_EQ(written(small_mesh(), "tecplot"), kSmall);
}

TEST(Tecplot, ReadsTheBytesOfTheSpecification)
{
    EXPECT_EQ(difference(read_bytes(kSmall, "tecplot"), small_mesh()), "");
}

TEST(Tecplot, HoldsEveryRichMeshBitForBit)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "tecplot"), "tecplot")), "") << name;
}

TEST(Tecplot, ReadsWhatMeshioWrote)
{
    const MeshData mesh = read_mesh_data(test::data_path("tecplot/meshio.dat"));
    MeshData expected = test::square_and_triangle(0);
    Matrix p(5, 1);
    for (Index v = 0; v < 5; ++v)
        p(v, 0) = v / 3.0;
    Matrix c(2, 1);
    c << 7, 8;
    expected.fields = {{"p", FieldLocation::vertex, p}, {"c", FieldLocation::element, c}};
    EXPECT_EQ(difference(mesh, expected), "");
}

TEST(Tecplot, HoldsGroupsAsZonesOrAsLists)
{
    MeshData runs = small_mesh();
    runs.groups = {{"first \"one\"", {0}}, {"second", {1}}};
    EXPECT_EQ(difference(read_bytes(written(runs, "tecplot"), "tecplot"), runs), "");
    EXPECT_THAT(written(runs, "tecplot"), HasSubstr("ZONE T=\"second\"\nNODES=5, ELEMENTS=1, "
                                                    "DATAPACKING=BLOCK, ZONETYPE=FETRIANGLE\n"));
    MeshData overlapping = test::uneven_square(3);
    overlapping.groups = {{"some", {0, 1, 2, 5, 9, 10}}, {"none", {}}, {"turned", {17, 4, 2}}};
    EXPECT_EQ(difference(read_bytes(written(overlapping, "tecplot"), "tecplot"), overlapping), "");
}

TEST(Tecplot, ReadsTheSameMeshInEverySpelling)
{
    const MeshData plain = without_fields(small_mesh());
    std::vector<std::string> spellings;
    // the old header, node by node, tabs, Windows line ends, a comment behind data, no title
    spellings.push_back(
        "# old\r\nvariables = x, y\r\nzone\tt='mesh', n=5, e=2, f=fepoint, et=quadrilateral\r\n"
        "0\t0\r\n1,0 # second\r\n1 1.D0\r\n\r\n+0 1\r\n2 .5\r\n1 2 3 4\r\n2 5 3 3\r\n"
        "zone t=\"wall\" n=5 e=2 f=fepoint et=lineseg D=(1,2)\r\n1 2\r\n2 5");
    // repeated values, numbers that run on over lines, lines of a zone with nodes of its own
    spellings.push_back("TITLE=\"a # is no comment here\"\nVARIABLES=\"X\" \"Y\"\nZONE F=FEBLOCK N=5 E=2\n"
                        "ET=QUADRILATERAL 0 2*1\n0 2 2*0 2*1\n0.5 1 2 3 4 2\n5 3 3\n"
                        "ZONE T=wall ZONETYPE=FELINESEG NODES=3 ELEMENTS=2 DATAPACKING=POINT\n"
                        "0 0\n1 0\n2 0.5\n1 2\n2 3\n");
    // y first, texts and auxiliary data between, a line of an ordered zone
    spellings.push_back("VARIABLES=\"y [m]\" \"x [m]\"\nDATASETAUXDATA Mach=\"0.8\"\nVARAUXDATA 1 a=\"b\"\n"
                        "ZONE T=\"mesh\" NODES=5 ELEMENTS=2 DATAPACKING=POINT ZONETYPE=FEQUADRILATERAL\n"
                        "DT=(SINGLE SINGLE) AUXDATA Common.Area=\"1.5\"\n"
                        "0 0\n0 1\n1 1\n1 0\n0.5 2\n1 2 3 4\n2 5 5 3\n"
                        "TEXT X=50 Y=50 T=\"a label\"\nGEOMETRY T=LINE\n1\n2\n0 0\n1 1\n"
                        "ZONE T=\"wall\", I=3\n0 0\n0 1\n0.5 2\n");
    for (const std::string& text : spellings)
        EXPECT_EQ(difference(read_bytes(text, "tecplot"), plain), "") << text;
    EXPECT_THAT(warnings(spellings[2]),
                ElementsAre("file: line 13: TEXT was left out", "file: line 14: GEOMETRY was left out"));
}

TEST(Tecplot, ReadsOrderedZonesAsQuadsIFastest)
{
    const MeshData mesh = read_bytes("VARIABLES=X Y T\nZONE I=3, J=2, DATAPACKING=BLOCK, "
                                     "VARLOCATION=([3]=CELLCENTERED)\n0 1 2 0 1 2\n0 0 0 1 1 1\n5 6\n",
                                     "tecplot");
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 4, 3}, Element{1, 2, 5, 4}));
    ASSERT_EQ(mesh.fields.size(), 1U);
    EXPECT_EQ(mesh.fields[0].location, FieldLocation::element);
    EXPECT_EQ(mesh.fields[0].values(1, 0), 6);
}

/// Two blocks that meet at x = 1, the second with other values there.
const std::string kBlocks = "VARIABLES=X Y T\n"
                            "ZONE T=\"left\" I=2 J=2 F=POINT\n0 0 1\n1 0 2\n0 1 3\n1 1 4\n"
                            "ZONE T=\"right\" I=2 J=2 F=POINT\n1 0 20\n2 0 5\n1 1 40\n2 1 6\n"
                            "ZONE T=\"floor\" I=3 F=POINT\n0 0 0\n1 0 0\n2 0 0\n"
                            "ZONE T=\"roof\" I=2 F=POINT\n0 9 0\n1 9 0\n";

TEST(Tecplot, JoinsZonesWhereTheyMeetAndMakesThemGroups)
{
    const MeshData mesh = read_bytes(kBlocks, "tecplot");
    EXPECT_EQ(mesh.points.rows(), 6);
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 3, 2}, Element{1, 4, 5, 3}));
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[1].name, "right");
    EXPECT_THAT(mesh.groups[1].elements, ElementsAre(1));
    EXPECT_EQ(mesh.fields[0].values.col(0), (Eigen::VectorXd(6) << 1, 2, 3, 4, 5, 6).finished());
    ASSERT_EQ(mesh.markers.size(), 1U);
    EXPECT_THAT(mesh.markers[0].edges, ElementsAre(Edge{0, 1}, Edge{1, 4}));
    EXPECT_THAT(
        warnings(kBlocks),
        ElementsAre("file: 2 node(s) of several zones at the same place were joined; their values are "
                    "those of the first zone",
                    "file: 1 line(s) of zone 4 'roof' do not end at vertices of elements and were left "
                    "out"));
}

TEST(Tecplot, TakesOneZoneByNumberOrByName)
{
    for (const char* zone : {"2", "right"}) {
        const MeshData mesh = read_zone(kBlocks, zone);
        EXPECT_EQ(mesh.points.rows(), 4);
        EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 3, 2}));
        EXPECT_THAT(mesh.groups, IsEmpty());
        EXPECT_THAT(mesh.markers[0].edges, ElementsAre(Edge{0, 1})) << "the floor under the right block";
    }
    EXPECT_THROW(
        {
            try {
                read_zone(kBlocks, "middle");
            } catch (const InputError& error) {
                EXPECT_STREQ(error.what(), "file: has no zone 'middle' of elements, but 1 'left', 2 'right'");
                throw;
            }
        },
        InputError);
}

TEST(Tecplot, LeavesFurtherStatesOfAZoneOut)
{
    const std::string states = kSmall + "ZONE T=\"later\" NODES=5 ELEMENTS=2 DATAPACKING=BLOCK "
                                        "ZONETYPE=FEQUADRILATERAL VARSHARELIST=([1-2]=1) "
                                        "VARLOCATION=([4]=CELLCENTERED) CONNECTIVITYSHAREZONE=1\n"
                                        "5 4 3 2 1\n1 2\n";
    EXPECT_EQ(difference(read_bytes(states, "tecplot"), small_mesh()), "");
    EXPECT_THAT(warnings(states),
                ElementsAre("file: zone 3 'later' is a further state of zone 1 'mesh' and was left out"));
    EXPECT_EQ(read_zone(states, "later").fields[0].values(0, 0), 5);
    const std::string moving = "VARIABLES=X Y\n"
                               "ZONE STRANDID=1 SOLUTIONTIME=0 I=2 J=2 F=POINT 0 0 1 0 0 1 1 1\n"
                               "ZONE STRANDID=1 SOLUTIONTIME=0.5 I=2 J=2 F=POINT 0 0 2 0 0 2 2 2\n";
    EXPECT_EQ(read_bytes(moving, "tecplot").points.rows(), 4);
    EXPECT_EQ(read_zone(moving, "2").points(3, 0), 2);
}

TEST(Tecplot, TakesTheSurfaceOfAVolumeMesh)
{
    // a cube, and on top of it a prism, a pyramid and a tetrahedron as bricks with corners named twice
    const std::string volume = "VARIABLES=X Y Z\nZONE N=8 E=1 F=FEPOINT ET=BRICK\n"
                               "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1\n1 2 3 4 5 6 7 8\n";
    EXPECT_EQ(refusal(volume, "tecplot"),
              "file: holds a volume mesh of 1 cells; --surface takes its boundary");
    const auto faces = [&](const std::string& cell) {
        const std::string text = replaced(volume, "1 2 3 4 5 6 7 8", cell);
        return read_with(text, {.surface = true, .zone = ""}).elements.size();
    };
    EXPECT_EQ(faces("1 2 3 4 5 6 7 8"), 6U);
    EXPECT_EQ(faces("1 2 3 3 5 6 7 7"), 5U);
    EXPECT_EQ(faces("1 2 3 4 5 5 5 5"), 5U);
    EXPECT_EQ(faces("1 2 3 3 5 5 5 5"), 4U);
    const std::string ordered = "VARIABLES=X Y Z\nZONE I=2 J=2 K=2 F=POINT\n0 0 0 1 0 0 0 1 0 1 1 0 "
                                "0 0 1 1 0 1 0 1 1 1 1 1\n";
    EXPECT_EQ(read_with(ordered, {.surface = true, .zone = ""}).elements.size(), 6U);
}

TEST(Tecplot, FieldsNamedLikeCoordinatesStayFields)
{
    MeshData mesh = test::uneven_square(1);
    mesh.fields = {{"z", FieldLocation::vertex, Matrix::Constant(4, 1, 3)},
                   {"X", FieldLocation::vertex, Matrix::Constant(4, 1, 5)}};
    EXPECT_EQ(difference(read_bytes(written(mesh, "tecplot"), "tecplot"), mesh), "");
}

struct Refusal {
    std::string from, to, message;
};

TEST(Tecplot, SaysWhatIsWrongAndWhere)
{
    const std::vector<Refusal> cases{
        {"VARIABLES = \"X\"\n\"Y\"\n\"p\"\n\"region\"\n", "",
         "file:1: VARIABLES= must name two variables or more before the first ZONE"},
        {"\"region\"\n", "\"region\n", "file:4: the string has no closing quote"},
        {"T=\"mesh\"", "T=", "file:5: the zone does not say how many nodes it has: NODES= is missing"},
        {"FEQUADRILATERAL", "FEPOLYGON",
         "file:6: zones of the type 'FEPOLYGON' are not supported; supported are ORDERED, FELINESEG, "
         "FETRIANGLE, FEQUADRILATERAL, FETETRAHEDRON and FEBRICK"},
        {"BLOCK", "ROWS",
         "file:6: data are packed as 'ROWS', but POINT or BLOCK (FEPOINT, FEBLOCK) was expected"},
        {"BLOCK", "POINT", "file:5: a zone with values at cells must be packed as BLOCK"},
        {"NODES=5", "NODES=many", "file:6: NODES must be a whole number, found 'many'"},
        {"NODES=5, ", "", "file:5: the zone does not say how many nodes it has: NODES= is missing"},
        {"NODES=5", "NODES=2000000000",
         "file:5: the zone counts 2000000000 nodes and 2 elements, but the file has 337 bytes only"},
        {"[4]=CELL", "[5]=CELL",
         "file:7: the variables of VARLOCATION must be numbers from 1 to 4, found '[5'"},
        {"([4]=CELLCENTERED)", "([4]=CELLCENTERED", "file:7: the list has no closing bracket"},
        {"VARLOCATION", "SOLUTIONTIME", "file:7: SOLUTIONTIME must be a number, found '([4]=CELLCENTERED)'"},
        {"0.2", "0,x", "file:10: expected a value of 'p' in zone 1 'mesh', found 'x'"},
        {"0.2", "1.5*2", "file:10: a value must be repeated a whole number of times"},
        {"7 8", "3*7", "file:11: a value is repeated beyond the last one of zone 1 'mesh'"},
        {"1 2 3 4", "1 2 3 6", "file:12: element 1 of zone 1 'mesh' names node 6, but the zone has 5"},
        {"2 5 3 3", "2 5 3", "file:14: expected a node of element 2 of zone 1 'mesh', found 'ZONE'"},
        {"2 5 3 3", "2 2 3 3",
         "file:5: element 2 of zone 1 'mesh' repeats nodes so that no supported cell is left"},
        {"2 5 3 3", "2 5 3 3 1", "file:13: expected a record such as VARIABLES or ZONE, found '1'"},
        {"[1-3]=1", "[1-3]=2", "file:16: zone 2 is to be shared, but 1 zone(s) stand before this one"},
        {"[1-3]=1", "[1-3]=x", "file:16: VARSHARELIST must be like ([1-3]=1), found '([1-3]=x)'"},
        {"NODES=5, ELEMENTS=2, DATAPACKING=BLOCK, ZONETYPE=FELINESEG",
         "NODES=4, ELEMENTS=2, DATAPACKING=BLOCK, ZONETYPE=FELINESEG",
         "file:14: zone 2 'wall' has 4 values of 'X', but zone 1, whose values it shares, 5"},
        {"PASSIVEVARLIST=[4]", "CONNECTIVITYSHAREZONE=1 PASSIVEVARLIST=[4]",
         "file:14: zone 2 'wall' shares the connectivity of zone 1, but has another type or size"},
        {"VARIABLES", "FILETYPE=SOLUTION VARIABLES",
         "file:1: FILETYPE=SOLUTION has no coordinates; FULL or GRID was expected"},
        {"ZONE T=\"wall\"", "VARIABLES=A B ZONE T=\"wall\"",
         "file:14: VARIABLES= must stand before the first ZONE"},
    };
    for (const Refusal& c : cases)
        EXPECT_EQ(refusal(replaced(kSmall, c.from, c.to), "tecplot"), c.message) << c.to;
}

TEST(Tecplot, RefusesWhatIsNoMeshInOneLine)
{
    EXPECT_EQ(
        refusal("#!TDV112\1\0\0\0", "tecplot"),
        "file: byte 0: a binary Tecplot file (#!TDV112), but ASCII was expected; save it as ASCII (.dat)");
    EXPECT_EQ(refusal("", "tecplot"), "file: no ZONE in it, so this is no Tecplot file with a mesh");
    EXPECT_EQ(refusal("VARIABLES=X Y\nZONE I=2 J=9 K=99999999 F=POINT\n", "tecplot"),
              "file:2: the zone is 2 x 9 x 99999999 nodes, but the file has 46 bytes only");
    EXPECT_EQ(refusal("VARIABLES=X Y\nZONE I=3 F=POINT\n0 0 1 0 2 0\n", "tecplot"),
              "file: has zones of lines only; a mesh needs a zone of triangles or quads");
    EXPECT_EQ(refusal("VARIABLES=X Y\nZONE T=a I=2 J=2 F=BLOCK VARLOCATION=([1]=CELLCENTERED)\n1 1 2 3 4\n",
                      "tecplot"),
              "file: the coordinate 'X' is at cells in zone 1 'a', but must be at nodes");
}

TEST(Tecplot, LimitsValuesThatCostNoBytes)
{
    std::string text = "VARIABLES=X Y A B C D E F\n# " + std::string(400, '-') + "\n";
    for (int zone = 0; zone < 3; ++zone)
        text += "ZONE I=20 J=20 F=BLOCK PASSIVEVARLIST=[1-8]\n";
    EXPECT_EQ(refusal(text, "tecplot"),
              "file:5: zone 3 brings the values to 9200, but the file has 561 bytes only");
}

TEST(Tecplot, NamesVariablesThatChangeTheirPlace)
{
    EXPECT_EQ(refusal(kBlocks + "ZONE I=2 J=2 F=BLOCK VARLOCATION=([3]=CELLCENTERED)\n5 6 5 6 0 0 1 1 3\n",
                      "tecplot"),
              "file: 'T' is at nodes in zone 1, but not in zone 5");
}

TEST(Tecplot, HoldsAMeshOfManyTimesTheBufferOfTheFile)
{
    const MeshData mesh = test::uneven_square(250);
    EXPECT_EQ(difference(read_bytes(written(mesh, "tecplot"), "tecplot"), mesh), "");
}

TEST(Tecplot, SurvivesMutatedFiles)
{
    test::survive_mutations(
        "tecplot",
        {kSmall, kBlocks, written(test::rich_meshes()[4].second, "tecplot"),
         "VARIABLES=x y\nzone n=5, e=2, f=fepoint, et=quadrilateral\n0 0 1 0 1 1 0 1 2 .5\n"
         "1 2 3 4 2 5 3 3\nzone n=5 e=2 f=fepoint et=lineseg D=(1,2)\n1 2\n2 5"},
        2000);
}

} // namespace
