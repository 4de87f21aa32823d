#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::rich_meshes;
using test::written;
using testing::HasSubstr;

TEST(Vtu, BinaryFilesHoldEverythingBitForBit)
{
    for (const auto& [name, mesh] : rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtu"), "vtu")), "") << name;
}

TEST(Vtu, AsciiFilesHoldEverythingBitForBit)
{
    for (const auto& [name, mesh] : rich_meshes())
        EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtu", {.binary = false}), "vtu")), "") << name;
}

TEST(Vtu, SurvivesMutatedFiles)
{
    const MeshData mesh = rich_meshes()[4].second;
    test::survive_mutations("vtu", {written(mesh, "vtu"), written(mesh, "vtu", {.binary = false})}, 600);
}

/// A triangle and a quad with two markers, in the words a person would use.
const std::string kVtu =
    "<?xml version='1.0'?>\r\n<!DOCTYPE VTKFile>\r\n<!-- made by hand: <Piece> -->\r\n"
    "<VTKFile type='UnstructuredGrid' version='0.1'>\n<UnstructuredGrid>\n"
    "<Piece NumberOfPoints='5' NumberOfCells='5'>\n"
    "<Points><DataArray type='Float32' NumberOfComponents='3' format='ascii'>\n"
    "0 0 0  1 0 0 <!-- two -->\t1 1 0\r\n\r\n 0 1 0 +2 5e-1 0\n</DataArray></Points>\n"
    "<Cells>\n<DataArray type='Int32' Name='types' format='ascii'>3 9 5 1 4</DataArray>\n"
    "<DataArray type='Int32' Name='connectivity' format='ascii'>0 1 0 1 2 3 1 4 2 3 1 4 2</DataArray>\n"
    "<DataArray type='Int32' Name='offsets' format='ascii'>2 6 9 10 13</DataArray></Cells>\n"
    "<PointData><DataArray type='Float64' Name='T&amp;p &#34;&#x3c;' format='ascii'>1 nan -inf 4 "
    "5</DataArray></PointData>\n"
    "<CellData><DataArray type='Int8' Name='n' format='ascii'>10 20 30 40 50</DataArray>\n"
    "<DataArray type='Int32' Name='marker' format='ascii'>-7 0 0 0 12</DataArray></CellData>\n"
    "</Piece></UnstructuredGrid></VTKFile>\n";

TEST(Vtu, ReadsCommentsQuotesTabsEntitiesAndCellsInAnyOrder)
{
    const MeshData mesh = read_bytes(kVtu, "vtu");
    EXPECT_EQ(mesh.dimension, 2);
    EXPECT_EQ(mesh.points.row(4), Eigen::RowVector3d(2, 0.5, 0));
    EXPECT_EQ(mesh.elements, (std::vector<Element>{{0, 1, 2, 3}, {1, 4, 2, -1}}));
    ASSERT_EQ(mesh.markers.size(), 2U);
    EXPECT_EQ(mesh.markers[0].name, "-7");
    EXPECT_EQ(mesh.markers[1].name, "12");
    EXPECT_EQ(mesh.markers[1].edges, (std::vector<std::array<Index, 2>>{{1, 4}, {4, 2}}));
    ASSERT_EQ(mesh.fields.size(), 3U);
    EXPECT_EQ(mesh.fields[0].name, "T&p \"<");
    EXPECT_TRUE(std::isnan(mesh.fields[0].values(1, 0)));
    EXPECT_EQ(mesh.fields[0].values(2, 0), -HUGE_VAL);
    EXPECT_EQ(mesh.fields[1].values.col(0), Eigen::Vector2d(20, 30));
}

TEST(Vtu, LinesWithoutNumbersAreOneMarker)
{
    const MeshData mesh = read_bytes(replaced(kVtu, "'marker'", "'anything'"), "vtu");
    ASSERT_EQ(mesh.markers.size(), 1U);
    EXPECT_EQ(mesh.markers[0].name, "lines");
    EXPECT_EQ(mesh.markers[0].edges.size(), 3U);
}

TEST(Vtu, RealMeshesComeBackBitForBit)
{
    for (const std::string& path : test::real_meshes()) {
        const MeshData mesh = read_mesh_data(path);
        for (const bool binary : {true, false})
            EXPECT_EQ(difference(mesh, read_bytes(written(mesh, "vtu", {.binary = binary}), "vtu")), "")
                << path;
    }
}

TEST(Vtu, RefusesOtherCellsByName)
{
    const auto with_type = [](const std::string& type) {
        return refusal(replaced(kVtu, "3 9 5", "3 " + type + " 5"), "vtu");
    };
    EXPECT_THAT(
        with_type("22"),
        HasSubstr("cell 1 is a quadratic triangle (type 22), but only meshes of triangles and quads"));
    EXPECT_THAT(with_type("24"), HasSubstr("a quadratic tetrahedron"));
    EXPECT_THAT(with_type("23"), HasSubstr("a quadratic quad"));
    EXPECT_THAT(with_type("69"), HasSubstr("a Lagrange triangle"));
    EXPECT_THAT(with_type("12"), HasSubstr("cell 1 of VTK type 12 has 4 corners, expected 8"));
    EXPECT_THAT(with_type("200"), HasSubstr("200"));
    EXPECT_THAT(with_type("5"), HasSubstr("cell 1 of VTK type 5 has 4 corners, expected 3"));
    EXPECT_THAT(refusal(replaced(kVtu, "2 6 9 10", "2 7 9 10"), "vtu"),
                HasSubstr("cell 1 of VTK type 9 has 5 corners"));
}

TEST(Vtu, RefusesBrokenXmlWithTheLine)
{
    EXPECT_THAT(refusal("", "vtu"), HasSubstr("file:1: an XML file without an element"));
    EXPECT_THAT(refusal("noise", "vtu"), HasSubstr("file:1: text before the first element"));
    EXPECT_THAT(refusal(kVtu.substr(0, kVtu.find("<DataArray type='Int32'")), "vtu"),
                HasSubstr("is not closed; the file is cut off"));
    EXPECT_THAT(refusal(replaced(kVtu, "</Cells>", "</Sells>"), "vtu"),
                HasSubstr("file:15: expected </Cells>"));
    EXPECT_THAT(refusal(replaced(kVtu, "'5' NumberOfCells", "'5 NumberOfCells"), "vtu"),
                HasSubstr("file:6:"));
    EXPECT_THAT(refusal(replaced(kVtu, "&amp;", "&bad;"), "vtu"), HasSubstr("file:16: '&' in an attribute"));
    EXPECT_THAT(refusal(replaced(kVtu, "two -->", "two ->"), "vtu"), HasSubstr("<!-- without the -->"));
    std::string deep;
    for (int i = 0; i < 100000; ++i)
        deep += "<a>";
    EXPECT_THAT(refusal(deep, "vtu"), HasSubstr("file:1: XML elements nested deeper than 32"));
}

TEST(Vtu, RefusesWhatDoesNotFitTogether)
{
    const auto message = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kVtu, from, to), "vtu");
    };
    EXPECT_THAT(
        message("'UnstructuredGrid' version", "'PolyData' version"),
        HasSubstr("file:4: expected <VTKFile type=\"UnstructuredGrid\">, found <VTKFile type=\"PolyData\">"));
    EXPECT_THAT(message("NumberOfPoints='5'", "NumberOfPoints='6'"),
                HasSubstr("has 15 numbers, expected 18"));
    EXPECT_THAT(message("NumberOfPoints='5'", "NumberOfPoints='4'"),
                HasSubstr("has more numbers, expected 12"));
    EXPECT_THAT(message("NumberOfPoints='5'", "NumberOfPoints='2000000000'"),
                HasSubstr("should have 6000000000 numbers, but its text is only"));
    EXPECT_THAT(message("NumberOfPoints='5'", "NumberOfPoints='-5'"),
                HasSubstr("file:6: NumberOfPoints is '-5'"));
    EXPECT_THAT(message("NumberOfPoints='5'", "NumberOfPoints='99999999999'"),
                HasSubstr("expected a number from 0"));
    EXPECT_THAT(message("3 1 4 2<", "3 1 4 5<"), HasSubstr("cell 4 names point 5, but the mesh has 5"));
    EXPECT_THAT(message("3 1 4 2<", "3 1 4 -2<"), HasSubstr("cell 4 names point that is no index"));
    EXPECT_THAT(message("3 1 4 2<", "3 1 four 2<"),
                HasSubstr("file:14: expected number 11 of array 'connectivity', found 'four"));
    EXPECT_THAT(message("2 6 9", "6 2 9"), HasSubstr("cell 1 has corners 6 to 2"));
    EXPECT_THAT(message("10 13<", "10 -1<"), HasSubstr("'offsets' is negative"));
    EXPECT_THAT(message("5e-1", "nan"), HasSubstr("point 4 has a coordinate that is not finite"));
    EXPECT_THAT(message("'Float32'", "'Float16'"), HasSubstr("is of type 'Float16'"));
    EXPECT_THAT(message("Components='3'", "Components='2'"), HasSubstr("points have 2 components"));
    EXPECT_THAT(message("Name='n'", "Name='n' NumberOfComponents='10'"),
                HasSubstr("has 10 components, but 1 to 9"));
    EXPECT_THAT(message("'types'", "'tips'"), HasSubstr("has no array 'types'"));
    EXPECT_THAT(message("format='ascii'>3 9", "format='text'>3 9"), HasSubstr("has format 'text'"));
    EXPECT_THAT(message("version='0.1'", "byte_order='Middle'"), HasSubstr("byte_order 'Middle'"));
    EXPECT_THAT(message("version='0.1'", "header_type='Int8'"), HasSubstr("header_type 'Int8'"));
    EXPECT_THAT(message("version='0.1'", "compressor='vtkLZMADataCompressor'"),
                HasSubstr("vtkLZMADataCompressor"));
    EXPECT_THAT(message("<Piece Number", "<Piece/><Piece Number"),
                HasSubstr("file:6: <Piece> has no NumberOfPoints"));
    EXPECT_THAT(refusal("<VTKFile type='UnstructuredGrid'><UnstructuredGrid/></VTKFile>", "vtu"),
                HasSubstr("file:1: <UnstructuredGrid> has no <Piece>"));
}

TEST(Vtu, RefusesBrokenMarkerNames)
{
    const std::string vtu = written(test::quad_square(1), "vtu", {.binary = false});
    ASSERT_EQ(refusal(vtu, "vtu"), "accepted");
    EXPECT_THAT(refusal(replaced(vtu, "Name=\"marker\"", "Name=\"maker\""), "vtu"),
                HasSubstr("there is no cell array 'marker'"));
    EXPECT_THAT(refusal(replaced(vtu, "0\n1 2 3 4\n", "0\n1 2 3 5\n"), "vtu"),
                HasSubstr("line cell 4 is of marker number 5"));
    EXPECT_THAT(refusal(replaced(vtu, "108 101", "108 999"), "vtu"), HasSubstr("no character code"));
}

TEST(Vtu, RefusesBrokenAppendedData)
{
    const std::string vtu = written(test::quad_square(1), "vtu");
    const std::size_t data = vtu.find('_', vtu.find("<AppendedData")) + 1;
    EXPECT_THAT(refusal(vtu.substr(0, data + 40), "vtu"),
                HasSubstr("array 'Points' needs 104 bytes, but only 12 are left in the file"));
    EXPECT_THAT(refusal(replaced(vtu, "offset=\"0\"", "offset=\"999999\""), "vtu"),
                HasSubstr("array 'marker' starts at byte 999999 of the appended data"));
    EXPECT_THAT(refusal(replaced(vtu, "offset=\"0\"", "offset=\"-1\""), "vtu"),
                HasSubstr("has the offset '-1'"));
    EXPECT_THAT(refusal(replaced(vtu, "offset=\"0\"", "offset=\"1\""), "vtu"),
                HasSubstr("array 'marker' holds"));
    EXPECT_THAT(refusal(replaced(vtu, "encoding=\"raw\"", "encoding=\"hex\""), "vtu"),
                HasSubstr("neither raw nor base64"));
    EXPECT_THAT(refusal(replaced(vtu, "\n_", "\n?"), "vtu"), HasSubstr("does not start with '_'"));
    EXPECT_THAT(refusal(replaced(vtu, "encoding=\"raw\"", "encoding=\"base64\""), "vtu"),
                HasSubstr("array 'Points' is not base64"));
    EXPECT_THAT(refusal(vtu.substr(0, vtu.size() - 60), "vtu"), HasSubstr("left in the file"));
}

TEST(Vtu, RefusesBrokenCompressedData)
{
    const std::string vtu = test::read_text(test::data_path("vtk/inline_zlib.vtu"));
    ASSERT_EQ(refusal(vtu, "vtu"), "accepted");
    const std::size_t points = vtu.find("Name=\"Points\"");
    const std::size_t text = vtu.find_first_not_of(" \n", vtu.find('>', points) + 1);
    const auto with = [&](std::size_t at, const std::string& code) {
        std::string broken = vtu;
        return refusal(broken.replace(text + at, code.size(), code), "vtu");
    };
    EXPECT_THAT(with(0, "!!!!"), HasSubstr("array 'Points' is not base64"));
    EXPECT_THAT(with(0, "////"), HasSubstr("compressed blocks, more than fit the file"));
    EXPECT_THAT(with(12, "////"), HasSubstr("array 'Points'")); // bytes of a block before compression
    EXPECT_THAT(with(64, "////"), HasSubstr("does not hold"));  // in the first block itself
}

TEST(Vtu, RefusesBrokenLz4Data)
{
    const std::string vtu = test::read_text(test::data_path("vtk/raw_lz4.vtu"));
    ASSERT_EQ(refusal(vtu, "vtu"), "accepted");
    std::string broken = vtu;
    const std::size_t data = vtu.find('_', vtu.find("<AppendedData")) + 1;
    const std::size_t first_block = data + (3 + 2) * 8; // 12 doubles make 2 blocks of 64 bytes
    broken.replace(first_block, 4, "\xff\xff\xff\xff");
    EXPECT_THAT(refusal(broken, "vtu"), HasSubstr("compressed block 0 that does not hold 64 bytes"));
}

TEST(Vtu, CompressesArraysThatFillTheirBlocks)
{
    MeshData mesh;
    mesh.points = Points::Zero(8192, 3); // three times the 64 KiB of a block
    Matrix values(8192, 1);
    for (Index i = 0; i < 8192; ++i)
        values(i, 0) = std::sqrt(i);
    mesh.fields = {{"root", FieldLocation::vertex, values}};
    const std::string vtu = written(mesh, "vtu", {.binary = true, .compress = true});
    EXPECT_EQ(difference(mesh, read_bytes(vtu, "vtu")), "");
    EXPECT_LT(vtu.size(), 80000U) << "points take next to nothing, the roots no more than their 65,536 bytes";
}

} // namespace

} // namespace morph
