// SU2 files of several zones, of volumes, and groups in comments.
#include "formats/formats.h"
#include "libmorph/core/error.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"
#include "tests/support/surface_cases.h"

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

using Edge = std::array<Index, 2>;

const ReadOptions kSurface{true, ""};

ReadOptions zone(const std::string& name)
{
    return {false, name};
}

MeshData read_with(const std::string& bytes, const ReadOptions& options, ReadNotes* notes = nullptr)
{
    return find_format("", "su2").read({"file", bytes, options, notes});
}

std::string refusal_with(const std::string& bytes, const ReadOptions& options)
{
    try {
        read_with(bytes, options);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

/// A triangle and a quad, each a zone with a marker "wall" and one of its own.
const std::string kZones = "% two zones\nNZONE= 2\n\nIZONE= 1\n"                              // 1-4
                           "NDIME= 2\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0\n1 0\n0 1\nNMARK= 2\n" // 5-12
                           "MARKER_TAG= wall\nMARKER_ELEMS= 1\n3 0 1\n"                       // 13-15
                           "MARKER_TAG= inlet\nMARKER_ELEMS= 1\n3 2 0\n"                      // 16-18
                           "IZONE= 2 % rotor\n"                                               // 19
                           "NDIME= 2\nNELEM= 1\n9 0 1 2 3\nNPOIN= 4\n5 0\n6 0\n6 1\n5 1\nNMARK= 2\n"
                           "MARKER_TAG= wall\nMARKER_ELEMS= 1\n3 0 1\n"
                           "MARKER_TAG= outlet\nMARKER_ELEMS= 1\n3 1 2\nNPERIODIC= 1\n";

TEST(Su2Zones, AreJoinedAsGroupsWithDistinctMarkers)
{
    ReadNotes notes;
    const MeshData mesh = read_with(kZones, {}, &notes);
    EXPECT_EQ(mesh.points.rows(), 7);
    EXPECT_EQ(mesh.points.row(3), Eigen::RowVector3d(5, 0, 0));
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, -1}, Element{3, 4, 5, 6}));
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "zone_1");
    EXPECT_EQ(mesh.groups[1].name, "zone_2");
    EXPECT_THAT(mesh.groups[1].elements, ElementsAre(1));
    ASSERT_EQ(mesh.markers.size(), 4U);
    EXPECT_EQ(mesh.markers[0].name, "wall_zone_1");
    EXPECT_EQ(mesh.markers[1].name, "inlet");
    EXPECT_EQ(mesh.markers[2].name, "wall_zone_2");
    EXPECT_THAT(mesh.markers[2].edges, ElementsAre(Edge{3, 4}));
    EXPECT_EQ(notes.version, "2 zones, ASCII");
    EXPECT_THAT(notes.warnings, ElementsAre(HasSubstr("of zone 2 left out of the joined zones")));
}

TEST(Su2Zones, AreTakenAloneByNumberOrName)
{
    for (const char* wanted : {"2", "zone_2"}) {
        const MeshData mesh = read_with(kZones, zone(wanted));
        EXPECT_EQ(mesh.points.rows(), 4);
        EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, 3}));
        EXPECT_THAT(mesh.groups, IsEmpty());
        ASSERT_EQ(mesh.markers.size(), 2U);
        EXPECT_EQ(mesh.markers[0].name, "wall");
        EXPECT_EQ(mesh.sections.size(), 1U);
    }
    EXPECT_EQ(read_with("NDIME= 2\nNELEM= 0\nNPOIN= 0\n", zone("1")).points.rows(), 0);
    EXPECT_EQ(read_bytes("NZONE= 1\nIZONE= 1\nNDIME= 2\nNELEM= 0\nNPOIN= 0\n", "su2").sections.size(), 0U);
}

TEST(Su2Zones, FaultsAreNamedWithTheLineInTheWholeFile)
{
    EXPECT_EQ(refusal_with(kZones, zone("3")),
              "file: has no zone '3', but 2 zone(s), which are called by their number from 1");
    EXPECT_EQ(refusal_with("NDIME= 2\nNELEM= 0\nNPOIN= 0\n", zone("2")),
              "file: has no zone '2', but 1 zone(s), which are called by their number from 1");
    EXPECT_EQ(refusal(replaced(kZones, "IZONE= 2", "IZONE= 3"), "su2"), "file:19: IZONE= 3, expected 2");
    EXPECT_EQ(refusal(replaced(kZones, "NZONE= 2", "NZONE= 3"), "su2"),
              "file: NZONE= 3, but 2 zone(s) begin with IZONE=");
    EXPECT_EQ(refusal(replaced(kZones, "NZONE= 2", "NZONE= 0"), "su2"),
              "file:2: NZONE= 0, expected 1 or more");
    EXPECT_EQ(refusal(replaced(kZones, "NZONE= 2", "NZONE= 1"), "su2"),
              "file:19: IZONE= 2, but no NZONE= above NDIME= says that the file has zones");
    EXPECT_EQ(refusal(replaced(kZones, "% rotor\nNDIME= 2", "% rotor"), "su2"),
              "file: NDIME= is missing behind line 19");
    EXPECT_EQ(refusal(replaced(kZones, "9 0 1 2 3", "9 0 1 2 4"), "su2"),
              "file:22: element 0 names vertex 4, but the mesh has 4");
    EXPECT_THAT(refusal(replaced(kZones, "NPOIN= 3", "NPOIN= 5"), "su2"),
                HasSubstr("file:8: NPOIN= 5 but the section ends after 3, at NMARK="));
    EXPECT_EQ(refusal(replaced(kZones, "NDIME= 2", "NDIME= 2\nNZONE= 2"), "su2"),
              "file:6: NZONE= 2, but no NZONE= above NDIME= says that the file has zones");
}

/// A hexahedron, a pyramid on top of it and a prism next to it; the marker faces are those of the bottom, a
/// triangle and a quad. Points: the cube of the hexahedron, the apex 8, and 9 and 10 of the prism.
const std::string kVolume = "NDIME= 3\nNELEM= 3\n12 0 1 2 3 4 5 6 7 0\n14 4 5 6 7 8 1\n13 1 9 2 5 10 6 2\n"
                            "NPOIN= 12\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n.5 .5 2\n"
                            "2 0 0\n2 0 1\n9 9 9\nNMARK= 3\nMARKER_TAG= floor\nMARKER_ELEMS= 2\n9 0 3 2 1\n"
                            "5 1 9 2\nMARKER_TAG= wall\nMARKER_ELEMS= 1\n9 0 1 5 4\nMARKER_TAG= line\n"
                            "MARKER_ELEMS= 1\n3 0 1\n";

/// The volume that a closed surface of outward faces encloses; quads may be bent.
double enclosed(const MeshData& mesh)
{
    double six_times = 0;
    const auto p = [&](Index v) { return Eigen::Vector3d(mesh.points.row(v)); };
    for (const auto& [a, b, c, d] : mesh.elements) {
        six_times += p(a).dot(p(b).cross(p(c)));
        if (d >= 0)
            six_times += p(a).dot(p(c).cross(p(d)));
    }
    return six_times / 6;
}

TEST(Su2Volume, ItsSurfaceHasTheFacesOfItsMarkersAsGroups)
{
    ReadNotes notes;
    const MeshData mesh = read_with(kVolume, kSurface, &notes);
    EXPECT_EQ(mesh.dimension, 3);
    EXPECT_EQ(mesh.points.rows(), 11);    // without the last, which no cell names
    EXPECT_EQ(mesh.elements.size(), 12U); // 6 + 5 + 5 faces, two of them shared
    // cube, pyramid of height 1, half a cube: exact but for a few roundings
    EXPECT_NEAR(enclosed(mesh), 1 + 1.0 / 3 + 0.5, 1e-14);
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "floor");
    ASSERT_EQ(mesh.groups[0].elements.size(), 2U);
    for (const Index e : mesh.groups[0].elements)
        for (const Index v : mesh.elements[static_cast<std::size_t>(e)])
            EXPECT_TRUE(v < 0 || mesh.points(v, 2) == 0);
    EXPECT_EQ(mesh.groups[1].name, "wall");
    ASSERT_EQ(mesh.markers.size(), 1U);
    EXPECT_THAT(mesh.markers[0].edges, ElementsAre(Edge{0, 1}));
}

TEST(Su2Volume, FaultsAreNamedWithTheirLine)
{
    EXPECT_THAT(refusal(kVolume, "su2"), HasSubstr("file: holds a volume mesh of 3 cells; --surface"));

    EXPECT_EQ(refusal_with(replaced(kVolume, "14 4 5 6 7 8", "14 4 5 6 7 12"), kSurface),
              "file:4: element 1 names vertex 12, but the mesh has 12");
    EXPECT_EQ(refusal_with(replaced(kVolume, "14 4 5 6 7 8 1", "14 4 5 6 7"), kSurface),
              "file:4: expected vertex 5 of a pyramid (type 14), element 1, found the end of the line");
    EXPECT_EQ(refusal_with(replaced(kVolume, "14 4 5", "24 4 5"), kSurface),
              "file:4: element 1 is a quadratic tetrahedron (type 24); supported are triangles (type 5), "
              "quads (type 9), tetrahedra (type 10), hexahedra (type 12), prisms (type 13) and pyramids "
              "(type 14)");
    EXPECT_EQ(refusal_with(replaced(kVolume, "5 1 9 2\n", "5 1 9 12\n"), kSurface),
              "file:23: element 1 of the marker floor names vertex 12, but the mesh has 12");
    EXPECT_EQ(refusal_with(replaced(kVolume, "5 1 9 2\n", "8 1 9 2\n"), kSurface),
              "file:23: element 1 of the marker floor is a pixel (type 8); supported are edges (type 3), "
              "triangles (type 5) and quads (type 9)");
    EXPECT_EQ(
        refusal("NDIME= 3\nNELEM= 1\n5 0 1 2\nNPOIN= 3\n0 0 0\n1 0 0\n0 1 0\nNMARK= 1\n"
                "MARKER_TAG= a\nMARKER_ELEMS= 1\n5 0 1 2\n",
                "su2"),
        "file:10: the marker a has triangles or quads, but the mesh has no volume cells, whose boundary "
        "they could be");
}

TEST(Su2Groups, StandInCommentsAndComeBackExactly)
{
    const std::string text = written(test::with_groups(test::bare(test::quad_square(1))), "su2");
    EXPECT_THAT(text,
                HasSubstr("% GROUP_TAG= first\n% GROUP_ELEMS= 1\n% 0\n% GROUP_TAG= upper side, 50 %25\n"));
    for (const auto& [name, rich] : test::rich_meshes()) {
        if (name == "odd markers") // names that SU2 cannot hold
            continue;
        MeshData mesh = test::with_groups(rich);
        mesh.fields.clear();
        if (!mesh.groups.empty())
            mesh.groups.push_back({" blanks\nat the ends ", {1, 0}});
        const test::TemporaryFolder folder;
        EXPECT_THAT(write_mesh_data(mesh, folder.file("a.su2")), IsEmpty()) << name;
        EXPECT_EQ(difference(read_mesh_data(folder.file("a.su2")), mesh), "") << name;
    }
}

TEST(Su2Groups, StandWhereSu2DoesNotLookForMarkers)
{
    MeshData mesh = test::with_groups(test::bare(test::quad_square(1)));
    mesh.markers = {{"a", {{0, 1}}}};
    mesh.sections = {
        {"su2", "1 SEND_RECEIVE marker(s)", "MARKER_TAG= SEND_RECEIVE\nMARKER_ELEMS= 0\nSEND_RECV= 1\n"}};
    const std::string text = written(mesh, "su2");
    const std::string behind = text.substr(text.find("NMARK="));
    EXPECT_EQ(behind, "NMARK= 2\nMARKER_TAG= a\nMARKER_ELEMS= 1\n3\t0\t1\n" + mesh.sections[0].text);
}

TEST(Su2Groups, OfALargeMeshRunOnOverManyLines)
{
    const MeshData mesh = test::with_groups(test::bare(test::uneven_square(20)));
    EXPECT_EQ(difference(read_bytes(written(mesh, "su2"), "su2"), mesh), "");
}

TEST(Su2Groups, FaultsAreNamedWithTheirLine)
{
    const std::string mesh = written(test::with_groups(test::bare(test::quad_square(1))), "su2");
    ASSERT_THAT(mesh, HasSubstr("% 0\n% GROUP_TAG= upper"));
    EXPECT_EQ(refusal(replaced(mesh, "% 0\n% GROUP_TAG= upper", "% 7\n% GROUP_TAG= upper"), "su2"),
              "file:9: the group 'first' names element 7, but the mesh has 1");
    EXPECT_EQ(
        refusal(replaced(mesh, "ELEMS= 1\n% 0\n% GROUP_TAG= u", "ELEMS= 2\n% 0 0\n% GROUP_TAG= u"), "su2"),
        "file:9: the group 'first' names element 0 twice");
    EXPECT_EQ(refusal(replaced(mesh, "% GROUP_ELEMS= 1\n", ""), "su2"),
              "file:10: expected '% GROUP_ELEMS=' below the name of a group, found '%'");
    EXPECT_THAT(
        refusal(replaced(mesh, "% GROUP_ELEMS= 1\n% 0\n", "% GROUP_ELEMS= 2000000000\n% 0\nNMARK= 0\n"),
                "su2"),
        HasSubstr("file:12: expected '%' and more of the 2000000000 elements of the group 'first'"));
    EXPECT_THAT(refusal(replaced(mesh, "% 0\n", "% 0 0\n"), "su2"),
                HasSubstr("file:9: the group 'first' should have 1 elements, but has 2"));
    EXPECT_THAT(refusal(replaced(mesh, "% 0\n", "% zero\n"), "su2"),
                HasSubstr("file:11: expected an element of the group 'first', found 'zero'"));
}

TEST(Su2Zones, ZonesVolumesAndGroupsSurviveMutations)
{
    const std::vector<std::string> seeds{kZones, kVolume,
                                         written(test::with_groups(test::bare(test::quad_square(2))), "su2")};
    test::survive_mutations(
        [](const InputBytes& file) {
            return find_format("", "su2").read({file.path, file.bytes, kSurface});
        },
        seeds, 2000);
}

} // namespace

} // namespace morph
