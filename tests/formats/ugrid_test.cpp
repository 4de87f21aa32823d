#include "formats/formats.h"
#include "formats/ugrid/names.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/process.h"

#include <Eigen/Geometry>
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

// The documentation's order: counts, coordinates, corners of the triangles, of the quads, then the surface of
// each triangle and quad.
const std::string kSmall = "5 1 1 0 0 0 0\n"
                           "0 0 0\n"
                           "1 0 0\n"
                           "1 1 0\n"
                           "0 1 0\n"
                           "2 0.5 0\n"
                           "2 5 3\n"
                           "1 2 3 4\n"
                           "7\n"
                           "1\n";

MeshData small_mesh()
{
    MeshData mesh = test::square_and_triangle(0);
    std::swap(mesh.elements[0], mesh.elements[1]);
    mesh.groups = {{"7", {0}}, {"1", {1}}};
    return mesh;
}

/// What UGRID holds of the rich meshes, with a group of every second element and one of the third ones left.
std::vector<std::pair<std::string, MeshData>> held_meshes()
{
    auto meshes = test::rich_meshes();
    for (auto& [name, mesh] : meshes) {
        mesh.fields.clear();
        mesh.markers.clear();
        mesh.groups = {{"upper side #1 100%", {}}, {"12", {}}, {"no elements", {}}};
        for (Index e = 0; e < static_cast<Index>(mesh.elements.size()); ++e)
            if (e % 2 == 0 || e % 3 == 0)
                mesh.groups[e % 2 == 0 ? 0 : 1].elements.push_back(e);
    }
    return meshes;
}

const std::vector<std::string> kLayouts{".b8",  ".lb8", ".b4",  ".lb4", ".r8",
                                        ".lr8", ".r4",  ".lr4", ".b8l", ".lb8l"};

/// The small mesh in a binary layout, byte for byte.
template <class Real, class Whole>
std::string binary(bool big_endian, bool records)
{
    std::string bytes;
    const auto add = [&](auto number) {
        std::string raw(reinterpret_cast<const char*>(&number), sizeof number);
        bytes += big_endian ? std::string(raw.rbegin(), raw.rend()) : raw;
    };
    const auto length = [&](std::size_t size) {
        if (records)
            add(static_cast<std::int32_t>(size));
    };
    length(7 * sizeof(Whole));
    for (const int count : {5, 1, 1, 0, 0, 0, 0})
        add(static_cast<Whole>(count));
    length(7 * sizeof(Whole));
    length(15 * sizeof(Real) + 9 * sizeof(Whole));
    for (const double x : {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 0.0, 2.0, 0.5, 0.0})
        add(static_cast<Real>(x));
    for (const int number : {2, 5, 3, 1, 2, 3, 4, 7, 1})
        add(static_cast<Whole>(number));
    length(15 * sizeof(Real) + 9 * sizeof(Whole));
    return bytes;
}

std::vector<std::string> small_mesh_in_every_layout()
{
    return {binary<double, std::int32_t>(true, false), binary<double, std::int32_t>(false, false),
            binary<float, std::int32_t>(true, false),  binary<float, std::int32_t>(false, false),
            binary<double, std::int32_t>(true, true),  binary<double, std::int32_t>(false, true),
            binary<float, std::int32_t>(true, true),   binary<float, std::int32_t>(false, true),
            binary<double, std::int64_t>(true, false), binary<double, std::int64_t>(false, false)};
}

TEST(Ugrid, WritesTextAsItsDocumentationHasIt)
{
    EXPECT_EQ(written(small_mesh(), "ugrid", {.binary = false}), kSmall);
}

TEST(Ugrid, ReadsTextAsItsDocumentationHasIt)
{
    EXPECT_EQ(difference(read_bytes(kSmall, "ugrid"), small_mesh()), "");
}

TEST(Ugrid, WritesAndReadsTheLayoutThatTheNameSays)
{
    const std::vector<std::string> expected = small_mesh_in_every_layout();
    const test::TemporaryFolder folder;
    for (std::size_t i = 0; i < kLayouts.size(); ++i) {
        const std::string path = folder.file("wing.v2" + kLayouts[i] + ".ugrid");
        EXPECT_THAT(write_mesh_data(small_mesh(), path, "", {.binary = false}), IsEmpty());
        EXPECT_EQ(test::read_text(path), expected[i]) << path;
        ReadNotes notes;
        EXPECT_EQ(difference(read_mesh_data(path, "", {}, &notes), small_mesh()), "") << path;
        EXPECT_EQ(notes.version, "binary (" + kLayouts[i].substr(1) + ")");
    }
}

TEST(Ugrid, FindsTheLayoutOfABinaryFileWithoutOneInItsName)
{
    for (const std::string& bytes : small_mesh_in_every_layout())
        EXPECT_EQ(difference(read_bytes(bytes, "ugrid"), small_mesh()), "");
}

TEST(Ugrid, WritesTextUnderThePlainName)
{
    const test::TemporaryFolder folder;
    write_mesh_data(small_mesh(), folder.file("a.ugrid"), "", {.binary = true});
    EXPECT_EQ(test::read_text(folder.file("a.ugrid")), kSmall);
}

TEST(Ugrid, KeepsFacesAndGroupsOfRichMeshesBitForBit)
{
    const test::TemporaryFolder folder;
    for (const auto& [name, mesh] : held_meshes())
        for (const std::string layout : {"", ".b8", ".lr8"}) {
            const std::string path = folder.file(name + layout + ".ugrid");
            EXPECT_THAT(write_mesh_data(mesh, path), IsEmpty()) << name;
            EXPECT_EQ(difference(read_mesh_data(path), mesh), "") << path;
        }
}

TEST(Ugrid, NamesItsSurfacesInTheFileThatFun3dReads)
{
    const test::TemporaryFolder folder;
    MeshData mesh = test::square_and_triangle(0);
    mesh.groups = {{"upper wing", {0}}, {"3", {1}}};
    mesh.sections = {{"ugrid", "the boundary conditions of 1 group(s)", "4000 upper%20wing\n"}};
    write_mesh_data(mesh, folder.file("a.lb8.ugrid"));
    EXPECT_THAT(folder.names(), ElementsAre("a.lb8.ugrid", "a.mapbc"));
    EXPECT_EQ(test::read_text(folder.file("a.mapbc")), "2\n1 4000 upper%20wing\n3 0 3\n# order 1q1t\n");
    const MeshData again = read_mesh_data(folder.file("a.lb8.ugrid"));
    write_mesh_data(again, folder.file("b.ugrid"));
    EXPECT_EQ(test::read_text(folder.file("b.mapbc")), test::read_text(folder.file("a.mapbc")));
    EXPECT_EQ(again.sections.at(0).what, "the boundary conditions of 1 group(s)");
}

TEST(Ugrid, ReadsOddButLegalNames)
{
    const std::vector<std::string> odd{"2\n7 4000 tip\n1 5000 plate\n",
                                       "2\r\n7\t4000 \ttip \r\n1\t5000\tplate\r\n",
                                       "  2   boundaries\n\n 7  4000 tip viscous wall\n\n1 5000 plate",
                                       "# by hand\n2\n7 -1 tip # a comment\n1 0 plate\ntrailing lines\n"};
    for (const std::string& text : odd) {
        const UgridNames names = read_ugrid_names("file", text);
        ASSERT_EQ(names.groups.size(), 2U) << text;
        EXPECT_EQ(names.groups[0].first, 7);
        EXPECT_EQ(names.groups[0].name, "tip");
        EXPECT_EQ(names.groups[1].name, "plate");
    }
    EXPECT_EQ(read_ugrid_names("file", "1\n7 4000\n").groups.at(0).name, "7");
}

TEST(Ugrid, ReadsOddButLegalFiles)
{
    const std::vector<std::string> odd{
        "5 1 1 0 0 0 0 0 0 0 1 0 0 1 1 0 0 1 0 2 0.5 0 2 5 3 1 2 3 4 7 1",
        "\r\n5 1 1 0 0 0 0\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n2 0.5 0\r\n2 5 3\r\n1 2 3 4\r\n7\r\n1\r\n",
        "5\n1\n1\n0\n0\n0\n0\n\t0.D0 0.0E+00 0 1.0d+0 +0 0 1 1 0 0 1 0 20.D-1 .5 0\n\n 2 5 3 1\n2 3 4 7 1\n",
        kSmall + "0 0 and what a volume grid generator adds\n",
        "   " + kSmall + "\n\n",
    };
    for (const std::string& text : odd)
        EXPECT_EQ(difference(read_bytes(text, "ugrid"), small_mesh()), "") << text;
}

TEST(Ugrid, GivesFacesOfSurface0NoGroup)
{
    const MeshData mesh = read_bytes(replaced(kSmall, "\n7\n", "\n0\n"), "ugrid");
    ASSERT_EQ(mesh.groups.size(), 1U);
    EXPECT_EQ(mesh.groups[0].elements, std::vector<Index>{1});
}

TEST(Ugrid, TakesTheBoundaryOfAVolumeAndSaysSo)
{
    // A cube with a pyramid on its top: the quadrilateral of a pyramid is 1 4 5 2 there, its apex 3.
    const std::string text = "9 1 1 0 1 0 1\n0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 0.5 0.5 2\n"
                             "5 6 9\n1 4 3 2\n4\n6\n"
                             "5 8 9 6 7\n1 2 3 4 5 6 7 8\n";
    ReadNotes notes;
    const Format& ugrid = find_format("", "ugrid");
    const MeshData mesh = ugrid.read({"file", text, {}, &notes});
    EXPECT_EQ(mesh.elements.size(), 9U);
    EXPECT_EQ(mesh.points.rows(), 9);
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "4");
    EXPECT_EQ(mesh.groups[0].elements.size(), 1U);
    EXPECT_THAT(notes.warnings,
                ElementsAre("file: 2 volume cell(s) were left out; the mesh is their boundary"));
    ReadNotes asked;
    EXPECT_EQ(difference(ugrid.read({"file", text, {true, ""}, &asked}), mesh), "");
    EXPECT_THAT(asked.warnings, IsEmpty());
    double volume = 0; // by the divergence theorem: 1 and a third
    for (const Element& element : mesh.elements)
        for (std::size_t k = 2; k < static_cast<std::size_t>(corner_count(element)); ++k) {
            const Eigen::Vector3d a = mesh.points.row(element[0]);
            const Eigen::Vector3d b = mesh.points.row(element.at(k - 1));
            const Eigen::Vector3d c = mesh.points.row(element.at(k));
            volume += a.dot(b.cross(c)) / 6;
        }
    EXPECT_NEAR(volume, 4.0 / 3, 1e-14); // a dozen roundings of numbers of size 1
}

TEST(Ugrid, SaysWhatItCannotHold)
{
    const test::TemporaryFolder folder;
    MeshData mesh = small_mesh();
    mesh.groups = {{"a", {0, 1}}, {"b", {1}}, {"", {}}};
    mesh.markers = {{"edge", {{0, 1}}}};
    EXPECT_THAT(
        write_mesh_data(mesh, folder.file("a.ugrid")),
        ElementsAre(HasSubstr("ugrid cannot hold 1 marker(s) edge"),
                    HasSubstr("ugrid cannot hold 1 element(s) of group 'b', which are in another group too"),
                    HasSubstr("ugrid cannot hold a group without a name")));
}

TEST(Ugrid, SaysWhatIsWrongAndWhere)
{
    const auto changed = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kSmall, from, to), "ugrid");
    };
    EXPECT_EQ(refusal("", "ugrid"), "file:1: expected the number of vertices, found the end of the file");
    EXPECT_EQ(changed("1 1 0 0", "-1 1 0 0"),
              "file:1: the number of type triangle is -1, expected 0 to 2^31 - 1");
    EXPECT_EQ(changed("5 1 1 0", "5 1 1.5 0"),
              "file:1: expected the number of type quadrilateral, found '1.5'");
    EXPECT_EQ(changed("5 1 1 0", "5 1 99 0"),
              "file:1: the counts need 514 numbers behind them, but the file ends before");
    EXPECT_EQ(changed("1 1 0\n", "1 x 0\n"), "file:4: expected a coordinate of vertex 3, found 'x'");
    EXPECT_EQ(changed("2 5 3", "2 6 3"), "file:7: triangle 1 names vertex 6, expected 1 to 5");
    EXPECT_EQ(changed("1 2 3 4", "0 2 3 4"), "file:8: quadrilateral 1 names vertex 0, expected 1 to 5");
    EXPECT_EQ(changed("1 2 3 4", "1 2 3"), "file:9: quadrilateral 1 names vertex 7, expected 1 to 5");
    EXPECT_EQ(changed("\n7\n1\n", "\n7\n"),
              "file:10: expected the surface of quadrilateral 1, found the end of the file");
    EXPECT_EQ(changed("1 2 3 4", "1 2 3.5 4"), "file:8: expected a vertex of quadrilateral 1, found '3.5'");
    EXPECT_EQ(
        refusal(binary<double, std::int32_t>(false, false) + "x", "ugrid"),
        "file: is neither text nor as long as its counts say in any binary layout; name the layout, as in "
        "x.b8.ugrid or x.lb8.ugrid");
}

TEST(Ugrid, SaysWhatIsWrongInABinaryFileAndWhere)
{
    const auto refused = [](const std::string& name, std::string bytes, std::size_t at,
                            const std::string& change) {
        try {
            find_format("", "ugrid").read({name, bytes.replace(at, change.size(), change)});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const std::string plain = binary<double, std::int32_t>(false, false);
    const std::string records = binary<double, std::int32_t>(true, true);
    EXPECT_EQ(refused("x.lb8.ugrid", plain, 148, "\x09"),
              "x.lb8.ugrid: byte 148: triangle 1 names vertex 9, expected 1 to 5");
    EXPECT_EQ(refused("x.lb8.ugrid", plain, 34, "\xF0\x7F"),
              "x.lb8.ugrid: byte 28: a coordinate of vertex 1 is not finite");
    EXPECT_EQ(refused("x.lb8.ugrid", plain.substr(0, 100), 0, ""),
              "x.lb8.ugrid: byte 0: the counts need 24 numbers behind them, but the file ends before");
    EXPECT_EQ(refused("x.lb8.ugrid", plain.substr(0, 10), 0, ""),
              "x.lb8.ugrid: byte 8: expected the number of type quadrilateral, found the end of the file");
    EXPECT_EQ(refused("x.r8.ugrid", plain, 0, ""),
              "x.r8.ugrid: byte 0: a record has 83886080 bytes, expected 28");
    EXPECT_EQ(refused("x.r8.ugrid", records, 36, "\xFF"),
              "x.r8.ugrid: byte 36: a record in several parts is not supported; write the file as .b8.ugrid");
}

TEST(Ugrid, SaysWhatIsWrongInTheFileOfNames)
{
    const auto refused = [](const std::string& text) {
        try {
            read_ugrid_names("file", text);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(refused(""), "file:1: expected the number of surfaces, found the end of the file");
    EXPECT_EQ(refused("2\n1 4000 a\n"),
              "file:3: expected the number of surface 2, found the end of the file");
    EXPECT_EQ(refused("1\n3 wall a\n"), "file:2: expected the boundary condition of surface 3, found 'wall'");
}

TEST(Ugrid, SurvivesDamagedFiles)
{
    std::vector<std::string> seeds = small_mesh_in_every_layout();
    seeds.push_back(kSmall);
    seeds.emplace_back("5 1 0 1 1 0 0\n0 0 0 1 0 0 1 1 0 0 1 0 0 0 1\n1 2 3\n4\n1 2 3 5\n1 2 3 4 5\n");
    for (const auto& [name, mesh] : held_meshes())
        seeds.push_back(written(mesh, "ugrid", {.binary = name != "hybrid"}));
    test::survive_mutations("ugrid", seeds, 2000);
    const auto names = [](const InputBytes& file) {
        read_ugrid_names(file.path, file.bytes);
        return MeshData{};
    };
    test::survive_mutations(names, {"2\n1 4000 upper%20wing\n3 0 3\n# order 1q1t\n"}, 2000);
}

} // namespace

} // namespace morph
