// OpenMesh's .om: what it holds, what the reader refuses, and what OpenMesh itself says.
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"
#include "tests/support/surface_cases.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::small_surface;
using test::written;
using testing::ElementsAre;
using testing::HasSubstr;

struct DoubleTraits : OpenMesh::DefaultTraitsDouble {};
using OpenMeshMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;

TEST(Om, HoldsEverythingBitForBit)
{
    for (const auto& [name, rich] : test::rich_meshes()) {
        const MeshData mesh = test::with_groups(rich);
        const test::TemporaryFolder folder;
        EXPECT_THAT(write_mesh_data(mesh, folder.file("a.om")), testing::IsEmpty()) << name;
        EXPECT_EQ(difference(read_mesh_data(folder.file("a.om")), mesh), "") << name;
    }
}

TEST(Om, WritesTheBytesOfTheFormat)
{
    MeshData mesh;
    mesh.points.resize(3, 3);
    mesh.points << 0, 0, 0, 1, 0, 0, 0, 2, 0;
    mesh.elements = {{0, 1, 2, -1}};
    const std::string one("\0\0\0\0\0\0\xf0\x3f", 8);
    const std::string two("\0\0\0\0\0\0\0\x40", 8);
    const std::string zero(8, '\0');
    std::string bytes("OMT\x22\3\0\0\0\1\0\0\0\0\0\0\0", 16);
    bytes += std::string("\x00\x56", 2) + zero + zero + zero + one + zero + zero + zero + two + zero;
    bytes += std::string("\xe8\x80\0\0\0\0\1\0\0\0\2\0\0\0", 14);
    EXPECT_EQ(written(mesh, "om"), bytes);
    mesh.fields = {{"p", FieldLocation::vertex, Matrix::Constant(3, 1, 2)}};
    bytes += std::string("\xc2\0\1p\x18\0\0\0", 8) + two + two + two +
             std::string("\xc6\0\x0elibmorph names\x13\0\0\0vertex_field p 1 p\n", 40);
    EXPECT_EQ(written(mesh, "om"), bytes);
}

TEST(Om, ReadsWhatOpenMeshWrote)
{
    ReadNotes notes;
    const MeshData mesh = read_mesh_data(test::data_path("om/openmesh_9.om"), "", {}, &notes);
    EXPECT_EQ(notes.version, "2.2, binary");
    ASSERT_EQ(mesh.points.rows(), 5);
    EXPECT_EQ(mesh.points.row(2), Eigen::RowVector3d(1, 1, 0.1));
    ASSERT_EQ(mesh.elements.size(), 2U);
    Element quad = mesh.elements[0];
    std::rotate(quad.begin(), std::find(quad.begin(), quad.end(), 0), quad.end());
    EXPECT_EQ(quad, (Element{0, 1, 2, 3}));
    EXPECT_EQ(corner_count(mesh.elements[1]), 3);
    ASSERT_EQ(mesh.fields.size(), 3U);
    EXPECT_EQ(mesh.fields[0].name, "pressure");
    EXPECT_EQ(mesh.fields[0].values(4, 0), 4.1);
    EXPECT_EQ(mesh.fields[1].name, "velocity");
    EXPECT_EQ(mesh.fields[1].values.row(3), Eigen::RowVector3d(3, 0, 1));
    EXPECT_EQ(mesh.fields[2].location, FieldLocation::element);
    EXPECT_EQ(mesh.fields[2].values(1, 0), 1);
}

TEST(Om, OpenMeshReadsWhatWeWriteToTheLastBit)
{
    const test::TemporaryFolder folder;
    for (const auto& [name, mesh] : test::rich_meshes()) {
        if (mesh.elements.empty())
            continue;
        write_mesh_data(mesh, folder.file("a.om"));
        OpenMeshMesh other;
        OpenMesh::VPropHandleT<double> scalar;
        OpenMesh::VPropHandleT<OpenMesh::Vec3d> vector;
        other.add_property(scalar, "v1");
        other.add_property(vector, "v3");
        ASSERT_TRUE(OpenMesh::IO::read_mesh(other, folder.file("a.om"))) << name;
        ASSERT_EQ(static_cast<Eigen::Index>(other.n_vertices()), mesh.points.rows()) << name;
        for (const auto v : other.vertices())
            for (unsigned k = 0; k < 3; ++k)
                EXPECT_EQ(other.point(v)[k], mesh.points(v.idx(), k)) << name;
        ASSERT_EQ(other.n_faces(), mesh.elements.size()) << name;
        for (const auto f : other.faces()) {
            std::vector<Index> corners;
            for (const auto v : other.fv_range(f))
                corners.push_back(v.idx());
            const Element& element = mesh.elements[static_cast<std::size_t>(f.idx())];
            EXPECT_TRUE(std::is_permutation(corners.begin(), corners.end(), element.begin())) << name;
        }
        if (mesh.fields.empty())
            continue;
        for (const auto v : other.vertices()) {
            EXPECT_EQ(other.property(scalar, v), mesh.fields[0].values(v.idx(), 0)) << name;
            EXPECT_EQ(other.property(vector, v)[2], mesh.fields[2].values(v.idx(), 2)) << name;
        }
    }
}

TEST(Om, RefusesBrokenFilesWithTheByte)
{
    MeshData mesh = small_surface();
    const std::string om = written(mesh, "om");
    ASSERT_EQ(refusal(om, "om"), "accepted");
    const std::size_t faces = 16 + 2 + 6 * 24;
    const auto changed = [](std::string bytes, std::size_t at, const std::string& to) {
        return bytes.replace(at, to.size(), to);
    };
    EXPECT_EQ(refusal("OM", "om"), "file: byte 0: expected 'OM' and a header of 16 bytes");
    EXPECT_EQ(refusal(changed(om, 0, "MO"), "om"), "file: byte 0: expected 'OM' and a header of 16 bytes");
    EXPECT_EQ(refusal(changed(om, 2, "X"), "om"),
              "file: byte 2: the mesh is of type 'X', expected T, Q or P");
    EXPECT_EQ(refusal(changed(om, 3, "\x60"), "om"),
              "file: byte 3: version 3.0 is newer than 2, which is supported");
    EXPECT_THAT(
        refusal(changed(om, 4, "\xff\xff\xff\xff"), "om"),
        HasSubstr("file: byte 4: there should be 4294967295 vertices, 3 faces and 0 edges, but only"));
    EXPECT_THAT(
        refusal(om.substr(0, 100), "om"),
        HasSubstr("file: byte 18: expected 6 times 24 bytes, but only 82 follow; the file is cut off"));
    EXPECT_EQ(refusal(om.substr(0, 16), "om").rfind("file: byte 4: there should be 6 vertices", 0), 0U);
    EXPECT_EQ(refusal(om.substr(0, faces), "om"),
              "file: byte 162: there should be 3 faces, but the file has 0");
    EXPECT_EQ(refusal(changed(om, 18, std::string("\0\0\0\0\0\0\xf0\x7f", 8)), "om"),
              "file: byte 18: a coordinate of vertex 0 is not finite");
    EXPECT_EQ(refusal(changed(om, faces + 2, "\5"), "om"),
              "file: byte 164: face 0 has 5 corners, but only triangles and quads are supported");
    EXPECT_EQ(refusal(changed(om, faces + 4, "\7"), "om"),
              "file: byte 166: face 0 names vertex 7, but the mesh has 6");
    EXPECT_THAT(refusal(changed(om, 17, "\x16"), "om"), HasSubstr("file: byte "));
}

TEST(Om, RefusesHalfedgesThatLeadNowhere)
{
    const std::string om = test::read_text(test::data_path("om/openmesh_9.om"));
    const std::size_t halfedges = 0x8c; // of three bytes each: next, vertex, face
    ASSERT_EQ(refusal(om, "om"), "accepted");
    for (const char to : {'\x0c', '\x7f', '\xff'}) {
        std::string broken = om;
        broken[halfedges] = to;
        EXPECT_THAT(refusal(broken, "om"), HasSubstr("face 0 names halfedge ")) << int{to};
        broken = om;
        broken[halfedges + 1] = to;
        EXPECT_THAT(refusal(broken, "om"), HasSubstr("face 0 names vertex ")) << int{to};
    }
    std::string endless = om;
    endless[halfedges + 6] = '\2'; // the third halfedge is its own next one
    EXPECT_THAT(refusal(endless, "om"), HasSubstr("face 0 has 5 corners"));
}

TEST(Om, SurvivesMutations)
{
    MeshData mesh = test::with_groups(small_surface());
    mesh.markers = {{"a b", {{0, 1}, {1, 2}}}, {"c", {}}};
    mesh.fields = {{"p q", FieldLocation::vertex, Matrix::Random(6, 3)},
                   {"r", FieldLocation::element, Matrix::Random(3, 2)}};
    test::survive_mutations("om", {written(mesh, "om"), test::read_text(test::data_path("om/openmesh_9.om"))},
                            2000);
}

} // namespace

} // namespace morph
