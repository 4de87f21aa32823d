// What OBJ files hold, and what the reader refuses.
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

TEST(Obj, ReadsNegativeNumbersTextureNormalsAndContinuedLines)
{
    const MeshData mesh =
        read_bytes("# made by hand\r\nmtllib a.mtl\r\no wing\r\nv 0 0 0\nv 1 0 0 1.0\nv\t1 1 2 0.5 0.5 0.5\n"
                   "vt 0 0\nvn 0 0 1\ng left right\nusemtl red\ns off\nf 1/1/1 2//1 3/1\nv 0 \\\n 1 0\n"
                   "f -4 -2 \\\r\n-1 # a comment\nl 1 2\np 1\n",
                   "obj");
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}, Element{0, 2, 3, -1}));
    EXPECT_EQ(mesh.points.rows(), 4);
    EXPECT_EQ(mesh.points(3, 1), 1);
}

TEST(Obj, RefusesBrokenFilesWithTheLine)
{
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    ASSERT_EQ(refusal(obj, "obj"), "accepted");
    EXPECT_EQ(refusal(replaced(obj, "1 3 4", "1 3 5"), "obj"),
              "file:6: a face names vertex 5, but the mesh has 4");
    EXPECT_EQ(refusal(replaced(obj, "1 3 4", "1 3 -5"), "obj"),
              "file:6: a face names vertex -5, but there are 4 so far, numbered from 1");
    EXPECT_THAT(refusal(replaced(obj, "1 3 4", "1 0 4"), "obj"), HasSubstr("file:6: a face names vertex 0"));
    EXPECT_THAT(refusal(replaced(obj, "1 3 4", "1 3 99999999999"), "obj"), HasSubstr("file:6: a face names"));
    EXPECT_EQ(refusal(replaced(obj, "1 3 4", "1 3"), "obj"),
              "file:6: a face of 2 corners, but only triangles and quads are supported");
    EXPECT_THAT(refusal(replaced(obj, "1 3 4", "1 3 4 2 1"), "obj"),
                HasSubstr("file:6: a face of 5 corners"));
    EXPECT_EQ(refusal(replaced(obj, "1 3 4", "1 three 4"), "obj"),
              "file:6: expected the number of a vertex, found 'three'");
    EXPECT_EQ(refusal(replaced(obj, "v 1 1 0", "v 1 1"), "obj"),
              "file:3: expected a coordinate of vertex 3, found the end of the line");
    EXPECT_THAT(refusal(replaced(obj, "v 1 1 0", "v 1 inf 0"), "obj"),
                HasSubstr("file:3: expected a coordinate"));
    EXPECT_THAT(refusal(replaced(obj, "f 1 2 3", "surf 1 2 3"), "obj"),
                HasSubstr("file:5: expected an OBJ statement"));
}

} // namespace

} // namespace morph
