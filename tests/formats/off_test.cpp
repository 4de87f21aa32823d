// What OFF files hold, and what the reader refuses.
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

const std::string kOff =
    "# made by hand\r\nCOFF 3 1 3\r\n\r\n0 0\t0 255 0 0\n+1 0 0 1 0 0 # red\n\n 1 1.0D0 .5\n"
    "3\t0 1\n2 0.5 0.5 0.5\n\n# the end\n";

TEST(Off, ReadsCommentsColoursTabsAndForeignLineEnds)
{
    const MeshData mesh = read_bytes(kOff, "off");
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}));
    EXPECT_EQ(mesh.points(2, 2), 0.5);
    EXPECT_EQ(mesh.dimension, 3);
}

TEST(Off, RefusesBrokenFilesWithTheLine)
{
    const std::string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";
    ASSERT_EQ(refusal(off, "off"), "accepted");
    EXPECT_EQ(refusal(replaced(off, "3 0 2 3\n", ""), "off"),
              "file:8: expected the number of corners of face 1, found the end of the file");
    EXPECT_THAT(refusal(replaced(off, "4 2 0", "4 1 0"), "off"),
                HasSubstr("file:8: expected the end of the file"));
    EXPECT_THAT(refusal(replaced(off, "4 2 0", "5 2 0"), "off"),
                HasSubstr("file:9: expected the number of corners of face 1"));
    EXPECT_EQ(refusal(replaced(off, "4 2 0", "2000000000 2 0"), "off"),
              "file:2: the number of vertices is 2000000000, but only 45 bytes follow");
    EXPECT_THAT(refusal(replaced(off, "4 2 0", "-4 2 0"), "off"),
                HasSubstr("file:2: expected the number of vertices"));
    EXPECT_EQ(refusal(replaced(off, "2 3\n", "2 4\n"), "off"),
              "file:8: face 1 names vertex 4, but the mesh has 4");
    EXPECT_EQ(refusal(replaced(off, "1 1 0", "1 nan 0"), "off"),
              "file:5: expected a coordinate of vertex 2, found 'nan'");
    EXPECT_THAT(refusal(replaced(off, "1 1 0", "1 1e999 0"), "off"), HasSubstr("file:5"));
    EXPECT_EQ(refusal(replaced(off, "3 0 2 3", "5 0 1 2 3 0"), "off"),
              "file:8: a face of 5 corners, but only triangles and quads are supported");
    EXPECT_THAT(refusal(replaced(off, "3 0 2 3", "999999999 2 3"), "off"),
                HasSubstr("file:9: expected a corner"));
    EXPECT_THAT(refusal(replaced(off, "OFF", "4OFF"), "off"), HasSubstr("file:1: expected OFF"));
    EXPECT_THAT(refusal(replaced(off, "OFF", "OFF BINARY"), "off"),
                HasSubstr("binary OFF files are not supported"));
}

} // namespace

} // namespace morph
