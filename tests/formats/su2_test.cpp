#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>
#include <utility>

namespace {

using namespace morph;
using test::difference;
using test::read_bytes;
using test::replaced;
using test::written;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two triangles that make a unit square. The tests below count its lines.
const std::string kSquare = "NDIME= 2\n"         // 1
                            "NELEM= 2\n"         // 2
                            "5 0 1 2 0\n"        // 3
                            "5 0 2 3 1\n"        // 4
                            "NPOIN= 4\n"         // 5
                            "0 0 0\n"            // 6
                            "1 0 1\n"            // 7
                            "1 1 2\n"            // 8
                            "0 1 3\n"            // 9
                            "NMARK= 1\n"         // 10
                            "MARKER_TAG= body\n" // 11
                            "MARKER_ELEMS= 2\n"  // 12
                            "3 0 1\n"            // 13
                            "3 1 2\n";           // 14

std::vector<std::string> carried_texts(const MeshData& mesh)
{
    std::vector<std::string> texts;
    for (const OpaqueSection& carried : mesh.sections)
        texts.push_back(carried.text);
    return texts;
}

std::vector<std::string> carried_things(const MeshData& mesh)
{
    std::vector<std::string> things;
    for (const OpaqueSection& carried : mesh.sections)
        things.push_back(carried.what);
    return things;
}

TEST(Su2, ReadsASquareOfTwoTriangles)
{
    const MeshData mesh = read_bytes(kSquare, "su2");
    Points corners(4, 3);
    corners << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    EXPECT_EQ(mesh.dimension, 2);
    EXPECT_EQ(mesh.points, corners);
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}, Element{0, 2, 3, -1}));
    ASSERT_EQ(mesh.markers.size(), 1U);
    EXPECT_EQ(mesh.markers[0].name, "body");
    EXPECT_THAT(mesh.markers[0].edges, ElementsAre(std::array<Index, 2>{0, 1}, std::array<Index, 2>{1, 2}));
    EXPECT_THAT(mesh.sections, IsEmpty());
}

TEST(Su2, ReadsTheSameSquareInEverySpellingFoundInTheWild)
{
    const MeshData square = read_bytes(kSquare, "su2");
    std::vector<std::string> spellings;
    // tabs, Windows line ends, no blank behind '=', no ids, no line end at the end
    spellings.push_back("NDIME=2\r\nNELEM=2\r\n 5\t0\t1\t2\r\n5\t 0 2 3\t\r\nNPOIN=4\r\n0.0\t0\r\n1e0\t0\r\n"
                        "+1 1.D0\r\n0 1\r\nNMARK=1\r\nMARKER_TAG=body\r\nMARKER_ELEMS=2\r\n3\t0\t1\t\r\n"
                        "3\t1\t2");
    // comments, empty lines, blanks before '=' and before keys
    spellings.push_back("% a square\n\n  NDIME = 2 % planar\n%\n\nNELEM\t= 2\n%\n5 0 1 2 0 % first\n\n"
                        "5 0 2 3 1\n%\nNPOIN= 4%\n0 0 0\n1 0 1\n\n% middle\n1 1 2\n0 1 3\nNMARK= 1\n%\n"
                        "MARKER_TAG= body  % no part of the name\n%\nMARKER_ELEMS= 2\n3 0 1 % edge\n%\n"
                        "3 1 2\n% end\n");
    // vertices first, dimension last, two ids as parallel SU2 wrote them
    spellings.push_back("NMARK= 1\nMARKER_TAG= body\nMARKER_ELEMS= 2\n3 0 1 0\n3 1 2 1\nNPOIN= 4\n0 0 0 0\n"
                        "1 0 1 10\n1 1 2 20\n0 1 3 30\nNELEM= 2\n5 0 1 2 0 0\n5 0 2 3 1 0\nNDIME= 2\n");
    // z of a planar mesh as a number of its own, before the id, and one zone
    spellings.push_back("NZONE= 1\nNDIME= 2\nNPOIN= 4\n0 0 0.0 0\n1 0 0.0 1\n1 1 0.0 2\n0 1 0.0 3\nNELEM= 2\n"
                        "5 0 1 2\n5 0 2 3\nNMARK= 1\nMARKER_TAG= body\nMARKER_ELEMS= 2\n3 0 1\n3 1 2\n");
    // z of a planar mesh and no id
    spellings.push_back("NDIME= 2\nNPOIN= 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\nNELEM= 2\n5 0 1 2\n5 0 2 3\n"
                        "NMARK= 1\nMARKER_TAG= body\nMARKER_ELEMS= 2\n3 0 1\n3 1 2\n");
    // one marker in two blocks
    spellings.push_back(
        "NDIME= 2\nNPOIN= 4\n0 0\n1 0\n1 1\n0 1\nNELEM= 2\n5 0 1 2\n5 0 2 3\nNMARK= 2\n"
        "MARKER_TAG= body\nMARKER_ELEMS= 1\n3 0 1\nMARKER_TAG= body\nMARKER_ELEMS= 1\n3 1 2\n");
    for (const std::string& text : spellings) {
        const MeshData mesh = read_bytes(text, "su2");
        EXPECT_EQ(difference(mesh, square), "") << text;
        EXPECT_THAT(mesh.sections, IsEmpty()) << text;
    }
}

TEST(Su2, SortsVerticesByTheIdsThatConnectivityRefersTo)
{
    const std::string shuffled =
        replaced(kSquare, "0 0 0\n1 0 1\n1 1 2\n0 1 3\n", "1 1 2\n0 1 3\n0 0 0\n1 0 1\n");
    EXPECT_EQ(difference(read_bytes(shuffled, "su2"), read_bytes(kSquare, "su2")), "");
}

TEST(Su2, WritesEveryRealMeshAsItWasRead)
{
    const test::TemporaryFolder folder;
    for (const std::string& path : test::real_meshes()) {
        SCOPED_TRACE(path);
        const MeshData mesh = read_mesh_data(path);
        EXPECT_THAT(write_mesh_data(mesh, folder.file("out.su2")), IsEmpty());
        const MeshData again = read_mesh_data(folder.file("out.su2"));
        EXPECT_EQ(difference(again, mesh), "");
        EXPECT_EQ(carried_texts(again), carried_texts(mesh));
        EXPECT_EQ(carried_things(again), carried_things(mesh));
    }
}

/// Lines of a file from the first that starts with @p start up to the next that starts with @p end.
std::string lines_between(const std::string& text, const std::string& start, const std::string& end)
{
    const std::size_t from = text.find("\n" + start) + 1;
    return text.substr(from, text.find("\n" + end, from) + 1 - from);
}

TEST(Su2, CarriesTheFfdBoxesOfARealMeshUnchanged)
{
    const std::string path = test::data_path("meshes/naca0012_multiffd.su2");
    const MeshData mesh = read_mesh_data(path);
    EXPECT_THAT(carried_things(mesh), ElementsAre("the section AOA_OFFSET", "the section AOS_OFFSET",
                                                  "1 periodic transformation(s)", "2 FFD box(es)"));
    const std::string before = test::read_text(path);
    const std::string after = written(mesh, "su2");
    EXPECT_EQ(after.substr(after.find("FFD_NBOX")), before.substr(before.find("FFD_NBOX")));
    EXPECT_EQ(lines_between(after, "NPERIODIC", "FFD"), lines_between(before, "NPERIODIC", "FFD"));
}

TEST(Su2, CarriesSendReceiveMarkersAndCountsThemForSu2)
{
    const std::string path = test::data_path("meshes/ls89.su2");
    const MeshData mesh = read_mesh_data(path);
    EXPECT_EQ(mesh.markers.size(), 5U);
    EXPECT_THAT(carried_things(mesh),
                ElementsAre("the second number of NPOIN= 16009 15715", "2 SEND_RECEIVE marker(s)",
                            "3 periodic transformation(s)"));
    const std::string before = test::read_text(path);
    const std::string after = written(mesh, "su2");
    EXPECT_THAT(after, HasSubstr("\nNMARK= 7\n"));
    EXPECT_THAT(after, HasSubstr("\nNPOIN= 16009\t15715\n"));
    EXPECT_EQ(after.substr(after.find("MARKER_TAG= SEND_RECEIVE")),
              before.substr(before.find("MARKER_TAG= SEND_RECEIVE")));
}

TEST(Su2, DropsTheSecondNumberOfNpoinWithTheVerticesItCounts)
{
    MeshData mesh = read_bytes(replaced(kSquare, "NPOIN= 4", "NPOIN= 4 3"), "su2");
    EXPECT_THAT(written(mesh, "su2"), HasSubstr("NPOIN= 4 3\n"));
    mesh.points.conservativeResize(5, Eigen::NoChange);
    mesh.points.row(4) << 2, 2, 0;
    EXPECT_THAT(written(mesh, "su2"), HasSubstr("NPOIN= 5\n"));
}

TEST(Su2, CarriesSingleVerticesOfAMarkerAndUnknownSections)
{
    const std::string unknown = "SPLINE_KIND= 3\n airfoil = 1 % kept\n% kept too\n2 3\n";
    const std::string text =
        replaced(replaced(kSquare, "3 1 2", "1 3\n3 1 2"), "MARKER_ELEMS= 2", "MARKER_ELEMS= 3");
    const MeshData mesh =
        read_bytes("% head\n" + replaced(text, "NPOIN", unknown + "% lost\n\nNPOIN"), "su2");
    EXPECT_EQ(difference(mesh, read_bytes(kSquare, "su2")), "");
    EXPECT_THAT(carried_texts(mesh), ElementsAre("SPLINE_KIND= 3\n", "airfoil = 1 % kept\n% kept too\n2 3\n",
                                                 "MARKER_TAG= body\nMARKER_ELEMS= 1\n1 3\n"));
    const std::string out = written(mesh, "su2");
    EXPECT_THAT(out, HasSubstr("NMARK= 2\n"));
    EXPECT_THAT(carried_texts(read_bytes(out, "su2")),
                testing::UnorderedElementsAreArray(carried_texts(mesh)));
}

TEST(Su2, WritesQuadsSurfacesAndExtremeCoordinatesBitForBit)
{
    for (MeshData mesh : {test::quad_square(3), test::uneven_square(3), MeshData{}}) {
        EXPECT_EQ(difference(read_bytes(written(mesh, "su2"), "su2"), mesh), "");
        mesh.dimension = 3;
        std::mt19937_64 random(3);
        for (Eigen::Index i = 0; i < mesh.points.size(); ++i)
            mesh.points.data()[i] =
                std::ldexp(static_cast<double>(random()) - 9e18, static_cast<int>(random() % 2000) - 1074);
        EXPECT_EQ(difference(read_bytes(written(mesh, "su2"), "su2"), mesh), "");
    }
}

TEST(Su2, WarnsOfFieldsAndOfTextOfOtherFormatsOnly)
{
    MeshData mesh = test::uneven_square(2);
    mesh.fields.push_back({"h", FieldLocation::vertex, Matrix::Zero(9, 1)});
    mesh.sections = {{"su2", "2 FFD box(es)", "FFD_NBOX= 2\n"}, {"gmsh", "a view", "$View\n"}};
    const test::TemporaryFolder folder;
    const std::string path = folder.file("out.su2");
    EXPECT_THAT(write_mesh_data(mesh, path), ElementsAre(path + ": su2 cannot hold 1 nodal field(s) h",
                                                         path + ": su2 cannot hold a view"));
    EXPECT_THAT(test::read_text(path), testing::EndsWith("FFD_NBOX= 2\n"));
}

TEST(Su2, RefusesToWriteAMarkerNameThatItWouldNotReadBack)
{
    for (const std::string name : {"", " body", "body\t", "50%", "two\nlines", "SEND_RECEIVE"}) {
        MeshData mesh = test::uneven_square(1);
        mesh.markers[0].name = name;
        EXPECT_THROW(written(mesh, "su2"), InputError) << name;
    }
}

struct Broken {
    std::string from, to; ///< the change made to the square
    std::string message;
};

TEST(Su2, NamesLineAndFaultOfEveryBrokenFile)
{
    const std::vector<Broken> cases = {
        // numbers that are none
        {"5 0 1 2 0", "5 0 1 x 0", "file:3: expected vertex 3 of a triangle (type 5), element 0, found 'x'"},
        {"5 0 1 2 0", "5 0 -1 2 0",
         "file:3: expected vertex 2 of a triangle (type 5), element 0, found '-1'"},
        {"5 0 1 2 0", "5 0 1.5 2 0",
         "file:3: expected vertex 2 of a triangle (type 5), element 0, found '1.5'"},
        {"5 0 1 2 0", "5 0 1 99999999999 0",
         "file:3: expected vertex 3 of a triangle (type 5), element 0, found '99999999999'"},
        {"5 0 1 2 0", "5 0 1",
         "file:3: expected vertex 3 of a triangle (type 5), element 0, found the end of the line"},
        {"5 0 1 2 0", "9 0 1 2",
         "file:3: expected vertex 4 of a quad (type 9), element 0, found the end of the line"},
        {"5 0 1 2 0", "5 0 1 2 0 x",
         "file:3: expected a number or the end of the line after element 0, found 'x'"},
        {"5 0 1 2 0", "abc", "file:3: expected the type of element 0, found 'abc'"},
        {"1 0 1\n", "1 nan 1\n", "file:7: expected y of vertex 1, found 'nan'"},
        {"1 0 1\n", "1 -inf 1\n", "file:7: expected y of vertex 1, found '-inf'"},
        {"1 0 1\n", "1e999 0 1\n", "file:7: expected x of vertex 1, found '1e999'"},
        {"1 0 1\n", "12abc 0 1\n", "file:7: expected x of vertex 1, found '12abc'"},
        {"1 0 1\n", "1 1e-3x 1\n", "file:7: expected y of vertex 1, found '1e-3x'"},
        {"1 0 1\n", "1\n", "file:7: expected y of vertex 1, found the end of the line"},
        {"1 0 1\n", "1 0 one\n", "file:7: expected the id of vertex 1, found 'one'"},
        {"1 0 1\n", "1,0,1\n", "file:7: expected y of vertex 1, found ',0,1'"},
        {"1 0 1\n", std::string(100000, '7') + "x 0 1\n",
         "file:7: expected x of vertex 1, found '" + std::string(40, '7') + "...'"},
        // ids
        {"5 0 2 3 1", "5 0 2 4 1", "file:4: element 1 names vertex 4, but the mesh has 4"},
        {"5 0 2 3 1", "5 0 2147483647 4 1", "file:4: element 1 names vertex 2147483647, but the mesh has 4"},
        {"3 1 2\n", "3 1 4\n", "file:14: element 1 of the marker body names vertex 4, but the mesh has 4"},
        {"3 1 2\n", "1 9\n", "file:14: element 1 of the marker body names vertex 9, but the mesh has 4"},
        {"3 1 2\n", "3 1 -2\n", "file:14: expected vertex 2 of element 1 of the marker body, found '-2'"},
        {"0 0 0\n1 0 1", "0 0 1\n1 0 1", "file:7: vertex 1 has the id 1, which vertex 0 has already"},
        {"1 0 1\n", "1 0 4\n", "file:7: vertex 1 has the id 4, expected one from 0 to 3"},
        {"1 0 1\n", "1 0 -1\n", "file:7: vertex 1 has the id -1, expected one from 0 to 3"},
        // element types
        {"5 0 1 2 0", "10 0 1 2 3",
         "file:3: element 0 is a tetrahedron (type 10); supported are triangles (type 5) and quads (type 9)"},
        {"5 0 2 3 1", "12 0 1 2 3 0 1 2 3 1",
         "file:4: element 1 is a hexahedron (type 12); supported are triangles (type 5) and quads (type 9)"},
        {"5 0 2 3 1", "13 0 1 2 3 0 1",
         "file:4: element 1 is a prism (type 13); supported are triangles (type 5) and quads (type 9)"},
        {"5 0 2 3 1", "14 0 1 2 3 0",
         "file:4: element 1 is a pyramid (type 14); supported are triangles (type 5) and quads (type 9)"},
        {"5 0 2 3 1", "22 0 1 2 3 0 1",
         "file:4: element 1 is a quadratic triangle (type 22); supported are triangles (type 5) and quads "
         "(type 9)"},
        {"5 0 2 3 1", "3 0 1 1",
         "file:4: element 1 is an edge (type 3); supported are triangles (type 5) and quads (type 9)"},
        {"5 0 2 3 1", "77 0 1 1",
         "file:4: element 1 is of the unknown type 77; supported are triangles (type 5) and quads (type 9)"},
        {"3 1 2\n", "5 0 1 2\n",
         "file:14: element 1 of the marker body is a triangle (type 5); supported are edges (type 3)"},
        // counts
        {"NELEM= 2", "NELEM= 3", "file:2: NELEM= 3 but the section ends after 2, at NPOIN="},
        {"NELEM= 2", "NELEM= 2000000000",
         "file:2: NELEM= 2000000000 but the section ends after 2, at NPOIN="},
        {"NELEM= 2", "NELEM= 1", "file:4: expected a section such as NELEM=, found '5'"},
        {"NELEM= 2", "NELEM= -2", "file:2: expected a number of lines after NELEM=, found '-2'"},
        {"NELEM= 2", "NELEM= 99999999999",
         "file:2: expected a number of lines after NELEM=, found '99999999999'"},
        {"NELEM= 2", "NELEM=", "file:2: expected a number of lines after NELEM=, found the end of the line"},
        {"NELEM= 2", "NELEM= two", "file:2: expected a number of lines after NELEM=, found 'two'"},
        {"NELEM= 2", "NELEM= 2 x", "file:2: expected a number after NELEM= 2, found 'x'"},
        {"NPOIN= 4", "NPOIN= 5", "file:5: NPOIN= 5 but the section ends after 4, at NMARK="},
        {"NPOIN= 4", "NPOIN= 2147483647",
         "file:5: NPOIN= 2147483647 but the section ends after 4, at NMARK="},
        {"NPOIN= 4", "NPOIN= 3", "file:9: expected a section such as NELEM=, found '0'"},
        {"MARKER_ELEMS= 2", "MARKER_ELEMS= 3", "file:12: MARKER_ELEMS= 3 but the file ends after 2"},
        {"MARKER_ELEMS= 2", "MARKER_ELEMS= 2000000000",
         "file:12: MARKER_ELEMS= 2000000000 but the file ends after 2"},
        {"MARKER_ELEMS= 2", "MARKER_ELEMS= 1", "file:14: expected a section such as NELEM=, found '3'"},
        {"NMARK= 1", "NMARK= 2", "file:10: NMARK= 2, but the file has 1 marker(s)"},
        {"NMARK= 1", "NMARK= 0", "file:10: NMARK= 0, but the file has 1 marker(s)"},
        {"NMARK= 1\n", "", "file: NMARK= is missing, but the file has 1 marker(s)"},
        // sections
        {"NDIME= 2\n", "", "file: NDIME= is missing, so this is no SU2 mesh"},
        {"NDIME= 2", "NDIME= 7", "file:1: NDIME= 7, expected 2 or 3"},
        {"NDIME= 2", "NDIME= two", "file:1: expected 2 or 3 after NDIME=, found 'two'"},
        {"NDIME= 2", "NDIME= 2 2", "file:1: expected the end of the line after NDIME= 2, found '2'"},
        {"NPOIN= 4", "NDIME= 2\nNPOIN= 4", "file:5: NDIME= is given again, after line 1"},
        {"NMARK= 1", "NELEM= 0\nNMARK= 1", "file:10: NELEM= is given again, after line 2"},
        {"NMARK= 1", "NPOIN= 0\nNMARK= 1", "file:10: NPOIN= is given again, after line 5"},
        {"NMARK= 1", "NMARK= 1\nNMARK= 1", "file:11: NMARK= is given again, after line 10"},
        {"NDIME= 2", "NZONE= 3\nNDIME= 2", "file: NZONE= 3, but 0 zone(s) begin with IZONE="},
        {"MARKER_TAG= body\n", "", "file:11: MARKER_ELEMS= without a MARKER_TAG= before it"},
        {"MARKER_TAG= body",
         "MARKER_TAG= ", "file:11: expected a name after MARKER_TAG=, found the end of the line"},
        {"MARKER_ELEMS= 2\n", "", "file:12: expected MARKER_ELEMS= after MARKER_TAG= body, found '3'"},
        {"3 1 2\n", "3 1 2\n\x7f\x45LF\x02\x01\n",
         "file:15: expected a section such as NELEM=, found '?ELF?\?'"},
    };
    for (const Broken& broken : cases)
        EXPECT_EQ(test::refusal(replaced(kSquare, broken.from, broken.to), "su2"), broken.message);
}

TEST(Su2, RefusesFilesWithNothingInThem)
{
    EXPECT_EQ(test::refusal("", "su2"), "file: the file is empty");
    EXPECT_EQ(test::refusal("\n% NDIME= 2\n \n", "su2"), "file: NDIME= is missing, so this is no SU2 mesh");
    EXPECT_EQ(test::refusal("NDIME= 2\n", "su2"), "file: NELEM= is missing");
    EXPECT_EQ(test::refusal("NDIME= 2\nNELEM= 0\n", "su2"), "file: NPOIN= is missing");
    EXPECT_EQ(test::refusal("NDIME= 2\nNELEM= 1000000\n5 0 1 2\n", "su2"),
              "file:2: NELEM= 1000000 but the file ends after 1");
}

TEST(Su2, WantsThreeCoordinatesInSpace)
{
    const std::string square = replaced(kSquare, "NDIME= 2", "NDIME= 3");
    EXPECT_EQ(test::refusal(replaced(square, "1 0 1\n", "1 0\n"), "su2"),
              "file:7: expected z of vertex 1, found the end of the line");
}

TEST(Su2, RefusesEveryBeginningOfAFileThatEndsWithinASection)
{
    const std::size_t without_markers = kSquare.find("\n0 1 3\n") + 4; // behind "0 1", which needs no id
    for (std::size_t length = 0; length < kSquare.rfind("2\n"); ++length) {
        const bool whole = length >= without_markers && length <= kSquare.find("NMARK");
        EXPECT_EQ(test::refusal(kSquare.substr(0, length), "su2") == "accepted", whole) << length;
    }
}

TEST(Su2, RefusesRandomBytes)
{
    std::mt19937 random(1);
    for (int i = 0; i < 200; ++i) {
        std::string noise(1 + random() % 2000, '\0');
        for (char& byte : noise)
            byte = static_cast<char>(random());
        EXPECT_EQ(test::refusal(noise, "su2"), "file: NDIME= is missing, so this is no SU2 mesh");
        EXPECT_NE(test::refusal(kSquare.substr(0, i % kSquare.size()) + noise, "su2"), "accepted");
    }
}

TEST(Su2, SurvivesTwoThousandMutations)
{
    std::vector<std::string> seeds{kSquare};
    for (const std::string name : {"carried", "hybrid_crlf", "shuffled_ids", "surface", "triangles"})
        seeds.push_back(test::read_text(test::source_path("tests/fuzz/corpus/su2/") + name + ".su2"));
    test::survive_mutations("su2", seeds, 2000);
}

TEST(Su2, SurvivesSwappedLines)
{
    std::mt19937 random(5);
    for (int i = 0; i < 500; ++i) {
        std::vector<std::string> lines;
        std::istringstream in(kSquare);
        for (std::string line; std::getline(in, line);)
            lines.push_back(line + "\n");
        std::swap(lines[random() % lines.size()], lines[random() % lines.size()]);
        std::string text;
        for (const std::string& line : lines)
            text += line;
        const std::string refusal = test::refusal(text, "su2"); // throws on anything but an InputError
        EXPECT_TRUE(refusal == "accepted" || refusal.starts_with("file:")) << refusal;
    }
}

} // namespace
