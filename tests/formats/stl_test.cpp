// What STL files hold, and what the reader refuses.
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

TEST(Stl, JoinsEqualCornersInTheOrderOfTheirAppearance)
{
    const MeshData mesh =
        read_bytes("  SOLID wing, upper side\r\n FACET NORMAL nan nan nan\n outer loop\n vertex 0 0 0\n"
                   "vertex 1e0 0 0\nvertex 1 1 0\nendloop endfacet\n\nfacet normal 0 0 1\nouter loop\n"
                   "vertex -0 0 0\nvertex 1 1 0\n\tvertex 0 1 0.5\nendloop\nendfacet\nendsolid wing\n"
                   "solid\nendsolid\n",
                   "stl");
    EXPECT_EQ(mesh.points.rows(), 4);
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}, Element{0, 2, 3, -1}));
    ASSERT_EQ(mesh.groups.size(), 1U);
    EXPECT_EQ(mesh.groups[0].name, "wing, upper side");
    EXPECT_THAT(mesh.groups[0].elements, ElementsAre(0, 1));
}

TEST(Stl, WritesTheTextOfTheSpecification)
{
    MeshData mesh;
    mesh.points.resize(4, 3);
    mesh.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    mesh.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}};
    mesh.groups = {{"lower 100%", {1}}};
    EXPECT_EQ(written(mesh, "stl", {.binary = false}),
              "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
              "endfacet\nendsolid\nsolid lower 100%25\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
              "vertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid lower 100%25\n");
}

TEST(Stl, SolidsOfOneNameAreOneGroupAndNoOtherChangesTheOrderOfElements)
{
    MeshData mesh = bare(test::uneven_square(3));
    mesh.groups = {{"even", {}}, {"every fourth", {}}};
    for (Index e = 0; e < 18; e += 2)
        mesh.groups[e % 4 == 0 ? 1 : 0].elements.push_back(e);
    MeshData back = read_bytes(written(mesh, "stl", {.binary = false}), "stl");
    ASSERT_EQ(back.groups.size(), 2U);
    EXPECT_EQ(back.groups[1].name, "even"); // groups in the order of their first element
    EXPECT_EQ(back.groups[1].elements, mesh.groups[0].elements);
    EXPECT_EQ(back.groups[0].elements, mesh.groups[1].elements);
    for (std::size_t e = 0; e < mesh.elements.size(); ++e)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(back.points.row(back.elements[e][k]), mesh.points.row(mesh.elements[e][k]));
}

TEST(Stl, SaysWhichGroupsAreLost)
{
    const test::TemporaryFolder folder;
    MeshData mesh = small_surface();
    mesh.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}, {1, 4, 2, -1}, {4, 5, 2, -1}};
    mesh.groups = {{"a", {0, 1}}, {"b", {1, 2}}, {"", {3}}, {"c", {}}};
    EXPECT_THAT(
        write_mesh_data(mesh, folder.file("a.stl"), "", {.binary = false}),
        ElementsAre(HasSubstr("stl cannot hold 1 element(s) of group 'b', which are in another group too"),
                    HasSubstr("stl cannot hold a group without a name"),
                    HasSubstr("stl cannot hold the group 'c', which has no elements")));
    EXPECT_THAT(write_mesh_data(mesh, folder.file("a.stl")),
                testing::Contains(
                    HasSubstr("4 group(s) of elements a, b, , c in its binary form; write it as text")));
}

TEST(Stl, JoinsNothingButEqualCornersHoweverManyThereAre)
{
    // 40,000 distinct points, where a closed surface of as many triangles has 10,000: the table of the
    // welder has to grow.
    MeshData mesh;
    const Index pairs = 10000;
    mesh.points.resize(4 * pairs, 3);
    for (Index p = 0; p < pairs; ++p) {
        const double x = 0.1 * p;
        mesh.points.middleRows(4 * p, 4) << x, 0, 0, x + 0.05, 0, 0, x + 0.05, 1, 0, x, 1, -0.0;
        mesh.elements.push_back({4 * p, 4 * p + 1, 4 * p + 2, -1});
        mesh.elements.push_back({4 * p, 4 * p + 2, 4 * p + 3, -1});
    }
    EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "stl", {.binary = false}), "stl")), "");
}

TEST(Stl, WarnsOfAttributeBytes)
{
    std::string bytes = written(small_surface(), "stl");
    bytes[84 + 48] = 'x';
    ReadNotes notes;
    find_format("", "stl").read({"file", bytes, {}, &notes});
    EXPECT_THAT(notes.warnings, ElementsAre(HasSubstr("file: the attribute bytes of 1 triangle(s)")));
    EXPECT_EQ(notes.version, "binary");
}

TEST(Stl, HoldsTrianglesAsTextBitForBitAndAsBytesInSinglePrecision)
{
    MeshData mesh = small_surface();
    mesh.elements = {{0, 1, 2, -1}, {0, 2, 3, -1}, {1, 4, 2, -1}, {4, 5, 2, -1}};
    EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "stl", {.binary = false}), "stl")), "");
    MeshData rounded = mesh;
    rounded.points = mesh.points.cast<float>().cast<double>();
    EXPECT_EQ(difference(rounded, read_bytes(written(mesh, "stl"), "stl")), "");
}

TEST(Stl, CutsQuadsAlongTheShorterDiagonalAndSaysWhatIsLost)
{
    const test::TemporaryFolder folder;
    MeshData mesh = small_surface();
    EXPECT_THAT(write_mesh_data(mesh, folder.file("a.stl")),
                ElementsAre(HasSubstr("stl cannot hold quads: 1 are cut into triangles"),
                            HasSubstr("stl cannot hold the numbers of vertices"),
                            HasSubstr("double precision")));
    EXPECT_EQ(read_mesh_data(folder.file("a.stl")).elements.size(), 4U);
    mesh.points.row(2) << 3, 3, 0;
    const MeshData cut = read_bytes(written(mesh, "stl", {.binary = false}), "stl");
    EXPECT_EQ(cut.elements[0], (Element{0, 1, 2, -1})); // the corners 0, 1, 3 of the quad
    EXPECT_EQ(cut.points.row(2), mesh.points.row(3));
    mesh.elements = {{2, 1, 0, -1}};
    EXPECT_THAT(write_mesh_data(mesh, folder.file("b.stl"), "", {.binary = false}),
                ElementsAre(HasSubstr("stl cannot hold the numbers of vertices")));
}

TEST(Stl, RefusesBrokenTextWithTheLine)
{
    const std::string stl = written(small_surface(), "stl", {.binary = false});
    ASSERT_EQ(refusal(stl, "stl"), "accepted");
    EXPECT_EQ(refusal(replaced(stl, "solid", "olid"), "stl").rfind("file:", 0), 0U);
    EXPECT_THAT(refusal(replaced(stl, "outer", "inner"), "stl"),
                HasSubstr("file:3: expected 'outer', found 'inner'"));
    EXPECT_THAT(refusal(replaced(stl, "vertex 0 0 0", "vertex 0 0"), "stl"),
                HasSubstr("file:4: expected a coordinate, found the end of the line"));
    EXPECT_THAT(refusal(replaced(stl, "vertex 0 0 0", "vertex 0 nan 0"), "stl"),
                HasSubstr("file:4: expected a coordinate"));
    EXPECT_THAT(refusal(replaced(stl, "vertex 0 0 0", "vertex 0 0 0\nvertex 5 5 5"), "stl"),
                HasSubstr("file:7: expected 'endloop', found 'vertex'"));
    EXPECT_THAT(refusal(replaced(stl, "vertex 0 0 0\n", ""), "stl"), HasSubstr("file:6: expected 'vertex'"));
    EXPECT_THAT(refusal(replaced(stl, "endsolid\n", ""), "stl"),
                HasSubstr("expected 'facet', found the end of the file"));
    EXPECT_THAT(refusal(stl + "noise", "stl"), HasSubstr("expected 'solid', found 'noise'"));
}

TEST(Stl, RefusesBrokenBytesWithTheirPlace)
{
    const std::string stl = written(small_surface(), "stl");
    EXPECT_EQ(refusal(stl.substr(0, stl.size() - 3), "stl"),
              "file: byte 80: a binary STL file of 4 triangles has 284 bytes, but this has 281");
    EXPECT_THAT(refusal(stl.substr(0, 60), "stl"), HasSubstr("at least 84 bytes"));
    std::string broken = stl;
    broken.replace(80, 4, "\xff\xff\xff\xff");
    EXPECT_THAT(refusal(broken, "stl"),
                HasSubstr("a binary STL file of 4294967295 triangles has 214748364834 bytes"));
    broken = stl;
    broken.replace(84 + 12, 4, std::string("\0\0\x80\x7f", 4));
    EXPECT_EQ(refusal(broken, "stl"), "file: byte 96: a coordinate of triangle 0 is not finite");
    MeshData large = small_surface();
    large.points(0, 0) = 1e300;
    const test::TemporaryFolder folder;
    EXPECT_THROW(write_mesh_data(large, folder.file("large.stl")), InputError);
    EXPECT_TRUE(folder.names().empty());
}

} // namespace

} // namespace morph
