// What .msh files of other programs may look like, and what is refused.
#include "formats/formats.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace morph {

namespace {

using test::difference;
using test::read_bytes;
using test::refusal;
using test::replaced;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Edges = std::vector<std::array<Index, 2>>;

MeshData read_with(const std::string& bytes, ReadNotes& notes, bool surface = false)
{
    return find_format("", "gmsh").read({"file", bytes, {.surface = surface, .zone = {}}, &notes});
}

std::vector<std::string> warnings_of(const std::string& bytes)
{
    ReadNotes notes;
    read_with(bytes, notes);
    return notes.warnings;
}

/// Sections in another order, ids with gaps and out of order, tabs, CRLF, blank lines, wrapped lines, Fortran
/// exponents, parametric nodes, a backward and a nameless physical group, a line and a point of none.
const std::string kOdd41 =
    "\r\n$MeshFormat\r\n4.1\t0  8 \r\n$EndMeshFormat\r\n"
    "$Comments\nabout $this and that\nphysical 1 3 not%20ours\n$EndComments\n"
    "$Elements\r\n6 8 +1 900\r\n\r\n"
    "0 1 15 1\r\n70 10\r\n1 1 1 2\r\n5 10 20\r\n6\t20 5000000000\r\n"
    "1 2 1 1\r\n900 5000000000 30\r\n1 3 1 2\n8 30 10\n9 10 20\n"
    "2 1 3 1\r\n\r\n7 10 20\n5000000000 30\r\n"
    "2 2 2 1\r\n800 20 60 5000000000\r\n$EndElements\r\n"
    "$Junk\n1 2 $EndJunkyard 3\n$EndJunk\n"
    "$Nodes\n3 5 1 5000000000\n"
    "1 1 1 1\n 20\n1 0 0\t0.25\n"
    "2 1 1 3\n5000000000\n10\n30\n1.0D+0 1 0 .1 .2\n-0 +0 0 .3 .4 0 1d0 0 .5 .6\n"
    "3 1 0 1\n60\n2 5e-1 0\n$EndNodes\n"
    "$Entities\n1 2 2 0\n1 0 0 0 0\n"
    "1 0 0 0 1 0 0 2 -3 4 2 1 -2\n3 0 0 0 0 0 0 1 5 0\n"
    "1 0 0 0 1 1 0 2 8 9 1 1\n2 0 0 0 1 1 0 1 9 0\n$EndEntities\n"
    "$PhysicalNames\n4\n1 3 \"back \"ward\" // {5}\"\n0 1 \"corner\"\n2 9\t\"all\" \r\n1 77 \"none\"\n"
    "$EndPhysicalNames";

TEST(GmshReading, TheOddCornersOfVersion41)
{
    MeshData expected = test::square_and_triangle(0);
    expected.points.resize(5, 3); // in the order of the file
    expected.points << 1, 0, 0, 1, 1, 0, -0.0, 0, 0, 0, 1, 0, 2, 0.5, 0;
    expected.elements = {{2, 0, 1, 3}, {0, 4, 1, -1}};
    expected.markers = {{"back \"ward\" // {5}", {{0, 2}, {1, 0}}},
                        {"none", {}},
                        {"4", {{2, 0}, {0, 1}}},
                        {"curve_2", {{1, 3}}},
                        {"5", {{3, 2}, {2, 0}}}};
    expected.groups = {{"all", {0, 1}}, {"8", {0}}};
    EXPECT_EQ(difference(read_bytes(kOdd41, "gmsh"), expected), "");
    EXPECT_THAT(warnings_of(kOdd41), ElementsAre("file: section $Junk was passed over"));
}

/// Several tags, none, partitions, a line of no group, elements repeated for their second group.
const std::string kOdd22 = "$MeshFormat\n2 0 8\n$EndMeshFormat\n"
                           "$Nodes\n5\n9 0 0 0\n7 1 0 0\n5 1 1 0\n3 0 1 0\n1 2 0.5 0\n$EndNodes\n"
                           "$Elements\n8\n"
                           "1 1 2 0 6 9 7\n2 1 0 7 1\n3 1 2 11 6 1 5\n"
                           "4 15 1 4 9\n"
                           "5 3 4 21 1 1 2 9 7 5 3\n6 3 3 22 1 0 9 7 5 3\n"
                           "7 2 2 21 2 7 1 5\n8 2 2 -23 2 7 5 1\n$EndElements\n";

TEST(GmshReading, TheOddCornersOfVersion2)
{
    MeshData expected = test::square_and_triangle(0);
    expected.markers = {{"curve_6", {{0, 1}}}, {"curve_0", {{1, 4}}}, {"11", {{4, 2}}}};
    expected.groups = {{"21", {0, 1}}, {"22", {0}}, {"23", {1}}};
    EXPECT_EQ(difference(read_bytes(kOdd22, "gmsh"), expected), "");
}

TEST(GmshReading, Version40HasOtherColumns)
{
    MeshData expected = test::square_and_triangle(0);
    expected.markers = {{"low", {{0, 1}}}};
    EXPECT_EQ(
        difference(read_bytes("$MeshFormat\n4 0 8\n$EndMeshFormat\n"
                              "$PhysicalNames\n1\n1 1 \"low\"\n$EndPhysicalNames\n"
                              "$Entities\n1 1 0 0\n1 0 0 0 0 0 0 0\n4 0 0 0 1 0 0 1 1 2 1 -2\n$EndEntities\n"
                              "$Nodes\n2 5\n4 1 1 2\n1 0 0 0 0.5\n2 1 0 0 1\n"
                              "1 2 0 3\n3 1 1 0\n4 0 1 0\n5 2 0.5 0\n$EndNodes\n"
                              "$Elements\n3 3\n4 1 1 1\n1 1 2\n1 2 3 1\n2 1 2 3 4\n1 2 2 1\n3 2 5 3\n"
                              "$EndElements\n",
                              "gmsh"),
                   expected),
        "");
}

TEST(GmshReading, TagsFarApartAreFound)
{
    std::string text = replaced(kOdd22, "9 0 0 0", "2000000000 0 0 0");
    while (text.find(" 9 7") != std::string::npos)
        text = replaced(text, " 9 7", " 2000000000 7");
    EXPECT_EQ(difference(read_bytes(replaced(text, "4 9\n", "4 7\n"), "gmsh"), read_bytes(kOdd22, "gmsh")),
              "");
}

const std::string kData = "$NodeData\n2\n\"T\"\n\"scheme\"\n1\n0.5\n4\n3\n1\n4\n0\n"
                          "9 1\n7 nan\n5 -inf\n3 1D1\n$EndNodeData\n"
                          "$NodeData\n1\nT\n0\n3\n3\n1\n2\n1 5\n99 5\n$EndNodeData\n"
                          "$NodeData\n1\n\"T\"\n0\n3\n4\n1\n1\n1 7\n$EndNodeData\n"
                          "$ElementData\n1\n\"q\"\n0\n3\n0\n2\n3\n1 8 8\n7 3 4\n5 1 2\n$EndElementData\n"
                          "$ElementData\n1\n\"lines\"\n0\n3\n0\n1\n1\n2 1\n$EndElementData\n"
                          "$ElementNodeData\n1\n\"x\"\n0\n3\n0\n1\n0\n$EndElementNodeData\n";

TEST(GmshReading, PartsOfAFieldAreJoinedAndStepsAreFieldsOfTheirOwn)
{
    ReadNotes notes;
    const MeshData mesh = read_with(kOdd22 + kData, notes);
    ASSERT_EQ(mesh.fields.size(), 3U);
    EXPECT_EQ(mesh.fields[0].name, "T");
    EXPECT_EQ(mesh.fields[0].values(0, 0), 1);
    EXPECT_TRUE(std::isnan(mesh.fields[0].values(1, 0)));
    EXPECT_EQ(mesh.fields[0].values(2, 0), -INFINITY);
    EXPECT_EQ(mesh.fields[0].values(3, 0), 10);
    EXPECT_EQ(mesh.fields[0].values(4, 0), 5);
    EXPECT_EQ(mesh.fields[1].name, "T_step_4");
    EXPECT_TRUE(std::isnan(mesh.fields[1].values(3, 0)));
    EXPECT_EQ(mesh.fields[2].values, (Matrix(2, 2) << 1, 2, 3, 4).finished());
    EXPECT_EQ(notes.version, "2.2, ASCII");
    EXPECT_THAT(
        notes.warnings,
        ElementsAre("file: section $ElementNodeData was passed over",
                    "file: data 'lines' has no values for any of the 2 elements: left out",
                    "file: data 'T_step_4' has no values for 4 of the 5 vertices: they are NaN there"));
}

TEST(GmshReading, WhatStandsOutsideOfSectionsIsPassedOverAndSaid)
{
    EXPECT_THAT(warnings_of(kOdd22 + "\n\n# made by hand\n"),
                ElementsAre("file: line 25: what stands outside of the sections was passed over"));
    EXPECT_THAT(warnings_of(kOdd22 + "\n \r\n"), IsEmpty());
}

TEST(GmshReading, ElementsOfOneTagShareTheDataOfTheFirst)
{
    ReadNotes notes;
    const MeshData mesh = read_with(replaced(kOdd22, "7 2 2 21", "5 2 2 21") +
                                        "$ElementData\n1\n\"q\"\n0\n3\n0\n1\n1\n5 6\n$EndElementData\n",
                                    notes);
    EXPECT_EQ(mesh.fields.at(0).values(0, 0), 6);
    EXPECT_THAT(notes.warnings.at(0), "file: element 5 is there more than once; data go to the first");
}

const std::string kVolume = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                            "$PhysicalNames\n2\n3 1 \"body\"\n2 2 \"base\"\n$EndPhysicalNames\n"
                            "$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 0 1\n6 0 1 1\n7 0.3 0.3 2\n"
                            "$EndNodes\n$Elements\n4\n1 2 2 2 1 1 2 3\n2 6 2 1 1 1 2 3 4 5 6\n"
                            "3 6 2 4 1 1 2 3 4 5 6\n4 4 2 1 1 4 5 6 7\n$EndElements\n"
                            "$ElementData\n1\n\"q\"\n0\n3\n0\n1\n2\n1 1\n2 2\n$EndElementData\n";

TEST(GmshReading, AVolumeGivesItsBoundaryWhenAsked)
{
    ReadNotes notes;
    const MeshData mesh = read_with(kVolume, notes, true);
    EXPECT_EQ(mesh.dimension, 3);
    EXPECT_EQ(mesh.points.rows(), 7);
    EXPECT_EQ(mesh.elements.size(), 7U); // base, three sides, three of the tetrahedron
    ASSERT_EQ(mesh.groups.size(), 1U);
    EXPECT_EQ(mesh.groups[0].name, "base");
    EXPECT_EQ(mesh.elements[static_cast<std::size_t>(mesh.groups[0].elements.at(0))], (Element{0, 2, 1, -1}));
    EXPECT_EQ(refusal(kVolume, "gmsh"), "file: holds a volume mesh of 2 cells; --surface takes its boundary");
}

TEST(GmshReading, HeadersThatAreNoneAreRefused)
{
    EXPECT_EQ(refusal("", "gmsh"),
              "file:1: expected $MeshFormat, with which Gmsh files begin, found the end of the file");
    EXPECT_EQ(refusal("(0 \"Fluent\")", "gmsh"),
              "file:1: expected $MeshFormat, with which Gmsh files begin, found '(0'");
    EXPECT_EQ(refusal("$NOD\n", "gmsh"), "file:1: a Gmsh file of version 1; only 2, 4.0 and 4.1 are read");
    const std::string header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
    EXPECT_EQ(refusal(replaced(header, "4.1", "3"), "gmsh"),
              "file:2: a Gmsh file of another version than 2, 4.0 and 4.1");
    EXPECT_EQ(refusal(replaced(header, "4.1", "new"), "gmsh"),
              "file:2: expected the version of the format, found 'new'");
    EXPECT_EQ(refusal(replaced(header, "0 8", "2 8"), "gmsh"),
              "file:2: expected a file type of 0 or 1 and numbers of 4 or 8 bytes, found 2 and 8");
    EXPECT_EQ(refusal("$MeshFormat\n2.2 1 4\n", "gmsh"),
              "file:2: expected a file type of 0 or 1 and numbers of 8 bytes, found 1 and 4");
    EXPECT_EQ(refusal(replaced(header, "0 8", "0 8 1"), "gmsh"),
              "file:2: expected the end of the line after the header, found '1'");
    EXPECT_EQ(refusal("$MeshFormat\n4.1 1 8\nabcd\n$EndMeshFormat\n", "gmsh"),
              "file: byte 20: expected the number 1 that marks the byte order");
    EXPECT_EQ(refusal("$MeshFormat\n4.1 1 8\nab", "gmsh"),
              "file: byte 20: expected the number 1 that marks the byte order, found the end of the section");
    EXPECT_EQ(refusal(replaced(header, "$End", "$Ende"), "gmsh"),
              "file:3: expected $EndMeshFormat, found '$EndeMeshFormat'");
    EXPECT_EQ(refusal(header + "$Nodes\n0 0 0 0\n$EndNode\n", "gmsh"),
              "file:4: '$Nodes' has no end: expected $EndNodes behind it");
}

TEST(GmshReading, MistakesInText22AreSaidWithTheirLine)
{
    const auto changed = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kOdd22 + kData, from, to), "gmsh");
    };
    EXPECT_EQ(changed("$Nodes\n5", "$Nodes\n77"),
              "file:5: expected the number of nodes, found 77, for which the section is too short");
    EXPECT_EQ(changed("$Elements\n8", "$Elements\n9"),
              "file:22: expected the number of an element, found '$EndElements'");
    EXPECT_EQ(changed("$Nodes\n5", "$Nodes\n4"), "file:10: expected the end of the section, found '1'");
    EXPECT_EQ(changed("5 1 1 0", "5 1 x 0"), "file:8: expected a coordinate of a node, found 'x'");
    EXPECT_EQ(changed("5 1 1 0", "7 1 1 0"), "file: node 7 is there more than once");
    EXPECT_EQ(changed("$Elements\n8", "$Elements\n-8"),
              "file:13: expected the number of elements, found -8, for which the section is too short");
    EXPECT_EQ(
        changed("7 2 2 21 2 7 1 5", "7 9 2 21 2 7 1 5"),
        "file:20: an element is a triangle of 6 nodes (type 9), but only linear lines, triangles, quads and "
        "cells are supported");
    EXPECT_EQ(
        changed("7 2 2 21 2 7 1 5", "7 99 2 21 2 7 1 5"),
        "file:20: an element is of the unknown type 99, but only linear lines, triangles, quads and cells "
        "are supported");
    EXPECT_EQ(changed("7 2 2 21 2 7 1 5", "7 2 2 21 2 7 1 6"),
              "file:20: element 7 names node 6, which is not among the nodes");
    EXPECT_EQ(changed("7 2 2 21", "7 2 1e1 21"), "file:20: expected the number of tags, found '1e1'");
}

TEST(GmshReading, ManySectionsThatGiveNextToNothingAreRefused)
{
    constexpr int kNodes = 1000;
    std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" + std::to_string(kNodes) + "\n";
    for (int v = 1; v <= kNodes; ++v)
        text += std::to_string(v) + " " + std::to_string(v) + " 0 0\n";
    text += "$EndNodes\n$Elements\n0\n$EndElements\n";
    for (int i = 0; i < 2000; ++i) // 9,000 numbers each
        text += "$NodeData\n1\n\"d" + std::to_string(i) +
                "\"\n1\n0\n3\n0\n9\n1\n1 0 0 0 0 0 0 0 0 0\n$EndNodeData\n";
    EXPECT_THAT(test::refusal(text, "gmsh"), testing::HasSubstr("most of them not given"));
}

TEST(GmshReading, MistakesInDataAreSaidWithTheirLine)
{
    const auto changed = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kOdd22 + kData, from, to), "gmsh");
    };
    EXPECT_EQ(changed("0.5\n4\n3", "0.5\n2\n3"),
              "file:29: expected 3 or more integer tags: the time step, the number "
              "of components, the number of values; found 2");
    EXPECT_EQ(changed("0.5\n4\n3\n1\n", "0.5\n4\n3\n10\n"),
              "file:31: data 'T' has 10 components, expected 1 to 9");
    EXPECT_EQ(changed("3 1D1", "3"), "file:38: expected a value, found '$EndNodeData'");
    EXPECT_EQ(changed("3 1D1", "3 1 1"), "file:37: expected the end of the section, found '1'");
    EXPECT_EQ(changed("7 nan", "7.5 nan"), "file:35: expected the tag of a node or element, found '7.5'");
    EXPECT_EQ(changed("\"scheme\"\n", ""), "file:27: expected the number of real tags, found '0.5'");
    EXPECT_EQ(changed("$NodeData\n2\n", "$NodeData\n20\n"),
              "file:38: expected a text tag, found '$EndNodeData'");
}

TEST(GmshReading, MistakesInText41AreSaidWithTheirLine)
{
    const auto changed = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kOdd41, from, to), "gmsh");
    };
    EXPECT_THAT(changed("2 1 1 3\n50", "2 1 1 5\n50"),
                HasSubstr("the blocks have more nodes than $Nodes says"));
    EXPECT_THAT(changed("3 5 1 5000000000", "2 5 1 9"),
                HasSubstr("the blocks have 1 nodes less than the 5 of $Nodes"));
    EXPECT_THAT(changed("\"all\"", "all"),
                HasSubstr("expected the name of a physical group in double quotes, found 'all'"));
    EXPECT_THAT(changed("1 0 0 0 1 0 0 2 -3", "1 0 0 0 1 0 x 2 -3"),
                HasSubstr("expected a coordinate of an entity, found 'x'"));
    EXPECT_THAT(changed("1 1 1 2\r", "1 1 1 2000\r"),
                HasSubstr("expected the number of elements of a block, found 2000, for which"));
    EXPECT_THAT(changed("0 1 15 1", "0 1 34 1"), HasSubstr("an element is a polygon (type 34), but only"));
}

TEST(GmshReading, MistakesInBinaryFilesAreSaidWithTheirByte)
{
    const std::string bytes = test::written(test::square_and_triangle(0), "gmsh");
    const std::size_t end = bytes.find("\n$EndNodes");
    std::string infinite = bytes;
    infinite.replace(end - 2 * sizeof(double), sizeof(double), std::string("\0\0\0\0\0\0\xf0\x7f", 8));
    EXPECT_EQ(refusal(infinite, "gmsh"), "file: byte " + std::to_string(end - 2 * sizeof(double)) +
                                             ": a coordinate of a node is not finite");
    std::string cut = bytes;
    cut.erase(end - sizeof(double), sizeof(double));
    EXPECT_EQ(refusal(cut, "gmsh"), "file: byte " + std::to_string(end - sizeof(double)) +
                                        ": expected a coordinate of a node, found the end of the section");
    cut.erase(end - 10 * sizeof(double), 9 * sizeof(double));
    EXPECT_THAT(refusal(cut, "gmsh"),
                HasSubstr(": expected the number of nodes, found 5, for which the section is too short"));
    std::string longer = bytes;
    longer.insert(end, "12345678");
    EXPECT_EQ(refusal(longer, "gmsh"),
              "file: byte " + std::to_string(end) + ": expected the end of the section, found 9 more bytes");
}

} // namespace

} // namespace morph
