// What all of VTK's formats share: groups, volumes, strips, versions.
#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::written;
using testing::HasSubstr;

const std::vector<std::pair<std::string, WriteOptions>> kWays{{"vtk", {.binary = true}},
                                                              {"vtk", {.binary = false}},
                                                              {"vtu", {.binary = true}},
                                                              {"vtu", {.binary = false}},
                                                              {"vtu", {.binary = true, .compress = true}},
                                                              {"vtp", {.binary = true}},
                                                              {"vtp", {.binary = false}},
                                                              {"vtp", {.binary = true, .compress = true}}};

std::string name_of(const std::pair<std::string, WriteOptions>& way)
{
    return way.first + (way.second.binary ? " binary" : " ASCII") + (way.second.compress ? " zlib" : "");
}

/// Nine quads in groups that overlap, one of them empty, with element fields that take their names.
MeshData grouped()
{
    MeshData mesh = test::quad_square(3);
    mesh.groups = {{"lower", {0, 1, 2}},
                   {"left & <odd> 50 %", {0, 3, 6}},
                   {"", {}},
                   {"all", {0, 1, 2, 3, 4, 5, 6, 7, 8}},
                   {"upper", {7, 8}}};
    Matrix values(9, 1);
    for (Index i = 0; i < 9; ++i)
        values(i, 0) = 0.1 * i;
    mesh.fields = {{"group", FieldLocation::element, values}, {"group__2", FieldLocation::element, -values}};
    return mesh;
}

TEST(VtkFamily, HoldsEverythingBitForBitInEveryCoding)
{
    for (const auto& way : kWays)
        for (const auto& [name, mesh] : test::rich_meshes())
            EXPECT_EQ(difference(mesh, read_bytes(written(mesh, way.first, way.second), way.first)), "")
                << name_of(way) << ": " << name;
}

TEST(VtkFamily, GroupsComeBackAlsoWhereTheyOverlap)
{
    for (const auto& way : kWays)
        EXPECT_EQ(difference(grouped(), read_bytes(written(grouped(), way.first, way.second), way.first)), "")
            << name_of(way);
}

TEST(VtkFamily, SaysTheVersionAndCoding)
{
    const std::vector<std::string> versions{
        "3.0, binary",       "3.0, ascii", "1.0, appended raw",      "1.0, ascii", "1.0, appended raw, zlib",
        "1.0, appended raw", "1.0, ascii", "1.0, appended raw, zlib"};
    for (std::size_t i = 0; i < kWays.size(); ++i) {
        const auto& [format, options] = kWays[i];
        const std::string bytes = written(grouped(), format, options);
        ReadNotes notes;
        find_format("", format).read({"file", bytes, {}, &notes});
        EXPECT_EQ(notes.version, versions[i]) << name_of(kWays[i]);
        EXPECT_THAT(notes.warnings, testing::IsEmpty()) << name_of(kWays[i]);
    }
}

TEST(VtkFamily, SurvivesMutatedFiles)
{
    const MeshData mesh = grouped();
    for (const auto& way : kWays)
        test::survive_mutations(way.first, {written(mesh, way.first, way.second)}, 1000);
}

TEST(VtkFamily, RefusesGroupNumbersWithoutAName)
{
    MeshData mesh = test::quad_square(1);
    mesh.groups = {{"wing", {0}}};
    const std::string vtu = written(mesh, "vtu", {.binary = false});
    EXPECT_THAT(refusal(replaced(vtu, "Name=\"group\"", "Name=\"grope\""), "vtu"),
                HasSubstr("file: groups are named, but there is no cell array 'group' that numbers them"));
    EXPECT_THAT(refusal(replaced(vtu, "1\n0 0 0 0\n</DataArray>", "2\n0 0 0 0\n</DataArray>"), "vtu"),
                HasSubstr("file: cell 0 is of group number 2.000000, but 1 are named"));
}

/// Cells on the corners of two unit cubes, one above the other (0 to 3, 4 to 7, 8 to 11 counter-clockwise),
/// and a point above them.
std::string volume_vtk(const std::string& cells, std::size_t cell_count, const std::string& types)
{
    std::size_t numbers = 0;
    for (std::size_t at = 0; at < cells.size(); at = cells.find(' ', at + 1))
        ++numbers;
    return "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 13 double\n"
           "0 0 0 1 0 0 1 1 0 0 1 0\n0 0 1 1 0 1 1 1 1 0 1 1\n0 0 2 1 0 2 1 1 2 0 1 2\n0.5 0.5 3\nCELLS " +
           std::to_string(cell_count) + " " + std::to_string(numbers) + "\n" + cells + "\nCELL_TYPES " +
           std::to_string(cell_count) + "\n" + types + "\n";
}

MeshData boundary_of(const std::string& vtk)
{
    return find_format("", "vtk").read({"file", vtk, {.surface = true, .zone = ""}});
}

/// Six times the volume inside a closed surface, by the divergence theorem; quads here are plane.
double six_volumes(const MeshData& mesh)
{
    double sum = 0;
    for (const Element& element : mesh.elements)
        for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(corner_count(element)); ++k) {
            Eigen::Matrix3d corners;
            corners << mesh.points.row(element[0]), mesh.points.row(element[k]),
                mesh.points.row(element[k + 1]);
            sum += corners.determinant();
        }
    return sum;
}

TEST(VtkFamily, TheBoundaryOfEveryKindOfCellPointsOutwards)
{
    constexpr double rounding = 1e-14; // a few products of numbers up to 3
    const auto volume = [](const std::string& cells, const std::string& type) {
        return six_volumes(boundary_of(volume_vtk(cells, 1, type))) / 6;
    };
    EXPECT_NEAR(volume("4 0 1 2 4", "10"), 1.0 / 6, rounding);
    EXPECT_NEAR(volume("8 0 1 3 2 4 5 7 6", "11"), 1, rounding);
    EXPECT_NEAR(volume("8 0 1 2 3 4 5 6 7", "12"), 1, rounding);
    EXPECT_NEAR(volume("6 0 1 2 4 5 6", "13"), 0.5, rounding);
    EXPECT_NEAR(volume("6 0 2 1 4 6 5", "13"), 0.5, rounding)
        << "the base points outwards, as VTK's manual has it";
    EXPECT_NEAR(volume("5 8 9 10 11 12", "14"), 1.0 / 3, rounding);
}

TEST(VtkFamily, CellsOfAVolumeShareTheirInnerFaces)
{
    constexpr double rounding = 1e-14; // a few products of numbers up to 3
    const MeshData tower =
        boundary_of(volume_vtk("8 0 1 2 3 4 5 6 7 8 4 5 6 7 8 9 10 11 5 8 9 10 11 12", 3, "12 12 14"));
    EXPECT_EQ(tower.dimension, 3);
    EXPECT_EQ(tower.points.rows(), 13);
    EXPECT_EQ(tower.elements.size(), 1U + 4 + 4 + 4); // floor, walls of two storeys, roof
    EXPECT_NEAR(six_volumes(tower) / 6, 2 + 1.0 / 3, rounding);
    const MeshData wedges = boundary_of(volume_vtk("6 0 1 2 4 5 6 6 0 2 3 4 6 7", 2, "13 13"));
    EXPECT_EQ(wedges.points.rows(), 8);
    EXPECT_EQ(wedges.elements.size(), 2U + 2 + 4); // floor and roof in halves, walls
    EXPECT_NEAR(six_volumes(wedges) / 6, 1, rounding);
}

TEST(VtkFamily, ListedFacesOfAVolumeGiveItsGroups)
{
    std::string vtk = volume_vtk("8 0 1 2 3 4 5 6 7 4 0 1 2 3 4 4 5 6 7", 3, "12 9 9");
    vtk = replaced(vtk, "POINTS", "FIELD FieldData 1\ngroup_names 1 2 string\nfloor\nroof\nPOINTS") +
          "CELL_DATA 3\nSCALARS group int\nLOOKUP_TABLE default\n0 1 2\n";
    const MeshData mesh = boundary_of(vtk);
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "floor");
    ASSERT_EQ(mesh.groups[1].elements.size(), 1U);
    const Element roof = mesh.elements[static_cast<std::size_t>(mesh.groups[1].elements[0])];
    for (const Index v : roof)
        EXPECT_EQ(mesh.points(v, 2), 1);
    EXPECT_THAT(refusal(vtk, "vtk"), HasSubstr("holds a volume mesh of 1 cells; --surface takes"));
}

TEST(VtkFamily, StripsAreTrianglesOfOneSense)
{
    const MeshData mesh = read_bytes("# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET POLYDATA\n"
                                     "POINTS 6 float\n0 0 0 0 1 0 1 0 0 1 1 0 2 0 0 2 1 0\n"
                                     "VERTICES 1 2\n1 5\nTRIANGLE_STRIPS 1 6\n5 0 2 1 3 5\n"
                                     "CELL_DATA 2\nSCALARS id int\nLOOKUP_TABLE default\n7 8\n",
                                     "vtk");
    EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 2, 1, -1}, {1, 2, 3, -1}, {1, 3, 5, -1}}));
    ASSERT_EQ(mesh.fields.size(), 1U);
    EXPECT_EQ(mesh.fields[0].values.col(0), Eigen::Vector3d(8, 8, 8));
}

const std::string kGrid = "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET RECTILINEAR_GRID\n"
                          "DIMENSIONS 2 3 2\nX_COORDINATES 2 float\n0 1\nY_COORDINATES 3 float\n0 1\t2\r\n"
                          "Z_COORDINATES 2 float\n0 1d0\n";

TEST(VtkFamily, GridsInSpaceAreHexahedra)
{
    const MeshData mesh = boundary_of(kGrid);
    EXPECT_EQ(mesh.elements.size(), 2U + 2 + 6);
    EXPECT_NEAR(six_volumes(mesh) / 6, 2, 1e-14); // rounding
}

TEST(VtkFamily, RefusesGridsThatDoNotFit)
{
    EXPECT_THAT(refusal(replaced(kGrid, "2 3 2", "2 3 3"), "vtk"),
                HasSubstr("the axes have 2 x 3 x 2 coordinates, but DIMENSIONS are 2 x 3 x 3"));
    const std::string grid = "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET STRUCTURED_GRID\n"
                             "DIMENSIONS 2 2 1\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\n";
    EXPECT_EQ(read_bytes(grid, "vtk").elements, (std::vector<Element>{{0, 1, 3, 2}}));
    EXPECT_THAT(refusal(replaced(grid, "2 2 1", "2 3 1"), "vtk"),
                HasSubstr("DIMENSIONS are 2 x 3 x 1, but there are 4 points"));
    EXPECT_THAT(refusal(replaced(grid, "2 2 1", "99999 99999 99999"), "vtk"),
                HasSubstr("file: a grid of 99999 x 99999 x 99999 points is larger than"));
}

/// A quad, a triangle and a line, with what XML allows: no Verts, lists in any order.
const std::string kVtp =
    "<VTKFile type='PolyData' version='0.1'><PolyData>\n"
    "<Piece NumberOfPoints='5' NumberOfLines='1' NumberOfPolys='2'>\n"
    "<Polys><DataArray type='Int32' Name='offsets'>4 7</DataArray>\n"
    "<DataArray type='Int32' Name='connectivity'>0 1 2 3 1 4 2</DataArray></Polys>\n"
    "<Points><DataArray type='Float32' NumberOfComponents='3'>0 0 0 1 0 0 1 1 0 0 1 0 2 .5 0</DataArray>"
    "</Points>\n<Lines><DataArray type='Int32' Name='connectivity'>0 1 4</DataArray>\n"
    "<DataArray type='Int32' Name='offsets'>3</DataArray></Lines>\n"
    "<CellData><DataArray type='Int32' Name='n'>7 8 9</DataArray></CellData>\n"
    "</Piece></PolyData></VTKFile>";

TEST(VtkFamily, PolyDataMayLackLists)
{
    const MeshData mesh = read_bytes(kVtp, "vtp");
    EXPECT_EQ(difference(read_bytes(written(mesh, "vtp"), "vtp"), mesh), "");
    EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 1, 2, 3}, {1, 4, 2, -1}}));
    ASSERT_EQ(mesh.markers.size(), 1U);
    EXPECT_EQ(mesh.markers[0].edges, (std::vector<std::array<Index, 2>>{{0, 1}, {1, 4}}));
    EXPECT_EQ(mesh.fields[0].values.col(0), Eigen::Vector2d(8, 9));
}

TEST(VtkFamily, RefusesBrokenPolyData)
{
    const auto message = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kVtp, from, to), "vtp");
    };
    EXPECT_THAT(
        message("'PolyData' version", "'ImageData' version"),
        HasSubstr("file:1: expected <VTKFile type=\"PolyData\">, found <VTKFile type=\"ImageData\">"));
    EXPECT_THAT(message("NumberOfPolys='2'", "NumberOfPolys='3'"),
                HasSubstr("file:3: array 'offsets' should have 3 numbers, but its text"));
    EXPECT_THAT(message("NumberOfPolys='2'", "NumberOfStrips='1' NumberOfPolys='2'"),
                HasSubstr("file:2: <Piece> has no <Strips>"));
    EXPECT_THAT(message("4 7", "4 8"),
                HasSubstr("file:4: array 'connectivity' should have 8 numbers, but its text"));
    EXPECT_THAT(message("4 7", "7 -1"),
                HasSubstr("file:4: the last number of the array 'offsets' is negative"));
    EXPECT_THAT(message("4 7", "5 7"), HasSubstr("file: cell 1 is a polygon of 5 corners"));
    EXPECT_THAT(message("1 4 2<", "1 5 2<"), HasSubstr("file: cell 2 names point 5, but the mesh has 5"));
}

} // namespace

} // namespace morph
