// OFF, OBJ, PLY and STL: what they share.
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

#include <cmath>

namespace morph {

namespace {

using test::bare;
using test::difference;
using test::read_bytes;
using test::refusal;
using test::small_surface;
using test::written;
using testing::HasSubstr;

TEST(SurfaceFormats, OffObjAndPlyHoldEverySurfaceBitForBit)
{
    for (const auto& [name, mesh] : test::rich_meshes())
        for (const char* format : {"off", "obj", "ply"})
            for (const bool binary : {false, true})
                EXPECT_EQ(difference(bare(mesh),
                                     read_bytes(written(bare(mesh), format, {.binary = binary}), format)),
                          "")
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
            if (binary && format == "obj")
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

} // namespace

} // namespace morph
