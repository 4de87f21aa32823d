#include "formats/formats.h"
#include "formats/medit/solutions.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using test::difference;
using test::replaced;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// As libMeshb has it: the number of solutions and the type of each, then the values of a line.
const std::string kSolutions = "MeshVersionFormatted 2\n"
                               "\n"
                               "Dimension 2\n"
                               "\n"
                               "SolAtVertices\n"
                               "5\n"
                               "8 1 2 3 1 1 1 1 1\n"
                               "0 0.5 1 1.5 2 2.5 3 3.5 4 4.5 5\n"
                               "1 1.5 2 2.5 3 3.5 4 4.5 5 5.5 6\n"
                               "2 2.5 3 3.5 4 4.5 5 5.5 6 6.5 7\n"
                               "3 3.5 4 4.5 5 5.5 6 6.5 7 7.5 8\n"
                               "4 4.5 5 5.5 6 6.5 7 7.5 8 8.5 9\n"
                               "\n"
                               "SolAtTriangles\n"
                               "1\n"
                               "1 4\n"
                               "1 2 3 4\n"
                               "\n"
                               "SolAtQuadrilaterals\n"
                               "1\n"
                               "1 4\n"
                               "-1 -2 -3 -4\n"
                               "\n"
                               "End\n"
                               "\n"
                               "# vertex field 1 = p\n"
                               "# vertex field 2 = velocity\n"
                               "# vertex field 3 = metric\n"
                               "# vertex field 4 to 8 = five = 5\n"
                               "# element field 1 = F\n";

MeshData mesh_with_fields()
{
    MeshData mesh = test::square_and_triangle(0);
    Eigen::Index column = 0;
    for (const auto& [name, columns] :
         {std::pair("p", 1), std::pair("velocity", 2), std::pair("metric", 3), std::pair("five = 5", 5)}) {
        Field& field = mesh.fields.emplace_back(Field{name, FieldLocation::vertex, Matrix(5, columns)});
        for (Eigen::Index v = 0; v < 5; ++v)
            for (Eigen::Index c = 0; c < columns; ++c)
                field.values(v, c) = static_cast<double>(v) + 0.5 * static_cast<double>(column + c);
        column += columns;
    }
    Matrix element_values(2, 4);
    element_values << -1, -2, -3, -4, 1, 2, 3, 4;
    mesh.fields.push_back({"F", FieldLocation::element, element_values});
    return mesh;
}

/// A mesh with these solutions, and the warnings.
std::pair<MeshData, std::vector<std::string>> with_solutions(const std::string& solutions)
{
    MeshData mesh = test::square_and_triangle(0);
    ReadNotes notes;
    read_medit_solutions({"file", solutions, {}, &notes}, mesh);
    return {mesh, notes.warnings};
}

std::string refusal(const std::string& solutions)
{
    try {
        with_solutions(solutions);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

std::vector<std::string> field_names(const MeshData& mesh)
{
    std::vector<std::string> names;
    for (const Field& field : mesh.fields)
        names.push_back(field.name);
    return names;
}

TEST(MeditSolutions, AreWrittenAsTheDocumentationHasThem)
{
    const test::TemporaryFolder folder;
    EXPECT_THAT(write_mesh_data(mesh_with_fields(), folder.file("a.mesh")), IsEmpty());
    EXPECT_EQ(test::read_text(folder.file("a.sol")), kSolutions);
}

TEST(MeditSolutions, AreReadFromTheFileBesideTheMesh)
{
    const test::TemporaryFolder folder;
    for (const std::string mesh : {"a.mesh", "b.meshb"}) {
        write_mesh_data(mesh_with_fields(), folder.file(mesh));
        EXPECT_EQ(difference(read_mesh_data(folder.file(mesh)), mesh_with_fields()), "");
    }
    EXPECT_THAT(folder.names(), ElementsAre("a.mesh", "a.sol", "b.meshb", "b.solb"));
}

TEST(MeditSolutions, PreferTheFileOfTheSameKind)
{
    const test::TemporaryFolder folder;
    MeshData mesh = mesh_with_fields();
    write_mesh_data(mesh, folder.file("a.meshb"));
    mesh.fields.resize(1);
    write_mesh_data(mesh, folder.file("a.mesh"));
    EXPECT_EQ(read_mesh_data(folder.file("a.mesh")).fields.size(), 1U);
    EXPECT_EQ(read_mesh_data(folder.file("a.meshb")).fields.size(), 5U);
}

TEST(MeditSolutions, MayBeOfTheOtherKindThanTheMesh)
{
    const test::TemporaryFolder folder;
    MeshData mesh = mesh_with_fields();
    write_mesh_data(mesh, folder.file("a.mesh"));
    mesh.fields.clear();
    write_mesh_data(mesh, folder.file("a.meshb"));
    EXPECT_EQ(difference(read_mesh_data(folder.file("a.meshb")), mesh_with_fields()), "");
}

TEST(MeditSolutions, AreCountedWhenTheFileHasNoNames)
{
    const auto [mesh, warnings] = with_solutions("MeshVersionFormatted 1 Dimension 2 SolAtVertices 5 2 1 2\n"
                                                 "1 2 3 4 5 6 7 8 9 10 11 12 13 nan -inf End");
    EXPECT_THAT(field_names(mesh), ElementsAre("solution_1", "solution_2"));
    EXPECT_EQ(mesh.fields[1].values(3, 1), 12);
    EXPECT_TRUE(std::isnan(mesh.fields[1].values(4, 0)));
    EXPECT_EQ(mesh.fields[1].values(4, 1), -HUGE_VAL);
    EXPECT_THAT(warnings, IsEmpty());
}

TEST(MeditSolutions, PassOverNamesThatDoNotFit)
{
    const auto [mesh, warnings] =
        with_solutions(replaced(replaced(kSolutions, "# vertex field 4 to 8", "# vertex field 4 to 9"),
                                "field 2 = v", "field 2 to 8 = v"));
    EXPECT_THAT(field_names(mesh), ElementsAre("p", "solution_2", "metric", "solution_4", "solution_5",
                                               "solution_6", "solution_7", "solution_8", "F"));
}

TEST(MeditSolutions, AreLeftOutWithAWarningWhenTheyDoNotFitTheMesh)
{
    const auto [fewer, fewer_warnings] =
        with_solutions(replaced(replaced(kSolutions, "SolAtVertices\n5", "SolAtVertices\n4"),
                                "4 4.5 5 5.5 6 6.5 7 7.5 8 8.5 9\n", ""));
    EXPECT_THAT(field_names(fewer), ElementsAre("F"));
    EXPECT_THAT(fewer_warnings,
                ElementsAre("file: SolAtVertices was left out: it has 4 lines, but the mesh has 5"));

    const auto [half, half_warnings] =
        with_solutions(replaced(kSolutions, "SolAtQuadrilaterals", "SolAtEdges"));
    EXPECT_EQ(half.fields.size(), 4U);
    EXPECT_THAT(half_warnings,
                ElementsAre("file: the section 'SolAtEdges' was left out",
                            "file: element fields were left out: SolAtQuadrilaterals is missing "
                            "or does not fit"));

    const auto [other, other_warnings] = with_solutions(replaced(kSolutions, "1 4\n-1", "4 1 1 1 1\n-1"));
    EXPECT_EQ(other.fields.size(), 4U);
    EXPECT_THAT(other_warnings,
                ElementsAre(HasSubstr("SolAtTriangles and SolAtQuadrilaterals have other types")));
}

TEST(MeditSolutions, OfAVolumeComeToItsSurface)
{
    const test::TemporaryFolder folder;
    const std::string mesh =
        folder.write("a.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 5\n9 9 9 0\n0 0 0 0\n"
                               "1 0 0 0\n0 1 0 0\n0 0 1 0\nTetrahedra 1\n2 3 4 5 0\nEnd\n");
    folder.write("a.sol", "MeshVersionFormatted 2\nDimension 3\nSolAtVertices 5 1 1\n10 11 12 13 14\n"
                          "SolAtTetrahedra 1 1 1\n3\nEnd\n");
    ReadNotes notes;
    const MeshData surface = read_mesh_data(mesh, "", {true, ""}, &notes);
    ASSERT_EQ(surface.fields.size(), 1U);
    EXPECT_EQ(surface.fields[0].values, (Matrix(4, 1) << 11, 12, 13, 14).finished());
    EXPECT_THAT(notes.warnings, ElementsAre(HasSubstr("a.sol: the section 'SolAtTetrahedra' was left out")));
}

TEST(MeditSolutions, SayWhatIsWrongAndWhere)
{
    const auto changed = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kSolutions, from, to));
    };
    EXPECT_EQ(
        changed("8 1 2", "8 0 2"),
        "file:7: solution 1 is of type 0, expected 1 (scalar), 2 (vector), 3 (symmetric) or 4 (matrix)");
    EXPECT_EQ(
        changed("8 1 2", "99 1 2"),
        "file:8: solution 9 is of type 0, expected 1 (scalar), 2 (vector), 3 (symmetric) or 4 (matrix)");
    EXPECT_EQ(changed("8.5 9", "8.5 nine"),
              "file:12: expected a value of line 5 of SolAtVertices, found 'nine'");
    EXPECT_EQ(changed("Vertices\n5", "Vertices\n500"),
              "file:5: SolAtVertices has 500 lines by its count, but the file ends before");
    EXPECT_EQ(changed("SolAtQuadrilaterals", "SolAtTriangles"), "file:19: SolAtTriangles is given again");
    EXPECT_EQ(changed("MeshVersion", "Version"),
              "file:1: expected the keyword MeshVersionFormatted, found 'VersionFormatted'");
}

TEST(MeditSolutions, SurviveDamagedFiles)
{
    const test::TemporaryFolder folder;
    write_mesh_data(mesh_with_fields(), folder.file("a.meshb"));
    const auto read = [](const InputBytes& file) {
        MeshData mesh = test::square_and_triangle(0);
        read_medit_solutions(file, mesh);
        return mesh;
    };
    test::survive_mutations(read, {kSolutions, test::read_text(folder.file("a.solb"))}, 2000);
}

} // namespace

} // namespace morph
