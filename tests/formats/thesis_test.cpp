// The text files of the thesis: meshes, destinations, and which files go with a mesh.
#include "formats/formats.h"
#include "tests/support/errors.h"
#include "tests/support/format_cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace morph {

namespace {

using test::difference;
using test::message_of;
using test::planar_meshes;
using test::read_bytes;
using test::read_text;
using test::refusal;
using test::replaced;
using test::square_and_triangle;
using test::TemporaryFolder;
using test::written;
using testing::ElementsAre;
using testing::IsEmpty;

/// Coordinates of the corners of an element, the smallest first: so that it does not matter where it begins.
std::vector<std::array<double, 2>> corners(const MeshData& mesh, const Element& element)
{
    std::vector<std::array<double, 2>> places;
    for (int k = 0; k < corner_count(element); ++k) {
        const Index v = element[static_cast<std::size_t>(k)];
        places.push_back({mesh.points(v, 0), mesh.points(v, 1)});
    }
    std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
    return places;
}

void expect_same_elements(const MeshData& a, const MeshData& b, const std::string& name)
{
    ASSERT_EQ(a.elements.size(), b.elements.size()) << name;
    for (std::size_t e = 0; e < a.elements.size(); ++e)
        EXPECT_EQ(corners(a, a.elements[e]), corners(b, b.elements[e])) << name << ", element " << e;
}

TEST(Thesis, MeshesComeBackCornerByCorner)
{
    for (const auto& [name, mesh] : planar_meshes()) {
        const MeshData read = read_bytes(written(mesh, "thesis"), "thesis");
        expect_same_elements(mesh, read, name);
        std::set<Index> used;
        for (const Element& element : mesh.elements)
            used.insert(element.begin(), element.begin() + corner_count(element));
        EXPECT_EQ(read.points.rows(), static_cast<Eigen::Index>(used.size())) << name;
        EXPECT_EQ(read.dimension, 2) << name;
    }
}

TEST(Thesis, WhatWasReadComesBackBitForBit)
{
    for (const auto& [name, mesh] : planar_meshes()) {
        const std::string text = written(mesh, "thesis");
        const MeshData read = read_bytes(text, "thesis");
        EXPECT_EQ(written(read, "thesis"), text) << name;
        EXPECT_EQ(difference(read_bytes(written(read, "thesis"), "thesis"), read), "") << name;
    }
}

TEST(Thesis, AQuadWithACornerAtTheOriginComesBackWhereverItBegins)
{
    for (std::size_t first = 0; first < 4; ++first) {
        const MeshData mesh = square_and_triangle(first);
        const MeshData read = read_bytes(written(mesh, "thesis"), "thesis");
        expect_same_elements(mesh, read, std::to_string(first));
        // a reader that takes x4 = y4 = 0 for a triangle must not be misled either
        EXPECT_FALSE(read.points.row(read.elements[0][3]).isZero(0)) << first;
    }
}

TEST(Thesis, NumbersNodesInTheOrderOfTheirFirstAppearance)
{
    const MeshData mesh = read_bytes("\n5 1 1\r\nid x1 y1\t x2 y2\r\n\n"
                                     " 1\t+1D0 0 1 1 -0 1 0. -0\r\n\r\n2 1 0  2e0 .5 1 1 0 0",
                                     "thesis");
    EXPECT_EQ(mesh.points, (Points(5, 3) << 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0, 2, 0.5, 0).finished());
    EXPECT_THAT(mesh.elements, ElementsAre(Element{0, 1, 2, 3}, Element{0, 4, 1, -1}));
    EXPECT_FALSE(std::signbit(mesh.points(2, 0))) << "-0 and 0 are one coordinate";
}

TEST(Thesis, TheCountsTellWhetherARowEndsAtTheOriginOrIsATriangle)
{
    const std::string row = "1 1 0 1 1 0 1 0 0\n";
    EXPECT_THAT(read_bytes("4 0 1\nid\n" + row, "thesis").elements, ElementsAre(Element{0, 1, 2, 3}));
    EXPECT_THAT(read_bytes("3 1 0\nid\n" + row, "thesis").elements, ElementsAre(Element{0, 1, 2, -1}));
}

/// The unit square at the origin as a quad that ends there, and a triangle on its right side.
const std::string kOneOfTwo = "5 1 1\nid x1 y1 x2 y2 x3 y3 x4 y4\n1 1 0 1 1 0 1 0 0\n2 1 0 2 .5 1 1 0 0\n";

TEST(Thesis, WhereTheCountsLeaveItOpenTheQuadIsTheOneThatCanBe)
{
    EXPECT_EQ(corner_count(read_bytes(kOneOfTwo, "thesis").elements[0]), 4);
    // convex with the origin too, but its diagonal is a side of element 2: only element 3 can be the quad
    const MeshData half_and_half =
        read_bytes("7 2 1\nid\n1 1 0 1 1 0 1 0 0\n2 1 0 0 1 0 0 0 0\n3 -1 0 -1 -1 0 -1 0 0\n", "thesis");
    EXPECT_EQ(corner_count(half_and_half.elements[0]), 3);
    EXPECT_EQ(corner_count(half_and_half.elements[2]), 4);
}

TEST(Thesis, SaysWhenNothingTellsWhichRowIsAQuad)
{
    EXPECT_EQ(
        refusal("\n8 1 1\nid\n1 1 0 1 1 0 1 0 0\n2 -1 0 -1 -1 0 -1 0 0\n", "thesis"),
        "file:2: counts 1 quads, 1 of them among the 2 elements whose fourth corner is 0 0, but neither "
        "the counts nor the elements show which");
}

TEST(Thesis, DestinationsArePointsWithoutElements)
{
    const MeshData read = read_bytes("3\r\n1\t2\r\n\r\n 0.1 -1D-3\n1e22 0", "thesis");
    EXPECT_EQ(read.points, (Points(3, 3) << 1, 2, 0, 0.1, -1e-3, 0, 1e22, 0, 0).finished());
    EXPECT_THAT(read.elements, IsEmpty());
    EXPECT_EQ(written(read, "thesis"), "3\n1 2\n0.1 -0.001\n1e+22 0\n");
    EXPECT_EQ(read_bytes("0\n", "thesis").points.rows(), 0);
}

TEST(Thesis, EveryBrokenMeshIsRefusedWithItsLine)
{
    const auto broken = [](const std::string& from, const std::string& to) {
        return refusal(replaced(kOneOfTwo, from, to), "thesis");
    };
    EXPECT_EQ(refusal("", "thesis"),
              "file:1: is empty, but the counts of a mesh or a list of destinations were expected");
    EXPECT_EQ(refusal("wing\n", "thesis"), "file:1: expected the number of nodes, found 'wing'");
    EXPECT_EQ(broken("5 1 1", "5 1"), "file:1: expected the number of quads, found the end of the line");
    EXPECT_EQ(broken("5 1 1", "5 1 1 7"),
              "file:1: expected the end of the line after the three counts, found '7'");
    EXPECT_EQ(broken("5 1 1", "6 1 1"),
              "file:1: counts 6 nodes, but the elements have 5 corners with different coordinates");
    EXPECT_EQ(broken("5 1 1", "\n\n5 2 1"), "file:3: counts 2 triangles and 1 quads, but 2 elements follow");
    EXPECT_EQ(broken("5 1 1", "5 2147483647 2147483647"),
              "file:1: counts 2147483647 triangles and 2147483647 quads, but 2 elements follow");
    EXPECT_EQ(refusal("4 1 0\nid\n1 1 0 1 1 0 1 0 .5\n", "thesis"),
              "file:3: element 1 is one quad more than the 0 counted");
    EXPECT_EQ(broken("\n2 1 0", "\n3 1 0"), "file:4: element 2 was expected, found 3");
    EXPECT_EQ(broken(" 2 .5", " 2 nan"), "file:4: expected the y of a corner, found 'nan'");
    EXPECT_EQ(broken(" 2 .5", " 1e999 .5"), "file:4: expected the x of a corner, found '1e999'");
    EXPECT_EQ(broken(" 2 .5", " 2"), "file:4: expected the y of a corner, found the end of the line");
    EXPECT_EQ(broken("1 1 0 0", "1 1 0 0 0"),
              "file:4: expected the end of the line after four corners, found '0'");
}

TEST(Thesis, EveryBrokenListOfDestinationsIsRefusedWithItsLine)
{
    EXPECT_EQ(refusal("\n2\n1 2\n", "thesis"), "file:2: counts 2 nodes, but 1 follow");
    EXPECT_EQ(refusal("1\n1 2\n3 4\n", "thesis"), "file:1: counts 1 nodes, but 2 follow");
    EXPECT_EQ(refusal("1\n\n1 x\n", "thesis"), "file:3: expected the y of a destination, found 'x'");
    EXPECT_EQ(
        refusal("1\n1 2 3\n", "thesis"),
        "file:2: expected the end of the line after x and y (a mesh has three counts in its first line; "
        "function values and neighbours are no mesh), found '3'");
}

TEST(Thesis, SurvivesMutatedFiles)
{
    test::survive_mutations(
        "thesis", {kOneOfTwo, "3\n1 2\n.1 -1D-3\n4 5\n", written(test::quad_square(2), "thesis")}, 900);
}

TEST(Thesis, WritesItsCompanionsWithTheMeshOrNothing)
{
    const TemporaryFolder folder;
    MeshData mesh = square_and_triangle(0);
    mesh.fields = {{"T", FieldLocation::vertex, mesh.points.col(0)},
                   {"u/v", FieldLocation::vertex, Matrix::Constant(5, 2, 1)},
                   {"cells", FieldLocation::element, Matrix::Constant(2, 1, 1)}};
    const std::string path = folder.file("out.txt");
    EXPECT_THAT(write_mesh_data(mesh, path),
                ElementsAre(path + ": thesis cannot hold 1 element field(s) cells"));
    EXPECT_THAT(folder.names(),
                ElementsAre("out.T.txt", "out.neighbours.txt", "out.txt", "out.u_v_0.txt", "out.u_v_1.txt"));
    const std::string before = read_text(path);
    mesh.points(4, 0) = 3;
    mesh.fields.push_back({"u_v", FieldLocation::vertex, Matrix::Zero(5, 2)});
    EXPECT_EQ(message_of([&] { write_mesh_data(mesh, path); }),
              path + ": two of the files that go with it would be called " + folder.file("out.u_v_0.txt") +
                  "; rename a field");
    EXPECT_EQ(folder.names().size(), 5U);
    EXPECT_EQ(read_text(path), before);
}

TEST(Thesis, NamesWhatItsFilesCannotHold)
{
    const TemporaryFolder folder;
    const std::string path = folder.file("out.txt");
    const auto losses = [&](const MeshData& mesh) { return write_mesh_data(mesh, path); };
    EXPECT_THAT(losses(square_and_triangle(0)), IsEmpty());
    EXPECT_THAT(
        losses(square_and_triangle(1)),
        ElementsAre(path + ": thesis cannot hold the numbers of vertices: they are renumbered when read"));

    MeshData loose = square_and_triangle(0);
    loose.points.conservativeResize(7, Eigen::NoChange);
    loose.points.bottomRows(2).setConstant(0);
    EXPECT_THAT(losses(loose), ElementsAre(path + ": thesis cannot hold 2 vertices of no element"));

    MeshData slit = square_and_triangle(0); // the triangle gets a vertex of its own where the quad has one
    slit.points.conservativeResize(6, Eigen::NoChange);
    slit.points.row(5) = slit.points.row(2);
    slit.elements[1] = {1, 4, 5, -1};
    EXPECT_THAT(
        losses(slit),
        ElementsAre(path +
                        ": thesis cannot hold 1 vertices at the place of others: they are joined when read",
                    path + ": thesis cannot hold the numbers of vertices: they are renumbered when read"));

    MeshData points;
    points.points = Points::Zero(1, 3);
    points.fields = {{"T", FieldLocation::vertex, Matrix::Zero(1, 1)},
                     {"p", FieldLocation::element, Matrix::Zero(0, 1)}};
    EXPECT_THAT(losses(points),
                ElementsAre(path + ": thesis cannot hold 1 element field(s) p",
                            path + ": thesis cannot hold nodal field T of points without elements"));
    EXPECT_THAT(message_of([&] { losses(test::rich_meshes()[3].second); }),
                testing::StartsWith(path + ": thesis holds planar meshes only"));
}

} // namespace

} // namespace morph
