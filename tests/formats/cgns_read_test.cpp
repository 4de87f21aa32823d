#include "formats/formats.h"
#include "tests/support/cgns_builder.h"
#include "tests/support/format_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cgnslib.h>

namespace morph {

namespace {

using test::CgnsBuilder;
using test::read_bytes;
using test::refusal;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Edges = std::vector<std::array<Index, 2>>;

/// What the reader says and warns of with these options.
struct Reading {
    MeshData mesh;
    ReadNotes notes;
};

Reading read(const std::string& bytes, const ReadOptions& options = {})
{
    Reading reading;
    reading.mesh = find_format("file", "cgns").read({"file", bytes, options, &reading.notes});
    return reading;
}

Edges edges_of(const MeshData& mesh, const std::string& marker)
{
    const Marker* found = find_marker(mesh.markers, marker);
    return found ? found->edges : Edges{{-1, -1}};
}

std::vector<Index> group_of(const MeshData& mesh, const std::string& name)
{
    for (const ElementGroup& group : mesh.groups)
        if (group.name == name)
            return group.elements;
    return {-1};
}

/// Two squares side by side, the right one cut into two triangles; vertices 1 2 3 below 4 5 6.
CgnsBuilder two_squares(int type = CG_FILE_HDF5)
{
    CgnsBuilder file(2, 2, type);
    file.unstructured_zone("fluid", 6, 3);
    file.grid_points(2, 1);
    // numbers with gaps, sections out of order
    file.section("triangles", TRI_3, 11, 12, {2, 3, 6, 2, 6, 5});
    file.section("bottom", BAR_2, 20, 21, {1, 2, 2, 3});
    file.section("sides", BAR_2, 30, 31, {3, 6, 4, 1});
    file.section("squares", QUAD_4, 1, 1, {1, 2, 5, 4});
    return file;
}

TEST(CgnsReader, ReadsSectionsByNumberAndBoundariesOfEveryKind)
{
    for (const int type : {CG_FILE_HDF5, CG_FILE_ADF}) {
        CgnsBuilder file = two_squares(type);
        file.boundary("BC1", PointRange, EdgeCenter, {20, 21}, 2, "wall");
        file.boundary("BC2", PointList, EdgeCenter, {31}, 1, "inlet");
        file.boundary("BC3", PointList, Vertex, {4, 5, 6}, 3);
        file.boundary("BC4", PointList, EdgeCenter, {30}, 1, "wall");
        file.boundary("BC5", PointList, CellCenter, {12, 1}, 2);
        const Reading reading = read(file.bytes());
        const MeshData& mesh = reading.mesh;
        EXPECT_EQ(reading.notes.version, type == CG_FILE_HDF5 ? "3.4, HDF5" : "3.4, ADF");
        EXPECT_THAT(reading.notes.warnings, IsEmpty());
        EXPECT_EQ(mesh.dimension, 2);
        EXPECT_EQ(mesh.points.row(5), Eigen::RowVector3d(2, 1, 0));
        EXPECT_THAT(mesh.elements,
                    ElementsAre(Element{0, 1, 4, 3}, Element{1, 2, 5, -1}, Element{1, 5, 4, -1}));
        ASSERT_EQ(mesh.markers.size(), 3U);
        EXPECT_EQ(edges_of(mesh, "wall"), (Edges{{0, 1}, {1, 2}, {2, 5}}));
        EXPECT_EQ(edges_of(mesh, "inlet"), (Edges{{3, 0}}));
        EXPECT_EQ(edges_of(mesh, "BC3"), (Edges{{4, 3}, {5, 4}})); // of no section: as the elements have them
        EXPECT_THAT(group_of(mesh, "BC5"), ElementsAre(2, 0));
        EXPECT_THAT(group_of(mesh, "triangles"), ElementsAre(1, 2));
        EXPECT_THAT(group_of(mesh, "squares"), ElementsAre(0));
    }
}

TEST(CgnsReader, EdgesOfNoBoundaryConditionAreAMarkerByTheirSection)
{
    CgnsBuilder file = two_squares();
    file.boundary("left", ElementList, Vertex, {31}, 1);
    const MeshData mesh = read_bytes(file.bytes(), "cgns");
    ASSERT_EQ(mesh.markers.size(), 3U);
    EXPECT_EQ(edges_of(mesh, "left"), (Edges{{3, 0}}));
    EXPECT_EQ(edges_of(mesh, "sides"), (Edges{{2, 5}}));
    EXPECT_EQ(edges_of(mesh, "bottom").size(), 2U);
}

TEST(CgnsReader, ReadsFilesOfNewerVersions)
{
    for (const float version : {4.0F, 4.2F, 4.5F}) {
        const Reading reading = read(two_squares().bytes_of_version(version));
        EXPECT_EQ(reading.mesh.elements.size(), 3U);
        EXPECT_EQ(reading.notes.version, version == 4.0F   ? "4, HDF5"
                                         : version == 4.2F ? "4.2, HDF5"
                                                           : "4.5, HDF5");
    }
    EXPECT_THAT(
        refusal(two_squares().bytes_of_version(5.0F), "cgns"),
        HasSubstr("file: the file cannot be read: The file file was written with a more recent version"));
}

TEST(CgnsReader, JoinsComponentsOfVectorsInTheirPlace)
{
    CgnsBuilder file = two_squares();
    const int nodal = file.solution("nodes", Vertex);
    file.field(nodal, "VelocityX", {1, 2, 3, 4, 5, 6});
    file.field(nodal, "Pressure", {0, 0, 0, 0, 0, 9});
    file.field(nodal, "VelocityY", {-1, -2, -3, -4, -5, -6});
    file.field(nodal, "X", {7, 7, 7, 7, 7, 7});
    file.field(nodal, "FluxY", {8, 8, 8, 8, 8, 8});
    const int cells = file.solution("cells", CellCenter);
    file.field(cells, "Pressure", {10, 20, 30});
    const int later = file.solution("later", CellCenter);
    file.field(later, "Pressure", {11, 21, 31});
    const Reading reading = read(file.bytes());
    ASSERT_EQ(reading.mesh.fields.size(), 6U);
    EXPECT_EQ(reading.mesh.fields[0].name, "Velocity");
    EXPECT_EQ(reading.mesh.fields[0].values.row(2), Eigen::RowVector2d(3, -3));
    EXPECT_EQ(reading.mesh.fields[1].name, "Pressure");
    EXPECT_EQ(reading.mesh.fields[2].name, "X");
    EXPECT_EQ(reading.mesh.fields[3].name, "FluxY");
    EXPECT_EQ(reading.mesh.fields[4].name, "Pressure");
    EXPECT_EQ(reading.mesh.fields[4].values.col(0), Eigen::Vector3d(10, 20, 30));
    EXPECT_EQ(reading.mesh.fields[5].name, "later/Pressure");
    EXPECT_THAT(reading.notes.warnings, IsEmpty());
}

TEST(CgnsReader, ReadsPolygonsOfThreeAndFourCorners)
{
    CgnsBuilder file;
    file.unstructured_zone("fluid", 6, 2);
    file.grid_points(2, 1);
    file.mixed_section("polygons", NGON_n, 1, 2, {1, 2, 5, 4, 2, 3, 6}, {0, 4, 7});
    EXPECT_THAT(read_bytes(file.bytes(), "cgns").elements,
                ElementsAre(Element{0, 1, 4, 3}, Element{1, 2, 5, -1}));

    CgnsBuilder pentagon;
    pentagon.unstructured_zone("fluid", 6, 1);
    pentagon.grid_points(2, 1);
    pentagon.mixed_section("polygons", NGON_n, 1, 1, {1, 2, 3, 5, 4}, {0, 5});
    EXPECT_EQ(
        refusal(pentagon.bytes(), "cgns"),
        "file: zone 'fluid', section 'polygons' has the polygon 1 of 5 corners, but only those of 3 or 4 "
        "are supported");
}

/// 3 x 2 quads, vertices 4 x 3.
CgnsBuilder grid(const std::vector<int>& vertices = {4, 3}, int physical = 2)
{
    CgnsBuilder file(static_cast<int>(vertices.size()), physical);
    file.structured_zone("block", vertices);
    file.grid_points(3, 2);
    return file;
}

TEST(CgnsReader, ReadsAStructuredPlaneWithItsBoundariesAndSolutions)
{
    CgnsBuilder file = grid();
    file.boundary("bottom", PointRange, Vertex, {1, 1, 4, 1}, 2);
    file.boundary("right", PointRange, EdgeCenter, {4, 1, 4, 2}, 2);
    file.boundary("top", PointList, EdgeCenter, {3, 3, 1, 3}, 2);
    file.boundary("left", PointList, Vertex, {1, 1, 1, 2, 1, 3}, 3);
    file.boundary("cells", PointList, CellCenter, {3, 2, 1, 1}, 2);
    file.boundary("corner", PointRange, Vertex, {2, 1, 4, 3}, 2);
    file.field(file.solution("cells", CellCenter), "p", {0, 1, 2, 3, 4, 5});
    const MeshData mesh = read_bytes(file.bytes(), "cgns");
    ASSERT_EQ(mesh.elements.size(), 6U);
    EXPECT_EQ(mesh.elements[4], (Element{5, 6, 10, 9}));
    EXPECT_EQ(mesh.points.row(11), Eigen::RowVector3d(3, 2, 0));
    EXPECT_EQ(edges_of(mesh, "bottom"), (Edges{{0, 1}, {1, 2}, {2, 3}}));
    EXPECT_EQ(edges_of(mesh, "right"), (Edges{{3, 7}, {7, 11}}));
    EXPECT_EQ(edges_of(mesh, "top"), (Edges{{10, 11}, {8, 9}}));
    EXPECT_EQ(edges_of(mesh, "left"), (Edges{{4, 0}, {8, 4}}));
    EXPECT_THAT(group_of(mesh, "cells"), ElementsAre(5, 0));
    EXPECT_THAT(group_of(mesh, "corner"), ElementsAre(1, 2, 4, 5));
    ASSERT_EQ(mesh.fields.size(), 1U);
    EXPECT_EQ(mesh.fields[0].values(4, 0), 4);
}

TEST(CgnsReader, ReadsAPlaneOfAThreeDimensionalGrid)
{
    const MeshData flat = read_bytes(grid({4, 3}, 3).bytes(), "cgns");
    EXPECT_EQ(flat.elements.size(), 6U);
    CgnsBuilder file = grid({4, 1, 3}, 3);
    file.boundary("bottom", PointRange, Vertex, {1, 1, 1, 4, 1, 1}, 2);
    file.boundary("right", PointRange, IFaceCenter, {4, 1, 1, 4, 1, 2}, 2);
    file.boundary("top", PointRange, KFaceCenter, {1, 1, 3, 1, 1, 3}, 2);
    file.boundary("symmetry", PointRange, JFaceCenter, {1, 1, 1, 2, 1, 1}, 2);
    const MeshData mesh = read_bytes(file.bytes(), "cgns");
    EXPECT_EQ(mesh.elements, flat.elements);
    EXPECT_EQ(edges_of(mesh, "bottom").size(), 3U);
    EXPECT_EQ(edges_of(mesh, "right"), (Edges{{3, 7}, {7, 11}}));
    EXPECT_EQ(edges_of(mesh, "top"), (Edges{{8, 9}}));
    EXPECT_THAT(group_of(mesh, "symmetry"), ElementsAre(0, 1));
}

/// Unit cube as a block of 2 x 2 x 2 vertices.
CgnsBuilder cube()
{
    CgnsBuilder file(3, 3);
    file.structured_zone("block", {2, 2, 2});
    file.points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}});
    file.boundary("floor", PointRange, Vertex, {1, 1, 1, 2, 2, 1}, 2);
    file.boundary("roof", PointRange, KFaceCenter, {1, 1, 2, 1, 1, 2}, 2);
    file.field(file.solution("faces", IFaceCenter), "q", {1, 2});
    file.field(file.solution("cells", CellCenter), "q", {1});
    return file;
}

TEST(CgnsReader, TakesTheSurfaceOfAVolume)
{
    const Reading reading = read(cube().bytes(), {true, ""});
    EXPECT_EQ(reading.mesh.dimension, 3);
    EXPECT_EQ(reading.mesh.elements.size(), 6U);
    EXPECT_EQ(group_of(reading.mesh, "floor").size(), 1U);
    EXPECT_THAT(
        reading.notes.warnings,
        ElementsAre("file: zone 'block', boundary condition 'roof' was left out: of a structured volume only "
                    "ranges of vertices are supported",
                    "file: zone 'block', solution 'faces' was left out: its values are at IFaceCenter",
                    "file: zone 'block', solution 'cells' was left out: its values are those of the "
                    "volume's cells"));
    EXPECT_EQ(refusal(cube().bytes(), "cgns"),
              "file: holds a volume mesh of 1 cells; --surface takes its boundary");

    CgnsBuilder file(3, 3);
    file.unstructured_zone("solid", 5, 2);
    file.points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
    file.section("cells", TETRA_4, 1, 2, {1, 2, 3, 4, 2, 3, 4, 5});
    file.section("faces", TRI_3, 3, 4, {1, 3, 2, 1, 2, 4});
    file.boundary("base", PointList, FaceCenter, {3}, 1, "ground");
    file.boundary("front", PointList, Vertex, {1, 2, 4}, 3);
    const MeshData mesh = read(file.bytes(), {true, ""}).mesh;
    EXPECT_EQ(mesh.elements.size(), 6U);
    ASSERT_EQ(mesh.groups.size(), 2U);
    const Index base = group_of(mesh, "ground").at(0);
    EXPECT_EQ(mesh.elements[static_cast<std::size_t>(base)], (Element{0, 2, 1, -1}));
    const Index front = group_of(mesh, "front").at(0);
    EXPECT_EQ(mesh.elements[static_cast<std::size_t>(front)], (Element{0, 1, 3, -1}));
}

TEST(CgnsReader, JoinsZonesOrTakesOne)
{
    CgnsBuilder file = grid();
    file.boundary("bottom", PointRange, Vertex, {1, 1, 4, 1}, 2, "wall");
    file.field(file.solution("cells", CellCenter), "p", {0, 1, 2, 3, 4, 5});
    file.unstructured_zone("patch", 3, 1);
    file.points({{3, 0, 0}, {4, 0, 0}, {3, 1, 0}});
    file.section("all", TRI_3, 1, 1, {1, 2, 3});
    file.section("edge", BAR_2, 2, 2, {1, 2});
    file.boundary("edge", PointRange, EdgeCenter, {2, 2}, 2, "wall");
    const int cells = file.solution("cells", CellCenter);
    file.field(cells, "p", {6});
    file.field(cells, "q", {7});
    const std::string bytes = file.bytes();

    const Reading all = read(bytes);
    EXPECT_EQ(all.mesh.points.rows(), 15);
    EXPECT_THAT(group_of(all.mesh, "block"), ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THAT(group_of(all.mesh, "patch"), ElementsAre(6));
    EXPECT_EQ(all.mesh.elements[6], (Element{12, 13, 14, -1}));
    EXPECT_EQ(edges_of(all.mesh, "wall"), (Edges{{0, 1}, {1, 2}, {2, 3}, {12, 13}}));
    ASSERT_EQ(all.mesh.fields.size(), 1U);
    EXPECT_EQ(all.mesh.fields[0].values(6, 0), 6);
    EXPECT_THAT(all.notes.warnings,
                ElementsAre("file: field 'q' was left out: zone 'block' does not have it"));

    for (const std::string zone : {"patch", "2"}) {
        const Reading one = read(bytes, {false, zone});
        EXPECT_EQ(one.mesh.elements.size(), 1U);
        EXPECT_THAT(one.mesh.groups, IsEmpty());
        EXPECT_EQ(one.mesh.fields.size(), 2U);
    }
    try {
        read(bytes, {false, "pach"});
        ADD_FAILURE() << "accepted";
    } catch (const std::exception& error) {
        EXPECT_STREQ(error.what(),
                     "file: has no zone 'pach'; its zones are block, patch; did you mean 'patch'?");
    }
}

TEST(CgnsReader, WarnsOfInterfacesThatStayOpen)
{
    CgnsBuilder file = grid(); // its left side is its right side
    const std::array<cgsize_t, 4> left{1, 1, 1, 3};
    const std::array<cgsize_t, 4> right{4, 1, 4, 3};
    const std::array<int, 2> transform{1, 2};
    int number = 0;
    ASSERT_EQ(cg_1to1_write(file.file(), 1, 1, "seam", "block", left.data(), right.data(), transform.data(),
                            &number),
              CG_OK);
    EXPECT_THAT(
        read(file.bytes()).notes.warnings,
        ElementsAre("file: zone 'block' has 1 interface(s), at which vertices of both sides are kept"));
}

TEST(CgnsReader, RefusesWhatIsNoMeshOfTrianglesAndQuads)
{
    const auto of_section = [](int type, const std::vector<int>& corners) {
        CgnsBuilder file;
        file.unstructured_zone("fluid", 6, 1);
        file.grid_points(2, 1);
        file.section("all", type, 1, 1, corners);
        return refusal(file.bytes(), "cgns");
    };
    EXPECT_EQ(
        of_section(TRI_6, {1, 2, 3, 4, 5, 6}),
        "file: zone 'fluid', section 'all' holds elements of the type TRI_6, but only BAR_2, TRI_3, QUAD_4, "
        "TETRA_4, PYRA_5, PENTA_6 and HEXA_8 are supported");
    EXPECT_EQ(of_section(TRI_3, {1, 2, 7}),
              "file: zone 'fluid', section 'all' has element 1 at vertex 7, but the zone has 6");
    EXPECT_EQ(of_section(TRI_3, {1, 0, 3}),
              "file: zone 'fluid', section 'all' has element 1 at vertex 0, but the zone has 6");

    CgnsBuilder overlap = two_squares();
    overlap.section("more", TRI_3, 12, 13, {1, 2, 3, 1, 2, 3});
    EXPECT_EQ(refusal(overlap.bytes(), "cgns"),
              "file: zone 'fluid', sections 'triangles' and 'more' have numbers of elements in common");

    CgnsBuilder bare;
    bare.unstructured_zone("fluid", 6, 0);
    EXPECT_EQ(refusal(bare.bytes(), "cgns"), "file: zone 'fluid' has the coordinates , expected CoordinateX, "
                                             "CoordinateY and perhaps CoordinateZ");
}

TEST(CgnsReader, RefusesBoundariesOutOfRange)
{
    CgnsBuilder far = two_squares();
    far.boundary("far", PointList, EdgeCenter, {40}, 1);
    EXPECT_EQ(refusal(far.bytes(), "cgns"),
              "file: zone 'fluid', boundary condition 'far' names 40, but the numbers end at 31");
    CgnsBuilder gap = two_squares();
    gap.boundary("gap", PointList, EdgeCenter, {15, 20}, 2);
    EXPECT_THAT(
        read(gap.bytes()).notes.warnings,
        ElementsAre("file: zone 'fluid', boundary condition 'gap' was left out: 1 of its elements are "
                    "neither edges nor faces that the file lists"));
    CgnsBuilder outside = grid();
    outside.boundary("far", PointRange, Vertex, {1, 1, 5, 1}, 2);
    EXPECT_THAT(refusal(outside.bytes(), "cgns"), HasSubstr("boundary condition 'far'"));
}

TEST(CgnsReader, RefusesWhatIsNoCgnsFile)
{
    for (const std::string bytes : {"", "NDIME= 2\n", "\x89HDF\r\n\x1a\n"})
        EXPECT_THAT(refusal(bytes, "cgns"), HasSubstr("file: "));
    EXPECT_EQ(refusal("NDIME= 2\n", "cgns"),
              "file: not a CGNS file, which begins as one of HDF5 or ADF does");
    const std::string whole = two_squares().bytes();
    for (std::size_t part = 1; part < 8; ++part)
        EXPECT_THAT(refusal(whole.substr(0, whole.size() * part / 8), "cgns"), HasSubstr("file: "));
}

TEST(CgnsReader, SurvivesMutatedFilesOfBothKinds)
{
    test::survive_mutations("cgns", {two_squares(CG_FILE_ADF).bytes(), grid().bytes()}, 600);
}

} // namespace

} // namespace morph
