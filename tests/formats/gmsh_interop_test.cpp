// Files that Gmsh and meshio wrote; tests/data/gmsh/README.md says how.
#include "formats/formats.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <Eigen/Geometry>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using testing::ElementsAre;

MeshData read(const std::string& name, bool surface = false)
{
    return read_mesh_data(test::data_path("gmsh/" + name + ".msh"), "", {.surface = surface, .zone = {}});
}

/// Signed area of the elements of a planar mesh, by the shoelace formula.
double area(const MeshData& mesh)
{
    double twice = 0;
    for (const Element& element : mesh.elements) {
        const auto corners = static_cast<std::size_t>(corner_count(element));
        for (std::size_t k = 0; k < corners; ++k) {
            const auto a = mesh.points.row(element[k]);
            const auto b = mesh.points.row(element[(k + 1) % corners]);
            twice += a[0] * b[1] - a[1] * b[0];
        }
    }
    return twice / 2;
}

/// Volume inside of a closed surface whose quads are planar, by the divergence theorem.
double volume(const MeshData& mesh)
{
    double six_times = 0;
    for (const Element& element : mesh.elements)
        for (std::size_t k = 2; k < static_cast<std::size_t>(corner_count(element)); ++k) {
            const Eigen::RowVector3d a = mesh.points.row(element[0]);
            const Eigen::RowVector3d b = mesh.points.row(element[k - 1]);
            const Eigen::RowVector3d c = mesh.points.row(element[k]);
            six_times += a.dot(b.cross(c));
        }
    return six_times / 6;
}

double length(const MeshData& mesh, const Marker& marker)
{
    double sum = 0;
    for (const auto& [a, b] : marker.edges)
        sum += (mesh.points.row(a) - mesh.points.row(b)).norm();
    return sum;
}

constexpr double kDigits = 1e-14; // Gmsh's text has 16 digits; sums of some ten numbers of size 1

TEST(GmshInterop, TheSquareIsTheSameInEveryVersion)
{
    for (const char* name :
         {"square_22", "square_22_binary", "square_22_parametric", "square_22_parametric_binary", "square_40",
          "square_41", "square_41_binary", "square_41_parametric", "square_41_parametric_binary",
          "partitioned_22", "partitioned_40", "partitioned_41", "partitioned_41_binary"}) {
        const MeshData mesh = read(name);
        EXPECT_EQ(mesh.dimension, 2) << name;
        EXPECT_EQ(mesh.points.rows(), 12) << name;
        EXPECT_EQ(mesh.elements.size(), 14U) << name;
        EXPECT_NEAR(area(mesh), 1, kDigits) << name;
        ASSERT_EQ(mesh.markers.size(), 2U) << name;
        EXPECT_EQ(mesh.markers[0].name, "walls, low & up") << name;
        EXPECT_NEAR(length(mesh, mesh.markers[0]), 2, kDigits) << name;
        EXPECT_EQ(mesh.markers[1].name, "outlet") << name;
        EXPECT_NEAR(length(mesh, mesh.markers[1]), 1, kDigits) << name;
        ASSERT_EQ(mesh.groups.size(), 2U) << name;
        EXPECT_EQ(mesh.groups[0].name, "gas") << name;
        EXPECT_EQ(mesh.groups[1].name, "40") << name;
        EXPECT_EQ(mesh.groups[0].elements.size(), 14U) << name;
        EXPECT_EQ(mesh.groups[1].elements, mesh.groups[0].elements) << name;
    }
}

TEST(GmshInterop, BinaryFilesOfVersions22And41HoldTheSameBits)
{
    EXPECT_EQ(test::difference(read("square_22_binary"), read("square_41_binary")), "");
    EXPECT_EQ(test::difference(read("square_41_parametric_binary"), read("square_41_binary")), "");
}

TEST(GmshInterop, DataOfNodesAndElementsAreFields)
{
    for (const char* name : {"data_41", "data_41_binary"}) {
        const MeshData mesh = read(name);
        ASSERT_EQ(mesh.fields.size(), 3U) << name;
        EXPECT_EQ(mesh.fields[0].name, "velocity & more");
        EXPECT_LE((mesh.fields[0].values - 2 * mesh.points).cwiseAbs().maxCoeff(), kDigits) << name;
        EXPECT_EQ(mesh.fields[1].name, "velocity & more_step_1");
        EXPECT_LE((mesh.fields[1].values - 3 * mesh.points).cwiseAbs().maxCoeff(), kDigits) << name;
        EXPECT_EQ(mesh.fields[2].name, "number");
        for (Index e = 0; e < 14; ++e) // their tags, behind those of 6 lines
            EXPECT_EQ(mesh.fields[2].values(e, 0), 7 + e) << name;
    }
}

TEST(GmshInterop, VolumesHaveAClosedBoundary)
{
    for (const char* name : {"tetrahedra_22", "tetrahedra_41_binary"})
        EXPECT_NEAR(volume(read(name, true)), 1, kDigits) << name;
    for (const char* name : {"prisms_and_hexahedra_22", "prisms_and_hexahedra_41_binary"}) {
        const MeshData mesh = read(name, true);
        EXPECT_NEAR(volume(mesh), 2, kDigits) << name;
        ASSERT_EQ(mesh.groups.size(), 2U) << name;
        EXPECT_EQ(mesh.groups[0].name, "top") << name;
        EXPECT_EQ(mesh.groups[1].name, "bottom") << name;
        for (const Index e : mesh.groups[0].elements)
            EXPECT_EQ(mesh.points(mesh.elements[static_cast<std::size_t>(e)][0], 2), 1) << name;
    }
}

TEST(GmshInterop, MeshioFilesAreRead)
{
    const MeshData mesh = read("meshio_22_binary");
    EXPECT_EQ(mesh.dimension, 3);
    EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 1, 4, -1}, {0, 4, 3, -1}, {1, 2, 5, 4}}));
    EXPECT_EQ(mesh.markers.at(0).name, "wall");
    EXPECT_EQ(mesh.markers.at(0).edges, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 2}}));
    EXPECT_EQ(mesh.groups.at(0).name, "front");
    EXPECT_THAT(mesh.groups.at(0).elements, ElementsAre(0, 1));
    EXPECT_THAT(mesh.groups.at(1).elements, ElementsAre(2));
    EXPECT_EQ(mesh.fields.at(0).values, mesh.points.col(0));
    EXPECT_EQ(mesh.fields.at(1).values, Eigen::Vector3d(3.5, 4.5, 5.5));
    for (const char* name : {"meshio_40_binary", "meshio_41_binary"}) {
        const MeshData triangles = read(name);
        EXPECT_EQ(triangles.points, mesh.points) << name;
        EXPECT_EQ(triangles.elements, (std::vector<Element>{{0, 1, 4, -1}, {0, 4, 3, -1}})) << name;
        EXPECT_EQ(triangles.fields.at(0).values, mesh.points.col(0)) << name;
    }
}

} // namespace

} // namespace morph
