// What PLY files hold, and what the reader refuses.
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"
#include "tests/support/surface_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace morph {

namespace {

using test::bare;
using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::small_surface;
using test::written;
using testing::ElementsAre;
using testing::HasSubstr;

using Edge = std::array<Index, 2>;

const std::string kPly =
    "ply\r\nformat ascii 1.0\r\ncomment made by hand\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty uchar red\nproperty double z\nelement edge 1\n"
    "property int vertex1\nproperty int vertex2\nelement face 1\n"
    "property list uchar float texcoord\nproperty list uint8 uint vertex_index\n"
    "property int region\nend_header\n0 0 255 0\n1 0 128 0\n\n1 1\t7 0.5\n0 1\n0 3 0 1 2 42\n";

TEST(Ply, ReadsOtherElementsAndTurnsPropertiesIntoFields)
{
    const MeshData mesh = read_bytes(kPly, "ply");
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}));
    EXPECT_EQ(mesh.points(2, 2), 0.5);
    ASSERT_EQ(mesh.fields.size(), 2U);
    EXPECT_EQ(mesh.fields[0].name, "red");
    EXPECT_EQ(mesh.fields[0].values(2, 0), 7);
    EXPECT_EQ(mesh.fields[1].name, "region");
    EXPECT_EQ(mesh.fields[1].location, FieldLocation::element);
    EXPECT_EQ(mesh.fields[1].values(0, 0), 42);
    ASSERT_EQ(mesh.markers.size(), 1U);
    EXPECT_EQ(mesh.markers[0].name, "edges");
    EXPECT_THAT(mesh.markers[0].edges, ElementsAre(Edge{0, 1}));
}

TEST(Ply, WritesTheTextOfTheSpecification)
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.groups = {{"upper side", {0, 1}}, {"100%", {1}}};
    mesh.markers = {{"wall ", {{0, 1}}}, {"", {}}};
    mesh.fields = {{"p", FieldLocation::vertex, Matrix::Constant(5, 1, 0.5)},
                   {"x", FieldLocation::vertex, Matrix::Constant(5, 1, -1)},
                   {"group", FieldLocation::element, Matrix::Constant(2, 2, 1e-3)}};
    EXPECT_EQ(written(mesh, "ply", {.binary = false}),
              "ply\nformat ascii 1.0\ncomment group 1 upper side\ncomment group 2 100%25\n"
              "comment marker 1 wall%20\ncomment marker 2 \ncomment vertex_field x_ 1 x\n"
              "comment face_field group_0_ 2 group\nelement vertex 5\nproperty double x\nproperty double y\n"
              "property double z\nproperty double p\nproperty double x_\nelement face 2\n"
              "property list uchar int vertex_indices\nproperty int group\nproperty int group_1\n"
              "property double group_0_\nproperty double group_1_\nelement edge 1\nproperty int vertex1\n"
              "property int vertex2\nproperty int marker\nend_header\n0 0 0 0.5 -1\n1 0 0 0.5 -1\n"
              "1 1 0 0.5 -1\n0 1 0 0.5 -1\n2 0.5 0 0.5 -1\n4 0 1 2 3 1 0 0.001 0.001\n"
              "3 1 4 2 1 2 0.001 0.001\n0 1 1\n");
}

TEST(Ply, HoldsEverythingBitForBit)
{
    for (const auto& [name, rich] : test::rich_meshes())
        for (const bool binary : {false, true}) {
            const MeshData mesh = test::with_groups(rich);
            const test::TemporaryFolder folder;
            EXPECT_THAT(write_mesh_data(mesh, folder.file("a.ply"), "", {.binary = binary}),
                        testing::IsEmpty());
            EXPECT_EQ(difference(read_mesh_data(folder.file("a.ply")), mesh), "") << name << binary;
        }
}

TEST(Ply, HoldsFieldsThatAreNoNumbers)
{
    MeshData mesh = small_surface();
    Matrix values(6, 1);
    values << std::nan(""), 1 / 0.0, -1 / 0.0, 0, 5e-324, -0.0;
    mesh.fields = {{"odd", FieldLocation::vertex, values}};
    for (const bool binary : {false, true})
        EXPECT_EQ(difference(read_bytes(written(mesh, "ply", {.binary = binary}), "ply"), mesh), "");
}

TEST(Ply, NumbersWithoutNamesGetSome)
{
    const MeshData mesh =
        read_bytes("ply\nformat ascii 1.0\ncomment group 3 hull\ncomment marker two 2\nelement vertex 3\n"
                   "property float x\nproperty float y\nelement face 2\nproperty int group\n"
                   "property list char short vertex_index\nproperty int group_1\nelement edge 3\n"
                   "property int marker\nproperty int vertex1\nproperty int vertex2\nend_header\n"
                   "0 0 1 0 0 1\n3 3 0 1 2 7\n0 3 0 2 1 7\n5 0 1 9 1 2\n5 2 0\n",
                   "ply");
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "hull");
    EXPECT_THAT(mesh.groups[0].elements, ElementsAre(0));
    EXPECT_EQ(mesh.groups[1].name, "group_7");
    EXPECT_THAT(mesh.groups[1].elements, ElementsAre(0, 1));
    ASSERT_EQ(mesh.markers.size(), 2U);
    EXPECT_EQ(mesh.markers[0].name, "marker_5");
    EXPECT_THAT(mesh.markers[0].edges, ElementsAre(Edge{0, 1}, Edge{2, 0}));
}

TEST(Ply, CommentsThatDoNotFitThePropertiesAreOnlyComments)
{
    const MeshData mesh =
        read_bytes("ply\nformat ascii 1.0\ncomment vertex_field u 3 velocity\n"
                   "comment vertex_field\ncomment face_field q 0 zero\ncomment\n"
                   "obj_info by hand\nelement vertex 3\nproperty float u\nproperty float v\n"
                   "property float x\nproperty float y\nelement face 1\n"
                   "property float q\nproperty list int int vertex_index\nend_header\n"
                   "1 2 0 0 1 2 1 0 1 2 0 1 7 3 0 1 2\n",
                   "ply");
    ASSERT_EQ(mesh.fields.size(), 2U);
    EXPECT_EQ(mesh.fields[0].name, "velocity"); // of the two properties before x
    EXPECT_EQ(mesh.fields[0].values.cols(), 2);
    EXPECT_EQ(mesh.fields[0].values(2, 1), 2);
    EXPECT_EQ(mesh.fields[1].name, "q");
}

TEST(Ply, NamesWhatItLeavesOut)
{
    ReadNotes notes;
    const std::string with_material =
        replaced(replaced(kPly, "element face", "element material 1\nproperty int k\nelement face"),
                 "0 1\n0 3", "0 1\n8\n0 3");
    find_format("", "ply").read({"file", with_material, {}, &notes});
    EXPECT_THAT(notes.warnings, ElementsAre("file: the element 'material' was left out",
                                            "file: the list 'texcoord' of the element 'face' was left out"));
    EXPECT_EQ(notes.version, "1.0, ASCII");
}

TEST(Ply, BigEndianFilesReadAlike)
{
    std::string ply =
        "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\n"
        "element face 1\nproperty list uchar ushort vertex_indices\nend_header\n";
    ply += std::string("\0\1\0\2\377\377\0\2\1\0\0\0", 12) + std::string("\3\0\0\0\1\0\2", 7);
    const MeshData mesh = read_bytes(ply, "ply");
    EXPECT_EQ(mesh.points.row(1), Eigen::RowVector3d(-1, 2, 0));
    EXPECT_EQ(mesh.points.row(2), Eigen::RowVector3d(256, 0, 0));
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}));
    EXPECT_EQ(mesh.dimension, 2);
}

TEST(Ply, RefusesBrokenTextWithTheLine)
{
    ASSERT_EQ(refusal(kPly, "ply"), "accepted");
    EXPECT_THAT(refusal(replaced(kPly, "ply\r", "plx\r"), "ply"), HasSubstr("file:1: expected 'ply'"));
    EXPECT_THAT(refusal(replaced(kPly, "ascii", "utf8"), "ply"), HasSubstr("file:2: expected ascii"));
    EXPECT_THAT(refusal(replaced(kPly, "vertex 3", "vertex 2000000000"), "ply"),
                HasSubstr("there should be 2000000000 rows of the element 'vertex', but only"));
    EXPECT_THAT(refusal(replaced(kPly, "vertex 3", "vertex -3"), "ply"),
                HasSubstr("file:4: expected the number of rows"));
    EXPECT_THAT(refusal(replaced(kPly, "float x", "half x"), "ply"),
                HasSubstr("file:5: expected a type of numbers"));
    EXPECT_THAT(refusal(replaced(kPly, "float x", "float w"), "ply"),
                HasSubstr("vertices have no coordinates x and y"));
    EXPECT_THAT(refusal(replaced(kPly, "end_header", "end"), "ply"),
                HasSubstr("file:16: expected a line of a PLY header"));
    EXPECT_EQ(refusal(replaced(kPly, "1 1\t7", "1 nan 7"), "ply"),
              "file:20: a coordinate of vertex 2 is not finite");
    EXPECT_EQ(refusal(replaced(kPly, " 42", ""), "ply"),
              "file:23: expected a number, found the end of the file");
    EXPECT_THAT(refusal(replaced(kPly, "0 1 2 42", "0 1 3 42"), "ply"),
                HasSubstr("face 0 names vertex 3, but the mesh has 3"));
    EXPECT_THAT(refusal(replaced(kPly, "0 1 2 42", "0 1 1.5 42"), "ply"),
                HasSubstr("file:22: face 0 has a corner that is no"));
    EXPECT_THAT(refusal(replaced(kPly, "3 0 1 2", "2 0 1 2"), "ply"),
                HasSubstr("file:22: face 0 has 2 corners"));
    EXPECT_THAT(refusal(replaced(kPly, "3 0 1 2", "-1 0 1 2"), "ply"), HasSubstr("impossible length"));
    EXPECT_THAT(refusal(replaced(kPly, "edge 1", "vertex 1"), "ply"),
                HasSubstr("more than one element 'vertex'"));
    EXPECT_EQ(refusal(replaced(kPly, "\n0 1\n0 3", "\n0 3\n0 3"), "ply"),
              "file: edge 0 of the marker 'edges' names vertex 3, but the mesh has 3");
    EXPECT_EQ(refusal(replaced(kPly, "\n0 1\n0 3", "\n0 -1\n0 3"), "ply"),
              "file: edge 0 has a vertex or marker that is no number of one");
    EXPECT_THAT(refusal(replaced(kPly, "list uint8 uint vertex_index", "uint vertex_index"), "ply"),
                HasSubstr("the property 'vertex_index' of faces is no list"));
}

TEST(Ply, RefusesBrokenBytesWithTheirPlace)
{
    const std::string ply = written(small_surface(), "ply");
    const std::size_t data = ply.find("end_header\n") + 11;
    EXPECT_THAT(refusal(ply.substr(0, ply.size() - 1), "ply"),
                HasSubstr("the file ends within its rows; it is cut off"));
    EXPECT_THAT(refusal(ply.substr(0, data + 30), "ply"), HasSubstr("rows of the element 'vertex'"));
    std::string broken = ply;
    broken.replace(data + 8, 8, "\xff\xff\xff\xff\xff\xff\xff\x7f");
    EXPECT_EQ(refusal(broken, "ply"),
              "file: byte " + std::to_string(data + 8) + ": a coordinate of vertex 0 is not finite");
    broken = ply;
    broken[data + std::size_t{6} * 24] = '\x7f';
    EXPECT_THAT(refusal(broken, "ply"),
                HasSubstr("a list of the property 'vertex_indices' has an impossible length"));
}

TEST(Ply, SurvivesMutations)
{
    MeshData mesh = test::with_groups(small_surface());
    mesh.markers = {{"a b", {{0, 1}, {1, 2}}}, {"c", {}}};
    mesh.fields = {{"p q", FieldLocation::vertex, Matrix::Random(6, 3)},
                   {"r", FieldLocation::element, Matrix::Random(3, 2)}};
    test::survive_mutations("ply", {written(mesh, "ply"), written(mesh, "ply", {.binary = false}), kPly},
                            2000);
}

} // namespace

} // namespace morph
