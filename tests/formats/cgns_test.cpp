#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cgnslib.h>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::rich_meshes;
using test::written;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Cgns, HoldsEverythingBitForBit)
{
    for (auto& [name, mesh] : rich_meshes()) {
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "cgns"), "cgns")), "") << name;
        if (mesh.elements.empty())
            continue;
        MeshData grouped = mesh;
        grouped.groups = {{"all / of the elements, in a name of more than 32 characters", {}},
                          {"", {0}},
                          {"odd\n", {1, 0}}};
        for (Index e = 0; e < static_cast<Index>(mesh.elements.size()); ++e)
            grouped.groups[0].elements.push_back(e);
        EXPECT_EQ(difference(grouped, read_bytes(written(grouped, "cgns"), "cgns")), "") << name;
    }
}

TEST(Cgns, NamesEmptyGroupsAsLost)
{
    const test::TemporaryFolder folder;
    MeshData mesh = test::square_and_triangle(0);
    mesh.groups = {{"nobody", {}}};
    EXPECT_THAT(write_mesh_data(mesh, folder.file("a.cgns")),
                ElementsAre(HasSubstr("cgns cannot hold group 'nobody', which is empty")));
}

TEST(Cgns, ReadsAMeshOfAnotherProgramAsItsOtherFormat)
{
    const MeshData su2 = read_mesh_data(test::data_path("meshes/wedge.su2"));
    ReadNotes notes;
    MeshData cgns = read_mesh_data(test::data_path("meshes/wedge.cgns"), "", {}, &notes);
    EXPECT_EQ(notes.version, "2.54, HDF5");
    EXPECT_THAT(notes.warnings, IsEmpty());
    ASSERT_EQ(cgns.points.rows(), su2.points.rows());
    // The text of the SU2 file has 16 digits.
    EXPECT_LE((cgns.points - su2.points).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(), 1e-15);
    cgns.points = su2.points;
    EXPECT_EQ(difference(cgns, su2), "");
}

MeshData from_peer(const std::string& name, const ReadOptions& options = {})
{
    return read_mesh_data(test::data_path("cgns/" + name), "", options);
}

TEST(Cgns, ReadsAnAdfFile)
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0;
    mesh.elements = {{0, 1, 4, 3}, {1, 2, 4, -1}};
    mesh.markers = {{"wall", {{0, 1}, {1, 2}}}, {"far", {{3, 0}}}};
    EXPECT_EQ(difference(from_peer("adf.cgns"), mesh), "");
}

TEST(Cgns, ReadsTheSurfaceOfAVolumeOfTheCgnsTools)
{
    const MeshData mesh = from_peer("aflr3.cgns", {true, ""});
    ASSERT_EQ(mesh.elements.size(), 9U);
    // The volume within the surface, by the divergence theorem: a cube of 1 and a pyramid of 1/3.
    double volume = 0;
    for (const Element& face : mesh.elements)
        for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(corner_count(face)); ++k) {
            const auto corner = [&](std::size_t i) -> Eigen::Vector3d { return mesh.points.row(face[i]); };
            volume += corner(0).dot(corner(k).cross(corner(k + 1))) / 6;
        }
    EXPECT_NEAR(volume, 4.0 / 3, 8e-15); // sums of a dozen numbers of about 1
    std::vector<std::size_t> sizes;
    for (const ElementGroup& group : mesh.groups)
        sizes.push_back(group.elements.size());
    EXPECT_THAT(sizes, ElementsAre(4, 1, 4));
}

TEST(Cgns, ReadsAStructuredGridOfTheCgnsTools)
{
    const MeshData mesh = from_peer("plot3d.cgns");
    EXPECT_EQ(mesh.dimension, 2);
    ASSERT_EQ(mesh.elements.size(), 6U);
    EXPECT_EQ(mesh.elements[5], (Element{6, 7, 11, 10}));
    EXPECT_EQ(mesh.points.row(11), Eigen::RowVector3d(3, 2, 0));
}

TEST(Cgns, WritesWhatTheStandardSays)
{
    const test::TemporaryFolder folder;
    MeshData mesh = test::square_and_triangle(0);
    mesh.markers = {{"wall", {{0, 1}, {1, 4}}}};
    mesh.groups = {{"right", {1}}};
    mesh.fields = {{"v", FieldLocation::vertex, Matrix::Constant(5, 2, 7)}};
    write_mesh_data(mesh, folder.file("a.cgns"));

    int file = 0;
    ASSERT_EQ(cg_open(folder.file("a.cgns").c_str(), CG_MODE_READ, &file), CG_OK);
    std::array<char, 33> name{};
    int cells = 0;
    int physical = 0;
    ASSERT_EQ(cg_base_read(file, 1, name.data(), &cells, &physical), CG_OK);
    EXPECT_EQ(cells, 2);
    EXPECT_EQ(physical, 2);
    std::array<cgsize_t, 9> size{};
    ASSERT_EQ(cg_zone_read(file, 1, 1, name.data(), size.data()), CG_OK);
    EXPECT_EQ(size[0], 5);
    EXPECT_EQ(size[1], 2);

    std::array<cgsize_t, 9> elements{};
    std::array<cgsize_t, 3> offsets{};
    ASSERT_EQ(cg_poly_elements_read(file, 1, 1, 1, elements.data(), offsets.data(), nullptr), CG_OK);
    EXPECT_THAT(elements, ElementsAre(QUAD_4, 1, 2, 3, 4, TRI_3, 2, 5, 3));
    EXPECT_THAT(offsets, ElementsAre(0, 5, 9));
    std::array<cgsize_t, 4> bars{};
    ASSERT_EQ(cg_elements_read(file, 1, 1, 2, bars.data(), nullptr), CG_OK);
    EXPECT_THAT(bars, ElementsAre(1, 2, 2, 5));

    std::array<cgsize_t, 2> range{};
    GridLocation_t location{};
    ASSERT_EQ(cg_boco_read(file, 1, 1, 1, range.data(), nullptr), CG_OK);
    ASSERT_EQ(cg_boco_gridlocation_read(file, 1, 1, 1, &location), CG_OK);
    EXPECT_THAT(range, ElementsAre(3, 4));
    EXPECT_EQ(location, EdgeCenter);
    ASSERT_EQ(cg_goto(file, 1, "Zone_t", 1, "ZoneBC_t", 1, "BC_t", 1, "end"), CG_OK);
    ASSERT_EQ(cg_famname_read(name.data()), CG_OK);
    EXPECT_STREQ(name.data(), "wall");
    cgsize_t cell = 0;
    ASSERT_EQ(cg_subreg_ptset_read(file, 1, 1, 1, &cell), CG_OK);
    EXPECT_EQ(cell, 2);

    const std::array<cgsize_t, 1> low{1};
    const std::array<cgsize_t, 1> high{5};
    std::array<double, 5> values{};
    ASSERT_EQ(cg_field_read(file, 1, 1, 1, "vY", RealDouble, low.data(), high.data(), values.data()), CG_OK);
    EXPECT_THAT(values, testing::Each(7));
    cg_close(file);
}

TEST(Cgns, SurvivesMutatedFiles)
{
    MeshData mesh = rich_meshes()[4].second;
    mesh.groups = {{"half", {0, 1, 2}}};
    test::survive_mutations("cgns", {written(mesh, "cgns"), written(test::square_and_triangle(0), "cgns")},
                            2000);
}

} // namespace

} // namespace morph
