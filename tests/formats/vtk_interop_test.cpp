// Files that VTK and meshio wrote; tests/data/vtk/README.md says how.
#include "formats/formats.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morph {

namespace {

using test::difference;

std::string file(const std::string& name)
{
    return test::data_path("vtk/" + name);
}

Points grid_points()
{
    Points points(12, 3);
    for (Index j = 0; j < 3; ++j)
        for (Index i = 0; i < 4; ++i)
            points.row(4 * j + i) << i + 0.1 * j, j + 1.0 / 3 * i, 0;
    return points;
}

/// What the files made from one grid in VTK hold; the vertex cell is dropped, pixels are quads.
MeshData vtk_grid()
{
    MeshData mesh;
    mesh.points = grid_points();
    for (Index j = 0; j < 2; ++j) {
        const auto at = [j](Index i, Index up) { return 4 * (j + up) + i; };
        mesh.elements.push_back({at(0, 0), at(1, 0), at(1, 1), at(0, 1)});
        mesh.elements.push_back({at(1, 0), at(2, 0), at(1, 1), -1});
        mesh.elements.push_back({at(2, 0), at(2, 1), at(1, 1), -1});
        mesh.elements.push_back({at(2, 0), at(3, 0), at(3, 1), at(2, 1)});
    }
    mesh.markers = {{"4", {{0, 1}, {1, 2}, {2, 3}}}, {"7", {{3, 7}, {7, 11}}}};
    Matrix pressure(12, 1);
    Matrix velocity(12, 3);
    Matrix ids(12, 1);
    for (Index i = 0; i < 12; ++i) {
        pressure(i, 0) = std::sqrt(i);
        ids(i, 0) = i;
        for (Index k = 0; k < 3; ++k)
            velocity(i, k) = static_cast<float>(3 * i + k) / 7.0F;
    }
    Matrix stress(8, 9);
    for (Index i = 0; i < stress.size(); ++i)
        stress.data()[i] = i * 0.3;
    mesh.fields = {{"pressure", FieldLocation::vertex, pressure},
                   {"velocity", FieldLocation::vertex, velocity},
                   {"ids", FieldLocation::vertex, ids},
                   {"CellEntityIds", FieldLocation::element, Matrix::Constant(8, 1, 10)},
                   {"stress", FieldLocation::element, stress}};
    return mesh;
}

/// Fields by name, since legacy files order them by kind.
MeshData sorted(MeshData mesh)
{
    std::sort(mesh.fields.begin(), mesh.fields.end(),
              [](const Field& a, const Field& b) { return a.name < b.name; });
    return mesh;
}

/// Largest difference of any coordinate or field value, relative to the largest value.
double distance(const MeshData& a, const MeshData& b)
{
    double worst = (a.points - b.points).norm() / b.points.norm();
    for (std::size_t f = 0; f < b.fields.size(); ++f)
        worst = std::max(worst, (a.fields[f].values - b.fields[f].values).norm() / b.fields[f].values.norm());
    return worst;
}

TEST(VtkInterop, EveryEncodingOfVtkXmlReadsToTheSameBits)
{
    for (const char* name : {"ascii", "inline", "inline_zlib", "raw", "raw_zlib", "base64", "base64_zlib",
                             "raw_big_endian", "base64_zlib_big_endian"})
        EXPECT_EQ(difference(read_mesh_data(file(std::string(name) + ".vtu")), vtk_grid()), "") << name;
}

TEST(VtkInterop, LegacyBinaryFilesOfBothGenerationsReadToTheSameBits)
{
    for (const char* name : {"legacy_binary.vtk", "legacy_binary_51.vtk"})
        EXPECT_EQ(difference(sorted(read_mesh_data(file(name))), sorted(vtk_grid())), "") << name;
}

TEST(VtkInterop, LegacyAsciiFilesReadToTheDigitsTheyHold)
{
    constexpr double digits = 2e-6; // VTK writes float with 6 significant digits
    for (const char* name : {"legacy_ascii.vtk", "legacy_ascii_51.vtk"}) {
        const MeshData mesh = sorted(read_mesh_data(file(name)));
        const MeshData expected = sorted(vtk_grid());
        EXPECT_EQ(mesh.elements, expected.elements) << name;
        ASSERT_EQ(mesh.markers.size(), 2U) << name;
        EXPECT_EQ(mesh.markers[0].edges, expected.markers[0].edges) << name;
        EXPECT_EQ(mesh.markers[1].edges, expected.markers[1].edges) << name;
        ASSERT_EQ(mesh.fields.size(), expected.fields.size()) << name;
        EXPECT_LE(distance(mesh, expected), digits) << name;
    }
}

TEST(VtkInterop, MarkersSurviveAPassThroughVtk)
{
    const MeshData expected = test::annulus(1, 3, 12, 2);
    EXPECT_EQ(difference(read_mesh_data(file("markers.vtu")), expected), "");
    EXPECT_EQ(difference(read_mesh_data(file("markers_binary.vtk")), expected), "");
    const MeshData ascii = read_mesh_data(file("markers.vtk"));
    ASSERT_EQ(ascii.markers.size(), 2U);
    EXPECT_EQ(ascii.markers[0].name, "inner");
    EXPECT_EQ(ascii.markers[1].edges, expected.markers[1].edges);
    EXPECT_EQ(ascii.elements, expected.elements);
}

TEST(VtkInterop, GroupsSurviveAPassThroughVtk)
{
    for (const char* name : {"groups.vtu", "groups.vtp", "groups.vtk"}) {
        const MeshData mesh = read_mesh_data(file(name));
        ASSERT_EQ(mesh.groups.size(), 3U) << name;
        EXPECT_EQ(mesh.groups[0].name, "low left") << name;
        EXPECT_EQ(mesh.groups[0].elements, (std::vector<Index>{0})) << name;
        EXPECT_EQ(mesh.groups[1].elements, (std::vector<Index>{1})) << name;
        EXPECT_EQ(mesh.groups[2].name, "all") << name;
        EXPECT_EQ(mesh.groups[2].elements, (std::vector<Index>{0, 1})) << name;
        EXPECT_TRUE(mesh.fields.empty()) << name;
    }
}

TEST(VtkInterop, PolyDataIsASurface)
{
    constexpr double digits = 2e-6; // the ASCII file has 6 significant digits
    const MeshData ascii = read_mesh_data(file("polydata_ascii.vtk"));
    const MeshData binary = read_mesh_data(file("polydata_binary.vtk"));
    EXPECT_EQ(ascii.dimension, 3);
    EXPECT_EQ(ascii.points.rows(), 20);
    EXPECT_EQ(ascii.elements.size(), 36U);
    EXPECT_EQ(ascii.elements, binary.elements);
    EXPECT_LE(distance(ascii, binary), digits);
    ASSERT_EQ(ascii.fields.size(), 1U);
    EXPECT_EQ(ascii.fields[0].name, "Normals");
    EXPECT_LE((ascii.points.rowwise().norm().array() - 0.5).abs().maxCoeff(), digits);
}

TEST(VtkInterop, Lz4ReadsToTheSameBitsInEveryCoding)
{
    for (const char* name : {"inline_lz4", "raw_lz4", "base64_lz4_big_endian"}) {
        const MeshData mesh = read_mesh_data(file(std::string(name) + ".vtu"));
        EXPECT_EQ(mesh.points, grid_points()) << name;
        EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 1, 5, 4}, {1, 2, 5, -1}})) << name;
        ASSERT_EQ(mesh.fields.size(), 1U) << name;
        for (Index i = 0; i < 12; ++i)
            EXPECT_EQ(mesh.fields[0].values(i, 0), std::sqrt(i)) << name;
    }
}

TEST(VtkInterop, PolyDataInXmlHasVertsLinesPolysAndStrips)
{
    for (const char* name : {"poly_ascii.vtp", "poly_inline_zlib.vtp", "poly_raw_lz4.vtp"}) {
        const MeshData mesh = read_mesh_data(file(name));
        EXPECT_EQ(mesh.points, grid_points()) << name;
        EXPECT_EQ(
            mesh.elements,
            (std::vector<Element>{{0, 1, 5, 4}, {1, 2, 5, -1}, {2, 3, 6, -1}, {6, 3, 7, -1}, {6, 7, 10, -1}}))
            << name;
        ASSERT_EQ(mesh.markers.size(), 2U) << name;
        EXPECT_EQ(mesh.markers[0].name, "4") << name;
        EXPECT_EQ(mesh.markers[0].edges.size(), 3U) << name;
        EXPECT_EQ(mesh.markers[1].edges, (std::vector<std::array<Index, 2>>{{3, 7}})) << name;
        const Field* marker = find_field(mesh.fields, "marker", FieldLocation::element);
        ASSERT_TRUE(marker) << name;
        EXPECT_EQ(marker->values.col(0), (Eigen::VectorXd(5) << 1, 2, 3, 3, 3).finished()) << name;
    }
}

TEST(VtkInterop, StructuredGridsAreQuads)
{
    constexpr double digits = 2e-6; // the ASCII file has 6 significant digits
    for (const char* name : {"structured_ascii.vtk", "structured_binary.vtk"}) {
        const MeshData mesh = read_mesh_data(file(name));
        EXPECT_LE((mesh.points - grid_points()).cwiseAbs().maxCoeff(), digits) << name;
        ASSERT_EQ(mesh.elements.size(), 6U) << name;
        EXPECT_EQ(mesh.elements[0], (Element{0, 1, 5, 4})) << name;
        EXPECT_EQ(mesh.elements[5], (Element{6, 7, 11, 10})) << name;
        EXPECT_EQ(mesh.fields.size(), 1U) << name;
    }
}

TEST(VtkInterop, RectilinearGridsAreQuadsAboutTheAxisOfOnePoint)
{
    const MeshData mesh = read_mesh_data(file("rectilinear_ascii.vtk"));
    EXPECT_EQ(mesh.points.row(5), Eigen::RowVector3d(3, 5, 2));
    EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 3, 4, 1}, {1, 4, 5, 2}}));
}

TEST(VtkInterop, MeshioFilesReadAlike)
{
    constexpr double digits = 1e-11; // meshio writes ASCII with 11 decimals
    for (const char* name : {"meshio.vtu", "meshio_ascii.vtu", "meshio_42.vtk", "meshio_51.vtk"}) {
        const MeshData mesh = read_mesh_data(file(name));
        EXPECT_LE((mesh.points - grid_points()).cwiseAbs().maxCoeff(), digits) << name;
        EXPECT_EQ(mesh.elements,
                  (std::vector<Element>{{0, 1, 5, 4}, {4, 5, 9, 8}, {1, 2, 5, -1}, {5, 6, 9, -1}}))
            << name;
        ASSERT_EQ(mesh.markers.size(), 2U) << name;
        EXPECT_EQ(mesh.markers[0].name, "5") << name;
        EXPECT_EQ(mesh.markers[0].edges.size(), 2U) << name;
        EXPECT_EQ(mesh.markers[1].name, "6") << name;
    }
}

} // namespace

} // namespace morph
