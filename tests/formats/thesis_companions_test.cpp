// The text files of the thesis that go with a mesh: function values and neighbours.
#include "formats/formats.h"
#include "formats/thesis/files.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace morph {

namespace {

using test::message_of;
using test::planar_meshes;
using test::read_bytes;
using test::read_text;
using test::replaced;
using test::square_and_triangle;
using test::TemporaryFolder;

using Neighbors = std::vector<std::array<Index, 4>>;

Field read_values(const std::string& text, const MeshData& mesh)
{
    return read_thesis_values({"file", text}, mesh);
}

std::string value_refusal(const std::string& text, const MeshData& mesh)
{
    return message_of([&] { read_values(text, mesh); });
}

std::string neighbor_refusal(const std::string& text, const MeshData& mesh)
{
    return message_of([&] { check_thesis_neighbors({"file", text}, build_mesh(mesh)); });
}

TEST(ThesisValues, EveryComponentComesBackBitForBitWithItsMesh)
{
    const TemporaryFolder folder;
    for (const auto& [name, mesh] : planar_meshes()) {
        write_mesh_data(mesh, folder.file("out.txt"));
        const MeshData read = read_mesh_data(folder.file("out.txt"));
        std::map<std::array<double, 2>, Index> vertex_at;
        for (Index v = 0; v < mesh.points.rows(); ++v)
            vertex_at[{mesh.points(v, 0), mesh.points(v, 1)}] = v;
        const Field* const field = find_field(mesh.fields, "v2", FieldLocation::vertex);
        if (!field)
            continue;
        for (const Eigen::Index c : {0, 1}) {
            const Field values =
                read_values(read_text(folder.file("out.v2_" + std::to_string(c) + ".txt")), read);
            EXPECT_EQ(values.name, "f");
            for (Index v = 0; v < read.points.rows(); ++v)
                EXPECT_EQ(values.values(v, 0),
                          field->values(vertex_at.at({read.points(v, 0), read.points(v, 1)}), c))
                    << name << ", vertex " << v;
        }
    }
}

TEST(ThesisValues, ReadsTabsBlankLinesAndFortranExponents)
{
    const MeshData mesh = square_and_triangle(0);
    const Field field = read_values("\r\n2\r\n\n1 1D1 +2 3\t4 \r\n\r\n 2 2. 5e0 3 0", mesh);
    EXPECT_EQ(field.values, (Matrix(5, 1) << 10, 2, 3, 4, 5).finished());
}

TEST(ThesisValues, FollowTheMeshThatEndsAQuadAtTheOriginAndTheFilesThatDoNot)
{
    const Matrix expected = (Matrix(5, 1) << 1, 2, 3, 4, 5).finished();
    const MeshData mesh = square_and_triangle(1); // corners 1, 2, 3, 0
    EXPECT_EQ(read_values("2\n1 2 3 4 1\n2 2 5 3 0\n", mesh).values, expected) << "as the mesh lists them";
    EXPECT_EQ(read_values("2\n1 3 4 1 2\n2 2 5 3 0\n", mesh).values, expected) << "as they are written";
}

TEST(ThesisValues, ValuesOfOneNodeMayDifferByRoundingOfTheirRange)
{
    const MeshData mesh = square_and_triangle(0);
    // a range of 1000, and so 1e-6 of rounding, whatever stands in place of a triangle's fourth value
    EXPECT_EQ(read_values("2\n1 0 1 1000 500\n2 1.0000009 7 1000 0\n", mesh).values(1, 0), 1);
    EXPECT_EQ(value_refusal("2\n1 0 1 1000 500\n2 1.0000011 7 1000 1e9\n", mesh),
              "file:3: vertex 1 at 1 0 has the value 1.0000011 in element 2, but 1 in element 1");
}

TEST(ThesisValues, EveryBrokenFileIsRefusedWithItsLine)
{
    const MeshData mesh = square_and_triangle(0);
    const std::string good = "2\n1 1 2 3 4\n2 2 5 3 0\n";
    const auto broken = [&](const std::string& from, const std::string& to) {
        return value_refusal(replaced(good, from, to), mesh);
    };
    EXPECT_EQ(value_refusal("", mesh), "file:1: expected the number of elements, found the end of the file");
    EXPECT_EQ(broken("2\n1", "\n3\n1"), "file:2: holds values of 3 elements, but the mesh has 2");
    EXPECT_EQ(broken("2\n1", "2 3\n1"),
              "file:1: expected the end of the line after the number of elements, found '3'");
    EXPECT_EQ(broken("2 2 5 3 0\n", ""), "file:1: holds values of 2 elements, but 1 rows follow");
    EXPECT_EQ(broken("2 2 5 3 0\n", "2 2 5 3 0\n3 1 1 1 1\n"),
              "file:1: holds values of 2 elements, but 3 rows follow");
    EXPECT_EQ(broken("2 2 5", "7 2 5"), "file:3: element 2 was expected, found 7");
    EXPECT_EQ(broken("2 2 5 3 0", "2 2 5 3"),
              "file:3: expected the value at a corner, found the end of the line");
    EXPECT_EQ(broken("2 2 5 3", "2 2 inf 3"), "file:3: expected the value at a corner, found 'inf'");
    EXPECT_EQ(broken("3 4", "3 4 5"), "file:2: expected the end of the line after four values, found '5'");
    EXPECT_EQ(broken("2 2 5", "2 2.5 5"),
              "file:3: vertex 1 at 1 0 has the value 2.5 in element 2, but 2 in element 1");
}

TEST(ThesisValues, AVertexOfNoElementHasNoValue)
{
    MeshData mesh = square_and_triangle(0);
    mesh.points.conservativeResize(6, Eigen::NoChange);
    mesh.points.row(5).setConstant(9);
    EXPECT_EQ(value_refusal("2\n1 1 2 3 4\n2 2 5 3 0\n", mesh),
              "file: holds values at the corners of elements, but vertex 5 of the mesh belongs to none");
}

TEST(ThesisValues, SurviveMutatedFiles)
{
    MeshData mesh = test::quad_square(2);
    const auto read = [&](const InputBytes& file) {
        MeshData with_field = mesh;
        with_field.fields = {read_thesis_values(file, mesh)};
        return with_field;
    };
    const TemporaryFolder folder;
    mesh.fields = {{"T", FieldLocation::vertex, mesh.points.col(0)}};
    write_mesh_data(mesh, folder.file("out.txt"));
    test::survive_mutations(read, {read_text(folder.file("out.T.txt"))}, 600);
}

/// Neighbours by comparing every side with every other.
Neighbors neighbors_by_comparing(const MeshData& mesh)
{
    const auto side = [&](std::size_t e, int k) {
        const Element& element = mesh.elements[e];
        std::set<Index> ends{element[static_cast<std::size_t>(k)],
                             element[static_cast<std::size_t>((k + 1) % corner_count(element))]};
        return ends;
    };
    Neighbors all(mesh.elements.size(), {-1, -1, -1, -1});
    for (std::size_t e = 0; e < all.size(); ++e)
        for (int k = 0; k < corner_count(mesh.elements[e]); ++k)
            for (std::size_t other = 0; other < all.size(); ++other)
                for (int j = 0; j < corner_count(mesh.elements[other]); ++j)
                    if (other != e && side(e, k) == side(other, j))
                        all[e][static_cast<std::size_t>(k)] = static_cast<Index>(other);
    return all;
}

TEST(ThesisNeighbors, AreTheElementsThatShareASideWhicheverWayRoundTheyAreListed)
{
    for (const auto& [name, mesh] : planar_meshes()) {
        MeshData data = test::shuffled(mesh, 5);
        EXPECT_EQ(element_neighbors(build_mesh(data)), neighbors_by_comparing(data)) << name;
        test::turn_some(data, 0.3, 7);
        EXPECT_EQ(element_neighbors(build_mesh(data)), neighbors_by_comparing(data))
            << name << ", some turned";
    }
}

TEST(ThesisNeighbors, TheFileWrittenWithAMeshAgreesWithItAndWithTheMeshReadBack)
{
    const TemporaryFolder folder;
    for (const auto& [name, mesh] : planar_meshes()) {
        write_mesh_data(mesh, folder.file("out.txt"));
        const std::string text = read_text(folder.file("out.neighbours.txt"));
        EXPECT_EQ(neighbor_refusal(text, mesh), "nothing was thrown") << name;
        EXPECT_EQ(neighbor_refusal(text, read_mesh_data(folder.file("out.txt"))), "nothing was thrown")
            << name;
    }
}

TEST(ThesisNeighbors, AreWrittenByTheSidesFromEachCornerToTheNext)
{
    const TemporaryFolder folder;
    write_mesh_data(square_and_triangle(0), folder.file("out.txt"));
    EXPECT_EQ(read_text(folder.file("out.neighbours.txt")), "2\nid n1 n2 n3 n4\n1 0 2 0 0\n2 0 0 1\n");
    write_mesh_data(square_and_triangle(1), folder.file("out.txt")); // written from corner 2 on
    EXPECT_EQ(read_text(folder.file("out.neighbours.txt")), "2\nid n1 n2 n3 n4\n1 0 0 0 2\n2 0 0 1\n");
}

/// Neighbours in a file whose first side begins at corner @p first and whose boundary is @p none.
std::string neighbor_file(const MeshData& mesh, std::size_t first, const std::string& none)
{
    const Neighbors all = neighbors_by_comparing(mesh);
    std::string text = std::to_string(all.size()) + "\r\nheading\r\n";
    for (std::size_t e = 0; e < all.size(); ++e) {
        const auto sides = static_cast<std::size_t>(corner_count(mesh.elements[e]));
        text += std::to_string(e + 1);
        for (std::size_t k = 0; k < sides; ++k) {
            const Index neighbor = all[e][(k + first) % sides];
            text += "\t" + (neighbor < 0 ? none : std::to_string(neighbor + 1));
        }
        text += sides == 3 ? "\t" + none + "\r\n" : "\r\n";
    }
    return text;
}

TEST(ThesisNeighbors, TheFirstSideMayBeAnyAndTheBoundaryAnyNumberAboveTheCount)
{
    for (const auto& [name, mesh] : planar_meshes())
        for (const std::size_t first : {0U, 1U, 2U, 3U})
            for (const std::string none : {"0", "2147483647"})
                EXPECT_EQ(neighbor_refusal(neighbor_file(mesh, first, none), mesh), "nothing was thrown")
                    << name << ", from corner " << first;
}

TEST(ThesisNeighbors, FollowAMeshThatEndsAQuadAtTheOrigin)
{
    const MeshData mesh = read_bytes("6 0 2\nid\n1 1 0 1 1 0 1 0 0\n2 1 0 2 0 2 1 1 1\n", "thesis");
    EXPECT_EQ(neighbor_refusal("2\nid\n1 2 0 0 0\n2 0 0 0 1\n", mesh), "nothing was thrown");
}

TEST(ThesisNeighbors, TheFirstElementThatDiffersIsNamedWithBothListsInTheOrderOfTheFile)
{
    const MeshData mesh = test::quad_square(3);
    const std::string good = neighbor_file(mesh, 1, "0");
    ASSERT_EQ(neighbor_refusal(good, mesh), "nothing was thrown");
    EXPECT_EQ(neighbor_refusal(replaced(good, "5\t6\t8\t4\t2", "5\t6\t7\t4\t2"), mesh),
              "file:7: element 5 has the neighbours 6 7 4 2, but in the mesh 6 8 4 2 (0: none)");
    EXPECT_EQ(neighbor_refusal(replaced(good, "5\t6\t8\t4\t2", "5\t6\t8\t4"), mesh),
              "file:7: element 5 has the neighbours 6 8 4, but in the mesh 6 8 4 2 (0: none)");
    EXPECT_EQ(neighbor_refusal(replaced(good, "5\t6\t8\t4\t2", "5"), mesh),
              "file:7: element 5 has the neighbours none at all, but in the mesh 6 8 4 2 (0: none)");
}

TEST(ThesisNeighbors, EveryBrokenFileIsRefusedWithItsLine)
{
    const MeshData mesh = square_and_triangle(0);
    const std::string good = "2\nid n1 n2 n3 n4\n1 0 2 0 0\n2 0 0 1\n";
    const auto broken = [&](const std::string& from, const std::string& to) {
        return neighbor_refusal(replaced(good, from, to), mesh);
    };
    EXPECT_EQ(neighbor_refusal("\n", mesh),
              "file:2: expected the number of elements, found the end of the file");
    EXPECT_EQ(broken("2\nid", "\n3\nid"), "file:2: holds neighbours of 3 elements, but the mesh has 2");
    EXPECT_EQ(broken("2\nid", "2 4\nid"),
              "file:1: expected the end of the line after the number of elements, found '4'");
    EXPECT_EQ(broken("2 0 0 1\n", ""), "file:1: holds neighbours of 2 elements, but 1 rows follow");
    EXPECT_EQ(broken("2 0 0 1\n", "7 0 0 1\n"), "file:4: element 2 was expected, found 7");
    EXPECT_EQ(broken("2 0 0 1\n", "2 0 -1 1\n"), "file:4: expected the number of a neighbour, found '-1'");
    EXPECT_EQ(broken("1 0 2 0 0", "1 0 2 0 0 0"),
              "file:3: expected the end of the line after three or four neighbours, found '0'");
}

TEST(ThesisNeighbors, SurviveMutatedFiles)
{
    const MeshData mesh = test::quad_square(3);
    const Mesh built = build_mesh(mesh);
    const auto read = [&](const InputBytes& file) {
        check_thesis_neighbors(file, built);
        return MeshData(mesh);
    };
    test::survive_mutations(read, {neighbor_file(mesh, 0, "0"), neighbor_file(mesh, 2, "99")}, 600);
}

} // namespace

} // namespace morph
