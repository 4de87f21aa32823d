// OFF, OBJ, PLY and STL: what they share, and what each refuses.
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::written;
using testing::ElementsAre;
using testing::HasSubstr;

/// The mesh without what these formats have no place for.
MeshData bare(MeshData mesh)
{
    mesh.markers.clear();
    mesh.fields.clear();
    return mesh;
}

/// A quad and two triangles in space; the vertices appear in the order of their numbers.
MeshData small_surface()
{
    MeshData mesh;
    mesh.dimension = 3;
    mesh.points.resize(6, 3);
    mesh.points << 0, 0, 0, 1, 0, 0.1, 1, 1, -1.0 / 3, 0, 1, 1e-300, 2, 0, 7, 2, 1, 1e22;
    mesh.elements = {{0, 1, 2, 3}, {1, 4, 2, -1}, {4, 5, 2, -1}};
    return mesh;
}

TEST(SurfaceFormats, OffObjAndPlyHoldEverySurfaceBitForBit)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        for (const char* format : {"off", "obj", "ply"})
            for (const bool binary : {false, true})
                EXPECT_EQ(
                    difference(bare(mesh), read_bytes(written(mesh, format, {.binary = binary}), format)), "")
                    << name << " as " << format;
}

TEST(SurfaceFormats, RealMeshesComeBackBitForBit)
{
    for (const std::string& path : test::real_meshes()) {
        const MeshData mesh = bare(read_mesh_data(path));
        for (const char* format : {"off", "obj", "ply"})
            EXPECT_EQ(difference(mesh, read_bytes(written(mesh, format), format)), "")
                << path << " as " << format;
    }
}

TEST(SurfaceFormats, SurviveMutatedFiles)
{
    for (const char* format : {"off", "obj", "ply", "stl"})
        test::survive_mutations(format,
                                {written(small_surface(), format, {.binary = false}),
                                 written(bare(test::quad_square(3)), format)},
                                600);
}

TEST(SurfaceFormats, FilesWithOneStrayByteOrNoneAreRefusedOrEmpty)
{
    for (const char* format : {"off", "ply", "stl"}) {
        EXPECT_THAT(refusal("", format), HasSubstr("file")) << format;
        EXPECT_THAT(refusal(std::string("\0\x7f\xff\x01 noise", 10), format), HasSubstr("file")) << format;
    }
    EXPECT_THAT(refusal(std::string("\0\x7f\xff\x01 noise", 10), "obj"),
                HasSubstr("file:1: expected an OBJ"));
    EXPECT_EQ(read_bytes("", "obj").points.rows(), 0);
}

struct DoubleTraits : OpenMesh::DefaultTraitsDouble {};
using OpenMeshMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

/// OpenMesh reads coordinates in single precision: 2^-24 of them may be lost.
constexpr double kSinglePrecision = 6e-8;

TEST(SurfaceFormats, OpenMeshReadsWhatWeWrite)
{
    const test::TemporaryFolder folder;
    const MeshData mesh = bare(test::quad_square(4));
    for (const std::string format : {"off", "obj", "ply"}) {
        const std::string path = folder.write("mesh." + format, written(mesh, format));
        OpenMeshMesh other;
        ASSERT_TRUE(OpenMesh::IO::read_mesh(other, path)) << format;
        ASSERT_EQ(static_cast<Eigen::Index>(other.n_vertices()), mesh.points.rows()) << format;
        for (const auto v : other.vertices())
            for (unsigned k = 0; k < 3; ++k)
                EXPECT_NEAR(other.point(v)[k], mesh.points(v.idx(), k), kSinglePrecision) << format;
        ASSERT_EQ(other.n_faces(), mesh.elements.size()) << format;
        for (const auto f : other.faces()) {
            std::vector<Index> corners;
            for (const auto v : other.fv_range(f))
                corners.push_back(v.idx());
            const Element& element = mesh.elements[static_cast<std::size_t>(f.idx())];
            EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), element.begin())) << format;
        }
    }
}

TEST(SurfaceFormats, WeReadWhatOpenMeshWrites)
{
    const test::TemporaryFolder folder;
    const MeshData mesh = bare(test::quad_square(4));
    OpenMeshMesh other;
    for (const auto& row : mesh.points.rowwise())
        other.add_vertex({row(0), row(1), row(2)});
    for (const Element& e : mesh.elements)
        other.add_face(other.vertex_handle(static_cast<unsigned>(e[0])),
                       other.vertex_handle(static_cast<unsigned>(e[1])),
                       other.vertex_handle(static_cast<unsigned>(e[2])),
                       other.vertex_handle(static_cast<unsigned>(e[3])));
    for (const std::string format : {"off", "obj", "ply"})
        for (const bool binary : {false, true}) {
            if (binary && format != "ply")
                continue;
            const std::string path = folder.file("mesh." + format);
            ASSERT_TRUE(OpenMesh::IO::write_mesh(
                other, path, binary ? OpenMesh::IO::Options::Binary : OpenMesh::IO::Options::Default, 17));
            const MeshData read = read_mesh_data(path);
            EXPECT_EQ(read.elements, mesh.elements) << format;
            EXPECT_LE((read.points - mesh.points).cwiseAbs().maxCoeff(), kSinglePrecision) << format;
        }
}

TEST(SurfaceFormats, ReadTheSphereThatVtkWrote)
{
    constexpr double digits = 1e-5; // the OBJ and ASCII files have 6 significant digits
    for (const char* name :
         {"sphere.obj", "sphere_ascii.ply", "sphere_binary.ply", "sphere_ascii.stl", "sphere_binary.stl"}) {
        const MeshData mesh = read_mesh_data(test::data_path(std::string("vtk/") + name));
        EXPECT_EQ(mesh.dimension, 3) << name;
        EXPECT_EQ(mesh.points.rows(), 20) << name;
        EXPECT_EQ(mesh.elements.size(), 36U) << name;
        EXPECT_LE((mesh.points.rowwise().norm().array() - 0.5).abs().maxCoeff(), digits) << name;
    }
}

// --- OFF

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

// --- OBJ

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

// --- PLY

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

// --- STL

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
    EXPECT_THAT(refusal(replaced(stl, "endsolid mesh\n", ""), "stl"),
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
