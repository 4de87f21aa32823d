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

using Edge = std::array<Index, 2>;

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
    ASSERT_EQ(mesh.groups.size(), 4U); // of the object, the groups and the material
    for (std::size_t g = 0; g < 4; ++g) {
        EXPECT_EQ(mesh.groups[g].name, (std::array<std::string, 4>{"wing", "left", "right", "red"}[g]));
        EXPECT_THAT(mesh.groups[g].elements, ElementsAre(0, 1));
    }
    ASSERT_EQ(mesh.markers.size(), 2U);
    EXPECT_EQ(mesh.markers[1].name, "right");
    EXPECT_THAT(mesh.markers[1].edges, ElementsAre(Edge{0, 1}));
}

TEST(Obj, WritesTheTextOfTheSpecification)
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.groups = {{"upper side", {1}}, {"all", {0, 1}}};
    mesh.markers = {{"50% #1", {{0, 1}, {1, 4}}}, {"", {{2, 3}}}};
    Matrix colors(5, 3);
    colors.setConstant(0.5);
    mesh.fields = {{"color", FieldLocation::vertex, colors}};
    EXPECT_EQ(written(mesh, "obj"),
              "v 0 0 0 0.5 0.5 0.5\nv 1 0 0 0.5 0.5 0.5\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0 0.5 0.5 0.5\n"
              "v 2 0.5 0 0.5 0.5 0.5\ng all\nf 1 2 3 4\ng upper%20side all\nf 2 5 3\ng 50%25%20%231\nl 1 2\n"
              "l 2 5\ng %\nl 3 4\n");
    mesh.fields.clear();
    mesh.groups.clear();
    mesh.markers.clear();
    EXPECT_EQ(written(mesh, "obj"), "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0.5 0\nf 1 2 3 4\nf 2 5 3\n");
}

TEST(Obj, MarkersGroupsAndColoursComeBackBitForBit)
{
    for (auto& [name, rich] : test::rich_meshes()) {
        MeshData mesh = test::with_groups(rich);
        std::erase_if(mesh.fields, [](const Field& field) { return field.name != "v3"; });
        for (Field& field : mesh.fields)
            field.name = "color";
        if (name == "odd markers") { // one has no edges, and two have one name
            std::erase_if(mesh.markers, [](const Marker& marker) { return marker.edges.empty(); });
            mesh.markers.pop_back();
        }
        const test::TemporaryFolder folder;
        EXPECT_THAT(write_mesh_data(mesh, folder.file("a.obj")), testing::IsEmpty()) << name;
        EXPECT_EQ(difference(read_mesh_data(folder.file("a.obj")), mesh), "") << name;
    }
}

TEST(Obj, NamesWhatItCannotHold)
{
    const test::TemporaryFolder folder;
    MeshData mesh = small_surface();
    mesh.markers = {{"a", {{0, 1}}}, {"b", {}}, {"a", {{1, 2}}}};
    mesh.groups = {{"g", {0}}, {"g", {1}}, {"h", {}}};
    mesh.fields = {{"p", FieldLocation::vertex, Matrix::Zero(6, 1)},
                   {"color", FieldLocation::vertex, Matrix::Zero(6, 2)},
                   {"q", FieldLocation::element, Matrix::Zero(3, 3)}};
    EXPECT_THAT(write_mesh_data(mesh, folder.file("a.obj")),
                ElementsAre(HasSubstr("obj cannot hold 1 element field(s) q"),
                            HasSubstr("obj cannot hold 2 nodal field(s) p, color, only one of 3 components"),
                            HasSubstr("obj cannot hold the marker 'b', which is empty"),
                            HasSubstr("obj cannot hold two markers of the name 'a' apart"),
                            HasSubstr("obj cannot hold two groups of the name 'g' apart"),
                            HasSubstr("obj cannot hold the group 'h', which is empty")));
}

TEST(Obj, LinesOfObjectsOrOfNothingAreMarkersToo)
{
    const MeshData mesh = read_bytes("v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\no body\nl -3//1 -2/1\n"
                                     "g\nusemtl skin\nl 3 1\nf 1 2 3\n",
                                     "obj");
    ASSERT_EQ(mesh.markers.size(), 2U);
    EXPECT_EQ(mesh.markers[0].name, "lines");
    EXPECT_THAT(mesh.markers[0].edges, ElementsAre(Edge{0, 1}, Edge{1, 2}));
    EXPECT_EQ(mesh.markers[1].name, "body");
    EXPECT_THAT(mesh.markers[1].edges, ElementsAre(Edge{0, 1}, Edge{2, 0}));
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "body");
    EXPECT_EQ(mesh.groups[1].name, "skin");
}

TEST(Obj, NamesOfTwoKindsAreOneGroupAndGoOnWhereTheyComeAgain)
{
    const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    const MeshData mesh =
        read_bytes(square + "o a\ng a b a\nf 1 2 3\ng b\n\n\tf\t1 3 4\ng nothing\no\ng a\nf 2 3 4\n", "obj");
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "a");
    EXPECT_THAT(mesh.groups[0].elements, ElementsAre(0, 1, 2));
    EXPECT_THAT(mesh.groups[1].elements, ElementsAre(0, 1));
}

TEST(Obj, ColoursAreAFieldOnlyWhereEveryVertexHasOne)
{
    ReadNotes notes;
    const auto read = [&](const std::string& bytes) {
        return find_format("", "obj").read({"file", bytes, {}, &notes});
    };
    MeshData mesh = read("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 1 0.25 0.5 1\nf 1 2 3\n");
    ASSERT_EQ(mesh.fields.size(), 1U);
    EXPECT_EQ(mesh.fields[0].values.row(0), Eigen::RowVector3d(1, 0, 0));
    EXPECT_EQ(mesh.fields[0].values.row(2), Eigen::RowVector3d(0.25, 0.5, 1)); // behind the weight 1
    EXPECT_THAT(notes.warnings, testing::IsEmpty());
    mesh = read("v 0 0 0 1 0 0\nv 1 0 0 2\nv 1 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    EXPECT_TRUE(mesh.fields.empty());
    EXPECT_THAT(notes.warnings,
                ElementsAre(HasSubstr("file: colours were left out, which only 1 of 3 vertices have"),
                            HasSubstr("statements vn were"), HasSubstr("weights of vertices were")));
}

TEST(Obj, RefusesBrokenFilesWithTheLine)
{
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";
    ASSERT_EQ(refusal(obj, "obj"), "accepted");
    EXPECT_EQ(refusal(replaced(obj, "1 3 4", "1 3 5"), "obj"),
              "file:6: a face or line names vertex 5, but the mesh has 4");
    EXPECT_EQ(refusal(replaced(obj, "1 3 4", "1 3 -5"), "obj"),
              "file:6: a face or line names vertex -5, but there are 4 so far, numbered from 1");
    EXPECT_THAT(refusal(replaced(obj, "1 3 4", "1 0 4"), "obj"),
                HasSubstr("file:6: a face or line names vertex 0"));
    EXPECT_THAT(refusal(replaced(obj, "1 3 4", "1 3 99999999999"), "obj"),
                HasSubstr("file:6: a face or line names"));
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
    EXPECT_EQ(refusal(replaced(obj, "f 1 3 4", "l 1"), "obj"),
              "file:6: a line of 1 vertices, expected 2 or more");
    EXPECT_EQ(refusal(replaced(obj, "f 1 3 4", "l 1 5"), "obj"),
              "file:6: a face or line names vertex 5, but the mesh has 4");
    std::string names = "g";
    for (int i = 0; i < 65; ++i)
        names += " " + std::to_string(i);
    EXPECT_EQ(refusal(replaced(obj, "f 1 3 4", names), "obj"),
              "file:6: a statement g with 65 names, expected at most 64");
}

TEST(Obj, SurvivesMutations)
{
    MeshData mesh = test::with_groups(small_surface());
    mesh.markers = {{"a b", {{0, 1}, {1, 2}}}};
    mesh.fields = {{"color", FieldLocation::vertex, Matrix::Random(6, 3)}};
    test::survive_mutations("obj",
                            {written(mesh, "obj"), "v 0 0 0\nv 1 0 \\\n0\nv 1 1 0 1\no x\ng a b\n"
                                                   "usemtl m\nf -1/1/1 -2//2 -3\nl 1 2 3\n"},
                            2000);
}

} // namespace

} // namespace morph
