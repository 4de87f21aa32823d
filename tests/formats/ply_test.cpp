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
    EXPECT_EQ(refusal(replaced(kPly, "1 1\t7", "1 nan 7"), "ply"), "file:20: expected a number, found 'nan'");
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

} // namespace

} // namespace morph
