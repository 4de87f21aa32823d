// Fields of a mesh from a file of their own.
#include "formats/field_file.h"
#include "formats/formats.h"
#include "tests/support/errors.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace morph {

namespace {

using test::difference;
using test::message_of;
using test::square_and_triangle;
using test::TemporaryFolder;

/// As many coordinates as square_and_triangle(0), and a field.
const std::string kTable = "x,y,T\n0,0,10\n1,0,11\n1,1,12\n0,1,13\n2,0.5,14\n";

/// The mesh with the fields that read_fields() finds in these bytes, nothing else changed.
MeshData with_fields(MeshData mesh, const std::string& name, const std::string& text)
{
    const TemporaryFolder folder;
    mesh.fields = read_fields(folder.write(name, text), mesh).fields;
    return mesh;
}

/// The message of the refusal, the folder's name taken off; "nothing was thrown" when there is none.
std::string refusal(const MeshData& mesh, const std::string& name, const std::string& text)
{
    const TemporaryFolder folder;
    const std::string path = folder.write(name, text);
    const std::string message = message_of([&] { read_fields(path, mesh); });
    return message.starts_with(folder.path()) ? message.substr(folder.path().size() + 1) : message;
}

TEST(FieldFile, FieldsComeBackBitForBitFromEveryFormatThatHoldsThem)
{
    const TemporaryFolder folder;
    for (const std::string format : {"csv", "su2_restart", "vtk", "vtu"})
        for (MeshData mesh : {test::rich_meshes()[2].second, test::rich_meshes()[3].second}) {
            const bool elements = find_format("", format).holds.element_fields;
            std::erase_if(mesh.fields, [&](const Field& field) {
                return field.location == FieldLocation::element && !elements;
            });
            write_mesh_data(mesh, folder.file("fields"), format);
            MeshData read = mesh;
            read.fields = read_fields(folder.file("fields"), mesh, format).fields;
            EXPECT_EQ(difference(read, mesh), "") << format;
        }
}

TEST(FieldFile, RowsAreTakenInOrderOrByPointId)
{
    const MeshData mesh = square_and_triangle(0);
    const Matrix expected = (Matrix(5, 1) << 10, 11, 12, 13, 14).finished();
    const MeshData in_order = with_fields(mesh, "fields.csv", kTable);
    ASSERT_EQ(in_order.fields.size(), 1U);
    EXPECT_EQ(in_order.fields[0].name, "T");
    EXPECT_EQ(in_order.fields[0].values, expected);
    EXPECT_EQ(
        with_fields(mesh, "fields.csv", "PointID,x,y,T\n4,2,.5,14\n3,0,1,13\n2,1,1,12\n1,1,0,11\n0,0,0,10\n")
            .fields[0]
            .values,
        expected);
}

TEST(FieldFile, TheCoordinatesMayBeMissing)
{
    const MeshData read =
        with_fields(square_and_triangle(0), "fields.csv", "v_0,z,v_1\n1,2,3\n4,5,6\n7,8,9\n1,1,1\n2,2,2\n");
    ASSERT_EQ(read.fields.size(), 3U);
    EXPECT_EQ(read.fields[1].name, "z") << "without x and y it is no coordinate";
    EXPECT_EQ(read.fields[1].values(2, 0), 8);
}

TEST(FieldFile, KnowsAnSu2RestartFile)
{
    const TemporaryFolder folder;
    const MeshData mesh = square_and_triangle(0);
    EXPECT_FALSE(read_fields(folder.write("table.csv", kTable), mesh).su2_restart);
    MeshData restart = with_fields(mesh, "fields.csv", kTable);
    write_mesh_data(restart, folder.file("restart.csv"), "su2_restart");
    EXPECT_TRUE(read_fields(folder.file("restart.csv"), mesh).su2_restart);
}

TEST(FieldFile, FunctionValuesAreTheFieldF)
{
    const MeshData read =
        with_fields(square_and_triangle(0), "values.txt", "2\n1 10 11 12 13\n2 11 14 12 0\n");
    ASSERT_EQ(read.fields.size(), 1U);
    EXPECT_EQ(read.fields[0].name, "f");
    EXPECT_EQ(read.fields[0].values, (Matrix(5, 1) << 10, 11, 12, 13, 14).finished());
}

// The diagonal of this mesh is sqrt(5) in any unit: a millionth of it is 2.2e-6.
TEST(FieldFile, VerticesMayLieElsewhereByAMillionthOfTheMesh)
{
    for (const double unit : {1.0, 1e-3, 1e8}) {
        MeshData mesh = square_and_triangle(0);
        mesh.points *= unit;
        MeshData other = mesh;
        other.fields = {{"T", FieldLocation::vertex, Matrix::Ones(5, 1)}};
        const auto table = [&](double shift) {
            other.points(4, 0) = (2 + shift) * unit;
            return test::written(other, "csv");
        };
        EXPECT_EQ(refusal(mesh, "fields.csv", table(2.1e-6)), "nothing was thrown") << unit;
        EXPECT_THAT(refusal(mesh, "fields.csv", table(2.4e-6)),
                    testing::StartsWith("fields.csv:6: vertex 4 is at"))
            << unit;
    }
}

TEST(FieldFile, FieldsOfAnotherMeshAreRefused)
{
    const MeshData mesh = square_and_triangle(0);
    const std::string restart = "PointID,y,x,T\n# half\n1,0,1,1\n0,0,0,1\n3,1,0,1\n2,1,1,1\n4,0.5,2.25,1\n";
    EXPECT_EQ(
        refusal(mesh, "fields.csv", restart),
        "fields.csv:7: vertex 4 is at 2.25 0.5, but in the mesh at 2 0.5; these are fields of another mesh");
    EXPECT_EQ(refusal(mesh, "fields.csv", "x,y,z,T\n0,0,3,1\n1,0,0,1\n1,1,0,1\n0,1,0,1\n2,0.5,0,1\n"),
              "fields.csv:2: vertex 0 is at 0 0 3, but in the mesh at 0 0; these are fields of another mesh");
    MeshData other = with_fields(mesh, "fields.csv", kTable);
    other.points(1, 1) = 0.5;
    EXPECT_EQ(refusal(mesh, "fields.vtu", test::written(other, "vtu")),
              "fields.vtu: vertex 1 is at 1 0.5, but in the mesh at 1 0; these are fields of another mesh");
}

TEST(FieldFile, BothCountsAreNamedWhenTheyDiffer)
{
    const MeshData mesh = square_and_triangle(0);
    EXPECT_EQ(refusal(mesh, "fields.csv", "T\n1\n2\n"),
              "fields.csv: holds fields of 2 vertices, but the mesh has 5");
    EXPECT_EQ(refusal(mesh, "values.txt", "7\n"),
              "values.txt:1: holds values of 7 elements, but the mesh has 2");
    MeshData other = with_fields(mesh, "fields.csv", kTable);
    other.elements.pop_back();
    EXPECT_EQ(refusal(mesh, "fields.vtu", test::written(other, "vtu")),
              "fields.vtu: holds fields of 1 elements, but the mesh has 2");
    EXPECT_EQ(refusal(mesh, "fields.vtu", test::written(test::rich_meshes()[0].second, "vtu")),
              "fields.vtu: holds fields of 16 vertices, but the mesh has 5");
}

TEST(FieldFile, ValuesThatAreNotFiniteAreNamedWithFieldAndPlace)
{
    const MeshData mesh = square_and_triangle(0);
    MeshData broken = mesh;
    broken.fields = {{"T", FieldLocation::vertex, Matrix::Zero(5, 1)},
                     {"u", FieldLocation::vertex, Matrix::Zero(5, 2)},
                     {"p", FieldLocation::element, Matrix::Zero(2, 1)}};
    broken.fields[1].values(3, 1) = std::numeric_limits<double>::quiet_NaN();
    broken.fields[2].values(1, 0) = -std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal(mesh, "fields.vtu", test::written(broken, "vtu")),
              "fields.vtu: field 'u' is nan at vertex 3");
    broken.fields[1].values(3, 1) = 0;
    EXPECT_EQ(refusal(mesh, "fields.vtu", test::written(broken, "vtu")),
              "fields.vtu: field 'p' is -inf in element 1");
    EXPECT_EQ(refusal(mesh, "fields.csv", test::replaced(kTable, "13", "nan")),
              "fields.csv:5: column 'T' is 'nan', but a finite number was expected");
}

TEST(FieldFile, AFileWithoutFieldsIsRefused)
{
    const MeshData mesh = square_and_triangle(0);
    EXPECT_EQ(refusal(mesh, "fields.csv", "x,y\n0,0\n1,0\n1,1\n0,1\n2,0.5\n"), "fields.csv: has no fields");
    EXPECT_EQ(refusal(mesh, "mesh.su2", test::written(mesh, "su2")), "mesh.su2: has no fields");
    EXPECT_THAT(refusal(mesh, "fields.xyz", ""), testing::StartsWith("fields.xyz: the extension '.xyz'"));
}

TEST(FieldFile, SurvivesMutatedFiles)
{
    const MeshData mesh = square_and_triangle(0);
    for (const auto& [format, seed] :
         {std::pair<std::string, std::string>{
              "csv", "PointID,x,y,T\n4,2,.5,14\n3,0,1,13\n2,1,1,12\n1,1,0,11\n0,0,0,1\n"},
          {"csv", kTable},
          {"thesis", "2\n1 10 11 12 13\n2 11 14 12 0\n"},
          {"vtu", test::written(with_fields(mesh, "fields.csv", kTable), "vtu", {.binary = false})}}) {
        const auto read = [&, name = format](const InputBytes& file) {
            MeshData with_file = mesh;
            with_file.fields = parse_fields(file, mesh, name).fields;
            return with_file;
        };
        test::survive_mutations(read, {seed}, 400);
    }
}

} // namespace

} // namespace morph
