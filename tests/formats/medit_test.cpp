#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using test::written;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// libMeshb's documentation: keywords in any order, a count, a line for each with its reference behind.
const std::string kSmall = "MeshVersionFormatted 2\n"
                           "\n"
                           "Dimension 2\n"
                           "\n"
                           "Vertices\n"
                           "5\n"
                           "0 0 0\n"
                           "1 0 0\n"
                           "1 1 0\n"
                           "0 1 0\n"
                           "2 0.5 0\n"
                           "\n"
                           "Edges\n"
                           "3\n"
                           "1 2 1\n"
                           "2 5 1\n"
                           "4 1 7\n"
                           "\n"
                           "Triangles\n"
                           "1\n"
                           "2 5 3 2\n"
                           "\n"
                           "Quadrilaterals\n"
                           "1\n"
                           "1 2 3 4 1\n"
                           "\n"
                           "End\n"
                           "\n"
                           "# marker 1 = lower side\n"
                           "# marker 7 = 7\n"
                           "# group 1 = plate\n"
                           "# group 2 = tip\n"
                           "# order 1q1t\n";

MeshData small_mesh()
{
    MeshData mesh = test::square_and_triangle(0);
    mesh.markers = {{"lower side", {{0, 1}, {1, 4}}}, {"7", {{3, 0}}}};
    mesh.groups = {{"plate", {0}}, {"tip", {1}}};
    return mesh;
}

/// The rich meshes with groups of elements: every second, every third of the others, and none.
std::vector<std::pair<std::string, MeshData>> grouped_meshes()
{
    auto meshes = test::rich_meshes();
    for (auto& [name, mesh] : meshes) {
        mesh.groups = {{"second %41", {}}, {"", {}}, {" no elements ", {}}};
        for (Index e = 0; e < static_cast<Index>(mesh.elements.size()); ++e)
            if (e % 2 == 0 || e % 3 == 0)
                mesh.groups[e % 2 == 0 ? 0 : 1].elements.push_back(e);
    }
    return meshes;
}

/// Bytes of numbers in this machine's order, or in the other one.
class Bytes {
public:
    explicit Bytes(bool swapped = false) : swapped_(swapped) {}
    Bytes& add(auto number)
    {
        std::string raw(reinterpret_cast<const char*>(&number), sizeof number);
        text += swapped_ ? std::string(raw.rbegin(), raw.rend()) : raw;
        return *this;
    }
    Bytes& words(std::initializer_list<std::int32_t> numbers)
    {
        for (const std::int32_t number : numbers)
            add(number);
        return *this;
    }
    std::string text;

private:
    bool swapped_;
};

/// A triangle with one edge in each of the four versions of binary files.
template <class Real, class Place, class Whole>
std::string binary_triangle(std::int32_t version, bool swapped)
{
    Bytes b(swapped);
    std::size_t next = 12 + sizeof(Place) + 4;
    const auto section = [&](std::int32_t code, std::size_t lines, std::size_t line) {
        next += 4 + sizeof(Place) + sizeof(Whole) + lines * line;
        b.add(code).add(static_cast<Place>(next)).add(static_cast<Whole>(lines));
    };
    b.words({1, version, 3}).add(static_cast<Place>(next)).add(2);
    section(4, 3, 2 * sizeof(Real) + sizeof(Whole));
    for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.25), std::pair(0.5, 2.0)})
        b.add(static_cast<Real>(x)).add(static_cast<Real>(y)).add(Whole{0});
    section(5, 1, 3 * sizeof(Whole));
    for (const int number : {3, 1, 4})
        b.add(static_cast<Whole>(number));
    section(6, 1, 4 * sizeof(Whole));
    for (const int number : {1, 2, 3, 6})
        b.add(static_cast<Whole>(number));
    b.words({54}).add(Place{0});
    return b.text;
}

MeshData triangle()
{
    MeshData mesh;
    mesh.points.resize(3, 3);
    mesh.points << 0, 0, 0, 1, 0.25, 0, 0.5, 2, 0;
    mesh.elements = {{0, 1, 2, -1}};
    mesh.markers = {{"4", {{2, 0}}}};
    mesh.groups = {{"6", {0}}};
    return mesh;
}

/// The warnings with which bytes are read.
std::vector<std::string> warnings(const std::string& bytes)
{
    ReadNotes notes;
    find_format("", "medit").read({"file", bytes, {}, &notes});
    return notes.warnings;
}

TEST(Medit, WritesTextAsItsDocumentationHasIt)
{
    EXPECT_EQ(written(small_mesh(), "medit", {.binary = false}), kSmall);
}

TEST(Medit, ReadsWhatItWrites)
{
    EXPECT_EQ(difference(read_bytes(kSmall, "medit"), small_mesh()), "");
}

TEST(Medit, WritesBinaryOfVersion2WithTheNamesBehindTheEnd)
{
    MeshData mesh = triangle();
    std::string bytes = binary_triangle<double, std::int32_t, std::int32_t>(2, false);
    EXPECT_EQ(written(mesh, "medit"), bytes + "\n# marker 4 = 4\n# group 6 = 6\n");
}

TEST(Medit, ReadsEveryVersionOfBinaryFilesInEitherByteOrder)
{
    for (const bool swapped : {false, true})
        for (const std::string& bytes : {binary_triangle<float, std::int32_t, std::int32_t>(1, swapped),
                                         binary_triangle<double, std::int32_t, std::int32_t>(2, swapped),
                                         binary_triangle<double, std::int64_t, std::int32_t>(3, swapped),
                                         binary_triangle<double, std::int64_t, std::int64_t>(4, swapped)})
            EXPECT_EQ(difference(read_bytes(bytes, "medit"), triangle()), "");
}

TEST(Medit, KeepsRichMeshesWithTheirFieldsBitForBit)
{
    const test::TemporaryFolder folder;
    for (const auto& [name, mesh] : grouped_meshes())
        for (const std::string extension : {".mesh", ".meshb"}) {
            const std::string path = folder.file(name + extension);
            EXPECT_THAT(write_mesh_data(mesh, path), IsEmpty()) << name;
            EXPECT_EQ(difference(read_mesh_data(path), mesh), "") << path;
        }
}

TEST(Medit, TakesTextOrBinaryFromTheExtensionWhateverIsWanted)
{
    const test::TemporaryFolder folder;
    write_mesh_data(triangle(), folder.file("a.mesh"), "", {.binary = true});
    write_mesh_data(triangle(), folder.file("a.meshb"), "", {.binary = false});
    EXPECT_EQ(test::read_text(folder.file("a.mesh")).substr(0, 20), "MeshVersionFormatted");
    EXPECT_EQ(test::read_text(folder.file("a.meshb")).substr(0, 4), std::string("\1\0\0\0", 4));
}

TEST(Medit, KeepsTheNumbersOfAFileThatHasNoNames)
{
    const std::string foreign = "MeshVersionFormatted 1\nDimension 2\nVertices 3 0 0 0 1 0 0 0 1 0\n"
                                "Edges 3 1 2 12 2 3 -5 3 1 0\nTriangles 1 1 2 3 40\nEnd\n";
    const MeshData mesh = read_bytes(foreign, "medit");
    ASSERT_EQ(mesh.markers.size(), 3U);
    EXPECT_EQ(mesh.markers[0].name, "12");
    EXPECT_EQ(mesh.markers[1].name, "-5");
    EXPECT_EQ(mesh.markers[2].name, "0");
    EXPECT_EQ(mesh.groups.at(0).name, "40");
    const std::string again = written(mesh, "medit", {.binary = false});
    EXPECT_THAT(again, HasSubstr("Edges\n3\n1 2 12\n2 3 -5\n3 1 0\n"));
    EXPECT_THAT(again, HasSubstr("Triangles\n1\n1 2 3 40\n"));
}

TEST(Medit, LeavesNumbersThatAreNamesToTheirOwners)
{
    MeshData mesh = triangle();
    mesh.markers = {{"body", {{0, 1}}}, {"1", {{1, 2}}}, {"01", {{2, 0}}}, {"1", {{0, 1}}}};
    EXPECT_THAT(written(mesh, "medit", {.binary = false}),
                HasSubstr("Edges\n4\n1 2 2\n2 3 1\n3 1 3\n1 2 4\n"));
    EXPECT_EQ(difference(read_bytes(written(mesh, "medit"), "medit"), mesh), "");
}

TEST(Medit, SaysWhichElementsAreInSeveralGroups)
{
    MeshData mesh = small_mesh();
    mesh.groups.push_back({"both", {0, 1}});
    const test::TemporaryFolder folder;
    EXPECT_THAT(
        write_mesh_data(mesh, folder.file("a.mesh")),
        ElementsAre(HasSubstr(
            "a.mesh: medit cannot hold 2 element(s) of group 'both', which are in another group too")));
    mesh.groups[2].elements.clear();
    EXPECT_EQ(difference(read_mesh_data(folder.file("a.mesh")), mesh), "");
}

TEST(Medit, CarriesCornersRidgesAndWhatIsRequired)
{
    const std::string lists = "\nCorners\n2\n1\n5\n\nRidges\n1\n3\n\nRequiredVertices\n1\n2\n"
                              "\nRequiredEdges\n2\n1\n2\n\nRequiredTriangles\n1\n1\n"
                              "\nRequiredQuadrilaterals\n1\n1\n";
    const std::string text = replaced(kSmall, "\nEnd\n", lists + "\nEnd\n");
    const MeshData mesh = read_bytes(text, "medit");
    EXPECT_EQ(mesh.sections.size(), 6U);
    EXPECT_EQ(mesh.sections.at(1).what, "1 Ridges");
    EXPECT_EQ(written(mesh, "medit", {.binary = false}), text);
}

TEST(Medit, FindsCarriedEdgesAndFacesAgainInAnotherOrder)
{
    const std::string text =
        replaced(kSmall, "\nEnd\n", "\nRidges\n1\n3\n\nRequiredTriangles\n1\n1\n\nEnd\n");
    MeshData mesh = read_bytes(text, "medit");
    std::swap(mesh.markers[0], mesh.markers[1]);
    EXPECT_THAT(written(mesh, "medit", {.binary = false}), HasSubstr("\nRidges\n1\n1\n"));
    mesh.markers.clear();
    mesh.elements[1] = {1, 4, 2, 3};
    const test::TemporaryFolder folder;
    EXPECT_THAT(write_mesh_data(mesh, folder.file("a.mesh")),
                ElementsAre(HasSubstr("1 of the 1 Ridges, which are in the mesh no more"),
                            HasSubstr("1 of the 1 RequiredTriangles, which are in the mesh no more")));
}

TEST(Medit, CarriesTheReferencesOfVertices)
{
    const std::string text = replaced(kSmall, "2 0.5 0\n", "2 0.5 13\n");
    const MeshData mesh = read_bytes(text, "medit");
    EXPECT_EQ(mesh.sections.at(0).what, "the references of 5 vertices");
    EXPECT_EQ(written(mesh, "medit", {.binary = false}), text);
    EXPECT_EQ(difference(read_bytes(written(mesh, "medit"), "medit"), mesh), "");
}

TEST(Medit, ReadsOddButLegalFiles)
{
    const MeshData plain = read_bytes("MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0.25 0\n"
                                      "0.5 2 0\nEdges\n1\n3 1 4\nTriangles\n1\n1 2 3 6\nEnd\n",
                                      "medit");
    ASSERT_EQ(difference(plain, triangle()), "");
    const std::vector<std::string> odd{
        "# made by hand\n\nMeshVersionFormatted 1 # single\n\nDimension\n2\n\nEdges\n1\n3 1 4\n"
        "Triangles\n1\n1 2 3 6\nVertices\n3\n0 0 0\n1 0.25 0\n0.5 2 0\n",
        "MeshVersionFormatted 2\r\nDimension 2\r\nVertices\r\n3\r\n0 0 0\r\n1 0.25 0\r\n0.5 2 0\r\n"
        "Edges\r\n1\r\n3 1 4\r\nTriangles\r\n1\r\n1 2 3 6\r\nEnd\r\n",
        "\tMeshVersionFormatted\t2 Dimension 2 Vertices 3 0.0D+00 0. 0 1.D0 2.5d-1 0 +.5E0 2 0 Edges 1 3 1 4 "
        "Triangles 1 1 2 3 6 End",
        "MeshVersionFormatted 0\nDimension 3\nVertices\n3\n0 0 0 0\n1 0.25 0 0\n0.5 2 -0. 0\n\n\n"
        "Edges\n\n1\n\n3 1\n4\nTriangles\n1\n1 2 3 6\n\nEnd\n",
        "MeshVersionFormatted 4\nDimension 2\nVertices 3\n0 0 0 # origin\n1 0.25 0\n0.5 2 0\n"
        "Edges 1\n3 1 4\nTriangles 1\n1 2 3 6\nEnd\nafter the end nobody reads\n",
        "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0 0 0\n1 0.25 0\n0.5 2 0\nTriangles 0\nCorners 0\n"
        "Edges 1\n3 1 4\nTriangles 1\n1 2 3 6\nQuadrilaterals 0\nTetrahedra 0\n# End\n",
    };
    for (const std::string& text : odd) {
        MeshData mesh = read_bytes(text, "medit");
        mesh.points.array() += 0.0; // -0 + 0 is 0
        EXPECT_EQ(difference(mesh, triangle()), "") << text;
    }
}

TEST(Medit, NamesTheSectionsThatItLeavesOut)
{
    const std::string extra = "Geometry\n\"wing of 7.geo\"\nNormals 1\n0 1\nNormalAtVertices\n1\n1 1\n"
                              "SubDomainFromMesh 1 3 1 1 0\n";
    EXPECT_THAT(warnings(replaced(kSmall, "Edges", extra + "\nEdges")),
                ElementsAre("file: the section 'Geometry' was left out",
                            "file: the section 'Normals' was left out",
                            "file: the section 'NormalAtVertices' was left out",
                            "file: the section 'SubDomainFromMesh' was left out"));
    EXPECT_EQ(difference(read_bytes(replaced(kSmall, "Edges", extra + "\nEdges"), "medit"), small_mesh()),
              "");
    const std::string bytes = binary_triangle<double, std::int32_t, std::int32_t>(2, false);
    Bytes section;
    section.words({60, static_cast<std::int32_t>(bytes.size()) - 8 + 28, 1}).add(0.0).add(1.0);
    Bytes unknown;
    unknown.words({94, static_cast<std::int32_t>(bytes.size()) - 8 + 28 + 11}).text += "abc";
    EXPECT_THAT(warnings(bytes.substr(0, bytes.size() - 8) + section.text + unknown.text +
                         bytes.substr(bytes.size() - 8)),
                ElementsAre("file: the section 'Normals' was left out",
                            "file: the section 'number 94' was left out"));
}

TEST(Medit, IgnoresAnOrderThatIsNotOfThisMesh)
{
    MeshData triangles_first = small_mesh();
    std::swap(triangles_first.elements[0], triangles_first.elements[1]);
    triangles_first.groups = {{"plate", {1}}, {"tip", {0}}};
    for (const std::string order : {"1q", "1q2t", "1q1t1q", "1x1t", "1q1", "99999999999999999999q1t", ""})
        EXPECT_EQ(difference(read_bytes(replaced(kSmall, "1q1t", order), "medit"), triangles_first), "")
            << order;
}

TEST(Medit, TakesTheSurfaceOfAVolume)
{
    const std::string text = "MeshVersionFormatted 2\nDimension 3\nVertices 7\n0 0 0 1\n1 0 0 1\n0 1 0 1\n"
                             "0 0 1 1\n1 0 1 1\n0 1 1 1\n0.3 0.3 2 1\nPrisms 1\n1 2 3 4 5 6 1\n"
                             "Tetrahedra 1\n4 5 6 7 2\nTriangles 2\n1 3 2 9\n4 5 6 8\nCorners 1\n1\nEnd\n";
    EXPECT_EQ(refusal(text, "medit"), "file: holds a volume mesh of 2 cells; --surface takes its boundary");
    ReadNotes notes;
    const MeshData mesh = find_format("", "medit").read({"file", text, {true, ""}, &notes});
    EXPECT_EQ(mesh.elements.size(), 7U); // 5 faces and 4, less the two that meet
    EXPECT_EQ(mesh.points.rows(), 7);
    ASSERT_EQ(mesh.groups.size(), 1U);
    EXPECT_EQ(mesh.groups[0].name, "9");
    EXPECT_THAT(notes.warnings,
                ElementsAre("file: the references of 7 vertices of the volume mesh were left out",
                            "file: 1 Corners of the volume mesh were left out",
                            "file: 1 listed face(s) inside the volume were left out"));
}

TEST(Medit, SaysItsVersion)
{
    ReadNotes notes;
    const Format& medit = find_format("", "medit");
    medit.read({"file", kSmall, {}, &notes});
    EXPECT_EQ(notes.version, "2, text");
    medit.read({"file", binary_triangle<double, std::int64_t, std::int64_t>(4, true), {}, &notes});
    EXPECT_EQ(notes.version, "4, binary");
}

TEST(Medit, SaysWhatIsWrongInTextAndWhere)
{
    const auto changed = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kSmall, from, to), "medit");
    };
    EXPECT_EQ(refusal("", "medit"),
              "file:1: expected the keyword MeshVersionFormatted, found the end of the file");
    EXPECT_EQ(changed("Formatted 2", "Formatted 5"), "file:1: version 5, expected 0 to 4");
    EXPECT_EQ(changed("Dimension 2", "Dimension 4"), "file:3: Dimension 4, expected 2 or 3");
    EXPECT_EQ(changed("Dimension 2", ""), "file:5: expected the keyword Dimension, found 'Vertices'");
    EXPECT_EQ(refusal("MeshVersionFormatted 2 Dimension 2 End", "medit"), "file: has no section Vertices");
    EXPECT_EQ(changed("Edges", "Vertices 0\nEdges"), "file:13: Vertices are given again");
    EXPECT_EQ(changed("Vertices\n5", "Vertices\nfive"),
              "file:6: expected the number of lines of Vertices, found 'five'");
    EXPECT_EQ(changed("Vertices\n5", "Vertices\n99999"),
              "file:5: Vertices has 99999 lines by its count, but the file ends before");
    EXPECT_EQ(changed("Vertices\n5", "Vertices\n6"),
              "file:13: expected a coordinate of vertex 6, found 'Edges'");
    EXPECT_EQ(changed("Vertices\n5", "Vertices\n4"),
              "file:11: expected a keyword after the lines of Vertices, found '2'");
    EXPECT_EQ(changed("1 1 0", "1 nan 0"), "file:9: a coordinate of vertex 3 is not finite");
    EXPECT_EQ(changed("1 1 0", "1 1 x"), "file:9: expected the reference of vertex 3, found 'x'");
    EXPECT_EQ(changed("2 5 1", "2 5.5 1"), "file:16: expected a vertex of edge 2, found '5.5'");
    EXPECT_EQ(changed("2 5 3 2", "2 5 3"),
              "file:23: expected the reference of triangle 1, found 'Quadrilaterals'");
    EXPECT_EQ(changed("2 5 3 2", "0 5 3 2"),
              "file:21: triangle 1 names vertex 0, but vertices are numbered from 1");
    EXPECT_EQ(changed("2 5 3 2", "2 6 3 2"), "file:21: triangle 1 names vertex 6, but the mesh has 5");
    EXPECT_EQ(changed("\nEnd", "\nRidges 1 4\nEnd"),
              "file:27: Ridges lists number 4, but the mesh has 3 of these");
    EXPECT_EQ(changed("\nEnd", "\nCorners 1 x\nEnd"), "file:27: expected a number of Corners, found 'x'");
    EXPECT_EQ(changed("Edges\n", "TrianglesP2\n"),
              "file:13: TrianglesP2 are not supported; supported are straight triangles, quadrilaterals, "
              "tetrahedra, pyramids, prisms and hexahedra");
}

TEST(Medit, SaysWhatIsWrongInBinaryAndWhere)
{
    const std::string good = binary_triangle<double, std::int32_t, std::int32_t>(2, false);
    const auto with_word = [&](std::size_t at, std::int32_t word) {
        return refusal(std::string(good).replace(at, 4, reinterpret_cast<const char*>(&word), 4), "medit");
    };
    EXPECT_EQ(with_word(4, 5), "file: byte 4: version 5, expected 1 to 4");
    EXPECT_EQ(with_word(8, 4), "file: byte 8: expected the keyword Dimension (3)");
    EXPECT_EQ(with_word(16, 1), "file: byte 16: dimension 1, expected 2 or 3");
    EXPECT_EQ(with_word(24, 90),
              "file: byte 20: Vertices should end at byte 90, but its lines go on to byte 92");
    EXPECT_EQ(with_word(24, 9999),
              "file: byte 20: Vertices should end at byte 9999, but begins here and the file has 152 bytes");
    EXPECT_EQ(with_word(28, 1000),
              "file: byte 20: Vertices has 1000 lines by its count, but the file ends before");
    EXPECT_EQ(with_word(28, -1), "file: byte 28: Vertices has an impossible number of lines");
    EXPECT_EQ(with_word(36, 0x7FF00000), "file: byte 32: a coordinate of vertex 1 is not finite");
    EXPECT_EQ(with_word(104, 9), "file: byte 104: edge 1 names vertex 9, but the mesh has 3");
    EXPECT_EQ(with_word(92, 93),
              "file: byte 92: EdgesP4 are not supported; supported are straight triangles, "
              "quadrilaterals, tetrahedra, pyramids, prisms and hexahedra");
    EXPECT_EQ(refusal(good.substr(0, good.size() - 3), "medit"),
              "file: byte 148: expected a place, found the end of the file");
}

TEST(Medit, ReadsWhatGmshWrote) // tests/data/medit/README.md
{
    const MeshData mesh = read_mesh_data(test::data_path("medit/gmsh.mesh"));
    EXPECT_EQ(mesh.dimension, 2);
    EXPECT_EQ(mesh.points.rows(), 20);
    EXPECT_EQ(mesh.elements.size(), 26U);
    ASSERT_EQ(mesh.markers.size(), 4U);
    EXPECT_EQ(mesh.markers[3].name, "4");
    EXPECT_EQ(mesh.markers[3].edges.size(), 3U);
    EXPECT_EQ(mesh.groups.at(0).elements.size(), 26U);
}

TEST(Medit, SurvivesDamagedFiles)
{
    std::vector<std::string> seeds{kSmall,
                                   replaced(kSmall, "\nEnd\n", "\nRidges\n1\n3\n\nCorners\n1\n1\nEnd\n"),
                                   binary_triangle<double, std::int64_t, std::int64_t>(4, true),
                                   binary_triangle<float, std::int32_t, std::int32_t>(1, false)};
    for (const auto& [name, mesh] : test::planar_meshes()) {
        seeds.push_back(written(mesh, "medit"));
        seeds.push_back(written(mesh, "medit", {.binary = false}));
    }
    test::survive_mutations("medit", seeds, 2000);
}

} // namespace

} // namespace morph
