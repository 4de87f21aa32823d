#include "libmorph/mesh/input_check.h"

#include "libmorph/core/error.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace morph {

namespace {

using testing::HasSubstr;

/// The message with which a mesh is refused; empty when it is not.
std::string refusal(const MeshData& data)
{
    try {
        build_mesh(data);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// The message after something was done to a 4 x 4 grid of pairs of triangles (25 vertices).
std::string refusal_after(const std::function<void(MeshData&)>& spoil)
{
    MeshData data = test::uneven_square(4);
    spoil(data);
    return refusal(data);
}

TEST(BuildMesh, RefusesAVertexOutOfRange)
{
    EXPECT_EQ(refusal_after([](MeshData& d) { d.elements[17][1] = 90210; }),
              "element 17 names vertex 90210, but the mesh has 25 vertices");
    EXPECT_THAT(refusal_after([](MeshData& d) { d.elements[3][0] = -1; }),
                HasSubstr("element 3 names vertex -1"));
    EXPECT_THAT(refusal_after([](MeshData& d) { d.elements[3][3] = -2; }),
                HasSubstr("element 3 names vertex -2"));
    EXPECT_THAT(refusal_after([](MeshData& d) { d.elements[3][3] = 25; }),
                HasSubstr("element 3 names vertex 25"));
}

TEST(BuildMesh, RefusesAnElementThatRepeatsAVertex)
{
    EXPECT_EQ(refusal_after([](MeshData& d) {
                  d.elements[5] = {1, 2, 1, -1};
              }),
              "element 5 names vertex 1 twice");
    EXPECT_EQ(refusal_after([](MeshData& d) {
                  d.elements[5] = {1, 2, 7, 2};
              }),
              "element 5 names vertex 2 twice");
}

TEST(BuildMesh, RefusesCoordinatesThatAreNotFinite)
{
    EXPECT_THAT(refusal_after([](MeshData& d) { d.points(11, 1) = std::nan(""); }),
                HasSubstr("vertex 11 has the coordinate nan"));
    EXPECT_THAT(refusal_after([](MeshData& d) { d.points(24, 0) = -INFINITY; }),
                HasSubstr("vertex 24 has the coordinate -inf"));
}

TEST(BuildMesh, TakesCoordinatesAtTheLimitOfNumbers)
{
    EXPECT_EQ(refusal_after([](MeshData& d) { d.points *= std::numeric_limits<double>::max(); }), "");
    EXPECT_EQ(refusal_after([](MeshData& d) { d.points *= std::numeric_limits<double>::denorm_min(); }), "");
}

TEST(BuildMesh, RefusesHeightInThePlane)
{
    EXPECT_THAT(refusal_after([](MeshData& d) { d.points(6, 2) = 0.5; }), HasSubstr("vertex 6 has z = 0.5"));
    EXPECT_EQ(refusal_after([](MeshData& d) { d.points(6, 2) = -0.0; }), "");
    EXPECT_EQ(refusal_after([](MeshData& d) {
                  d.points(6, 2) = 0.5;
                  d.dimension = 3;
              }),
              "");
}

TEST(BuildMesh, RefusesADimensionItDoesNotKnow)
{
    EXPECT_THAT(refusal_after([](MeshData& d) { d.dimension = 1; }), HasSubstr("dimension 1"));
    EXPECT_THAT(refusal_after([](MeshData& d) { d.dimension = 4; }), HasSubstr("dimension 4"));
}

TEST(BuildMesh, RefusesAnElementListedTwice)
{
    EXPECT_EQ(refusal_after([](MeshData& d) { d.elements.push_back(d.elements[4]); }),
              "elements 4 and 32 have the same vertices 2, 3, 8");
    EXPECT_THAT(refusal_after([](MeshData& d) {
                    d.elements[9] = {d.elements[4][1], d.elements[4][0], d.elements[4][2], -1};
                }),
                HasSubstr("elements 4 and 9 have the same vertices"));
    MeshData pillow = test::quad_square(1);
    pillow.elements.push_back({0, 2, 3, 1});
    EXPECT_THAT(refusal(pillow), HasSubstr("elements 0 and 1 have the same vertices 0, 1, 2, 3"));
}

TEST(BuildMesh, RefusesThreeElementsOnAnEdge)
{
    MeshData book;
    book.dimension = 3;
    book.points.setRandom(14, 3);
    book.elements = {{0, 2, 3, -1}, {5, 9, 6, -1}, {6, 5, 10, -1}, {11, 5, 6, -1}};
    EXPECT_THAT(refusal(book), HasSubstr("the edge between vertices 5 and 6 belongs to 3 elements ("));
    for (const char* id : {"1", "2", "3"})
        EXPECT_THAT(refusal(book), testing::ContainsRegex(std::string("\\(.*") + id + ".*\\)"));
    book.elements.pop_back();
    EXPECT_EQ(refusal(book), "");
}

TEST(BuildMesh, NamesOnlySomeOfManyElementsOnAnEdge)
{
    MeshData book;
    book.dimension = 3;
    book.points.setRandom(1002, 3);
    for (Index page = 0; page < 1000; ++page)
        book.elements.push_back({0, 1, page + 2, -1});
    EXPECT_THAT(refusal(book), HasSubstr("belongs to 1000 elements"));
    EXPECT_LT(refusal(book).size(), 200U);
}

TEST(BuildMesh, RefusesAMarkerThatIsNotOnTheMesh)
{
    const auto with_edge = [](std::array<Index, 2> edge) {
        return refusal_after([edge](MeshData& d) { d.markers.push_back({"wall", {{0, 1}, edge}}); });
    };
    EXPECT_EQ(with_edge({1, 2}), "");
    EXPECT_EQ(with_edge({0, 24}), "marker 'wall' names the edge from vertex 0 to 24, but no element has it");
    EXPECT_EQ(with_edge({24, 0}), "marker 'wall' names the edge from vertex 24 to 0, but no element has it");
    EXPECT_EQ(with_edge({4, 25}), "marker 'wall' names vertex 25, but the mesh has 25 vertices");
    EXPECT_EQ(with_edge({-1, 4}), "marker 'wall' names vertex -1, but the mesh has 25 vertices");
    EXPECT_EQ(with_edge({4, 4}), "marker 'wall' has an edge that names vertex 4 twice");
}

TEST(BuildMesh, RefusesFieldsOfTheWrongShape)
{
    const auto with_field = [](FieldLocation location, Index rows, Index components) {
        return refusal_after([&](MeshData& d) {
            d.fields = {{"p", location, Matrix::Zero(rows, components)}};
        });
    };
    EXPECT_EQ(with_field(FieldLocation::vertex, 25, 9), "");
    EXPECT_EQ(with_field(FieldLocation::element, 32, 1), "");
    EXPECT_EQ(with_field(FieldLocation::vertex, 24, 1),
              "field 'p' has 24 rows, but the mesh has 25 vertices");
    EXPECT_EQ(with_field(FieldLocation::element, 25, 1),
              "field 'p' has 25 rows, but the mesh has 32 elements");
    EXPECT_EQ(with_field(FieldLocation::vertex, 25, 0), "field 'p' has 0 components, but 1 to 9 can be held");
    EXPECT_EQ(with_field(FieldLocation::vertex, 25, 10),
              "field 'p' has 10 components, but 1 to 9 can be held");
}

TEST(BuildMesh, RefusesGroupsOfElementsThatAreNone)
{
    MeshData data = test::uneven_square(4); // 32 elements
    data.groups = {{"wing", {3, 32}}};
    EXPECT_EQ(refusal(data), "group 'wing' names element 32, but the mesh has 32");
    data.groups = {{"wing", {-1}}};
    EXPECT_EQ(refusal(data), "group 'wing' names element -1, but the mesh has 32");
    data.groups = {{"body", {3}}, {"wing", {7, 3, 7}}};
    EXPECT_EQ(refusal(data), "group 'wing' names element 7 twice");
}

TEST(BuildMesh, RefusesMoreThanCanBeNumbered)
{
    EXPECT_NO_THROW(require_countable(2'147'483'647, 268'435'455));
    EXPECT_THROW(require_countable(2'147'483'648, 1), InputError);
    EXPECT_THROW(require_countable(1, 268'435'456), InputError);
}

TEST(BuildMesh, NamesTheSameOffenderForAnyNumberOfThreads)
{
    MeshData data = test::uneven_square(300);
    for (std::size_t f = 1234; f < data.elements.size(); f += 1111)
        data.elements[f][0] = data.elements[f][1];
    const std::string first = refusal(data);
    EXPECT_THAT(first, HasSubstr("element 1234 names"));
    for (const int threads : {1, 2, 3}) {
        set_thread_count(threads);
        EXPECT_EQ(refusal(data), first);
    }
    set_thread_count(0);
}

} // namespace

} // namespace morph
