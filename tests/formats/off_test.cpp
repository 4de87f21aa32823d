// What OFF files hold, and what the reader refuses.
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"
#include "tests/support/surface_cases.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

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

const std::string kOff =
    "# made by hand\r\nCOFF 3 1 3\r\n\r\n0 0\t0 255 0 0\n+1 0 0 1 0 0 # red\n\n 1 1.0D0 .5\n"
    "3\t0 1\n2 0.5 0.5 0.5\n\n# the end\n";

TEST(Off, ReadsCommentsColoursTabsAndForeignLineEnds)
{
    const MeshData mesh = read_bytes(kOff, "off");
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}));
    EXPECT_EQ(mesh.points(2, 2), 0.5);
    EXPECT_EQ(mesh.dimension, 3);
    EXPECT_TRUE(mesh.fields.empty());
}

TEST(Off, WritesTheTextOfTheSpecification)
{
    MeshData mesh = test::square_and_triangle(0);
    EXPECT_EQ(written(mesh, "off"), "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0.5 0\n4 0 1 2 3\n3 1 4 2\n");
    mesh.fields = {{"texture", FieldLocation::vertex, Matrix::Constant(5, 2, 0.25)},
                   {"color", FieldLocation::vertex, Matrix::Constant(5, 4, 1)},
                   {"normal", FieldLocation::vertex, Matrix::Constant(5, 3, -1)}};
    EXPECT_THAT(written(mesh, "off"), HasSubstr("STCNOFF\n5 2 0\n0 0 0 -1 -1 -1 1 1 1 1 0.25 0.25\n1 0 0"));
}

TEST(Off, NormalsColoursAndTexturesComeBackBitForBit)
{
    for (const std::size_t kept : {1U, 2U, 4U, 7U}) {
        MeshData mesh = bare(test::quad_square(3));
        const auto rows = mesh.points.rows();
        const std::vector<Field> fields{
            {"normal", FieldLocation::vertex, Matrix::Random(rows, 3)},
            {"color", FieldLocation::vertex, Matrix::Random(rows, kept == 2 ? 3 : 4)},
            {"texture", FieldLocation::vertex, Matrix::Random(rows, 2)}};
        for (std::size_t f = 0; f < 3; ++f)
            if ((kept >> f & 1U) != 0)
                mesh.fields.push_back(fields[f]);
        EXPECT_EQ(difference(read_bytes(written(mesh, "off"), "off"), mesh), "") << kept;
    }
}

TEST(Off, NamesTheFieldsItCannotHold)
{
    const test::TemporaryFolder folder;
    MeshData mesh = small_surface();
    mesh.fields = {{"p", FieldLocation::vertex, Matrix::Zero(6, 1)},
                   {"normal", FieldLocation::vertex, Matrix::Zero(6, 2)},
                   {"color", FieldLocation::vertex, Matrix::Zero(6, 3)}};
    EXPECT_THAT(write_mesh_data(mesh, folder.file("a.off")),
                ElementsAre(HasSubstr("off cannot hold 2 nodal field(s) p, normal, only normal, color and")));
}

std::vector<std::string> warnings_of(const std::string& bytes)
{
    ReadNotes notes;
    find_format("", "off").read({"file", bytes, {}, &notes});
    return notes.warnings;
}

TEST(Off, SaysWhatItLeavesOut)
{
    EXPECT_THAT(warnings_of(kOff),
                ElementsAre(HasSubstr("the numbers behind the coordinates of vertices were"),
                            "file: the colours of 1 face(s) were left out"));
    EXPECT_THAT(warnings_of("OFF 1 0 0\n0 0 0 1 1 1\n"), ElementsAre(HasSubstr("the numbers behind")));
    EXPECT_THAT(warnings_of("COFF 1 0 0\n0 0 0 7\n"),
                ElementsAre(HasSubstr("the numbers behind"))); // a table's
    EXPECT_THAT(warnings_of("NOFF 1 0 0\n0 0 0 0 0 1\n"), ElementsAre());
}

/// Four bytes, those of higher value first.
std::string big_endian(std::uint32_t bits)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(bits >> shift & 255U);
    return bytes;
}

std::string integers(const std::vector<std::uint32_t>& numbers)
{
    std::string bytes;
    for (const std::uint32_t number : numbers)
        bytes += big_endian(number);
    return bytes;
}

std::string reals(const std::vector<float>& numbers)
{
    std::string bytes;
    for (const float number : numbers)
        bytes += big_endian(std::bit_cast<std::uint32_t>(number));
    return bytes;
}

/// A quad with a colour and a triangle without, as Geomview has them.
const std::string kBinary = "COFF BINARY\n" + integers({5, 2, 0}) +
                            reals({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0,  0, 1, 1, 1,  0, 1,
                                   0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 2, .5, 3, 1, 0, .5, 1}) +
                            integers({4, 0, 1, 2, 3, 3}) + reals({1, 0, 0}) + integers({3, 1, 4, 2, 0});

TEST(Off, ReadsTheBinaryFormOfGeomview)
{
    const MeshData mesh = read_bytes(kBinary, "off");
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, 3}, Element{1, 4, 2, -1}));
    EXPECT_EQ(mesh.points.row(4), Eigen::RowVector3d(2, 0.5, 3));
    ASSERT_EQ(mesh.fields.size(), 1U);
    EXPECT_EQ(mesh.fields[0].name, "color");
    EXPECT_EQ(mesh.fields[0].values.row(4), Eigen::RowVector4d(1, 0, 0.5, 1));
    EXPECT_THAT(warnings_of(kBinary), ElementsAre("file: the colours of 1 face(s) were left out"));
}

TEST(Off, RefusesBrokenBytesWithTheirPlace)
{
    EXPECT_EQ(refusal(kBinary.substr(0, kBinary.size() - 2), "off"),
              "file: byte 216: the file ends within its numbers; it is cut off");
    EXPECT_EQ(refusal(kBinary + "x", "off"), "file: byte 220: expected the end of the file after 2 faces");
    EXPECT_THAT(refusal(replaced(kBinary, integers({4, 0, 1}), integers({4, 0, 7})), "off"),
                HasSubstr("face 0 names vertex 7, but the mesh has 5"));
    EXPECT_THAT(refusal(replaced(kBinary, integers({4, 0, 1}), integers({5, 0, 1})), "off"),
                HasSubstr("face 0 has 5 corners"));
    EXPECT_THAT(refusal(replaced(kBinary, reals({2, .5, 3}), integers({0x7f800000, 0, 0})), "off"),
                HasSubstr("a coordinate of vertex 4 is not finite"));
    EXPECT_THAT(refusal(replaced(kBinary, integers({5, 2, 0}), integers({0x7fffffff, 2, 0})), "off"),
                HasSubstr("byte 12: there should be 2147483647 vertices, but only"));
    EXPECT_EQ(refusal(replaced(kBinary, integers({1, 4, 2, 0}), integers({1, 4, 2, 0x7fffffff})), "off"),
              "file: byte 216: a face has 2147483647 colour components");
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
    EXPECT_EQ(refusal(replaced(off, "OFF", "OFF BINARY"), "off"),
              "file: byte 11: there should be 874525216 vertices, but only 42 bytes follow");
}

TEST(Off, SurvivesMutations)
{
    MeshData mesh = small_surface();
    mesh.fields = {{"color", FieldLocation::vertex, Matrix::Random(6, 3)},
                   {"texture", FieldLocation::vertex, Matrix::Random(6, 2)}};
    test::survive_mutations("off", {written(mesh, "off"), kOff, kBinary}, 2000);
}

} // namespace

} // namespace morph
