#include "libmorph/remap/convex_parts.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace {

using namespace morph;

Mesh one_element(const std::vector<std::array<double, 2>>& corners)
{
    MeshData data;
    data.points = Points::Zero(static_cast<Eigen::Index>(corners.size()), 3);
    Element element{-1, -1, -1, -1};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        data.points.row(static_cast<Eigen::Index>(k)) << corners[k][0], corners[k][1], 0;
        element[k] = static_cast<Index>(k);
    }
    data.elements = {element};
    return build_mesh(data);
}

/// Every side of a piece that is not a diagonal joins the corners of the element's side of that number.
void expect_sides_of_the_element(const Mesh& mesh, const ConvexPart& piece)
{
    const Element element = element_corners(mesh, 0);
    const int n = corner_count(element);
    for (int k = 0; k < piece.outline.corners; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const int side = piece.outline.side[i];
        if (side == kNoSide)
            continue;
        const std::set<Index> ends{piece.vertices[i],
                                   piece.vertices[static_cast<std::size_t>((k + 1) % piece.outline.corners)]};
        EXPECT_EQ(ends, (std::set<Index>{element[static_cast<std::size_t>(side)],
                                         element[static_cast<std::size_t>((side + 1) % n)]}));
    }
}

TEST(CutElement, LeavesTrianglesAndConvexQuadsWhole)
{
    const Mesh triangle = one_element({{0, 0}, {2, 0}, {0, 3}});
    EXPECT_EQ(split_convex(triangle, 0, Cut::triangles).count, 1);
    EXPECT_EQ(split_convex(triangle, 0, Cut::triangles).piece[0].area, 3);
    const Mesh quad = one_element({{0, 0}, {2, 0}, {3, 3}, {0, 2}});
    const ConvexParts pieces = split_convex(quad, 0, Cut::where_dented);
    ASSERT_EQ(pieces.count, 1);
    EXPECT_EQ(convex_part_count(quad, 0, Cut::where_dented), 1);
    EXPECT_EQ(pieces.piece[0].area, 6);
    expect_sides_of_the_element(quad, pieces.piece[0]);
}

TEST(CutElement, CutsQuadsAlongTheDiagonalFromTheFirstCornerOfTheFile)
{
    const Mesh quad = one_element({{0, 0}, {2, 0}, {3, 3}, {0, 2}});
    const ConvexParts pieces = split_convex(quad, 0, Cut::triangles);
    ASSERT_EQ(pieces.count, 2);
    EXPECT_EQ(convex_part_count(quad, 0, Cut::triangles), 2);
    for (const ConvexPart& piece : pieces.all()) {
        EXPECT_EQ(piece.area, 3);
        expect_sides_of_the_element(quad, piece);
        std::set<Index> in_file;
        for (int k = 0; k < 3; ++k)
            in_file.insert(
                quad.numbering.vertex[static_cast<std::size_t>(piece.vertices[static_cast<std::size_t>(k)])]);
        EXPECT_TRUE(in_file.count(0) == 1 && in_file.count(2) == 1);
    }
}

TEST(CutElement, CutsADentedQuadAlongItsInnerDiagonal)
{
    const Mesh quad = one_element({{4, 0}, {1, 1}, {0, 4}, {0, 0}}); // dented at (1, 1)
    for (const Cut cut : {Cut::where_dented, Cut::triangles}) {
        const ConvexParts pieces = split_convex(quad, 0, cut);
        ASSERT_EQ(pieces.count, 2);
        EXPECT_EQ(convex_part_count(quad, 0, cut), 2);
        EXPECT_EQ(pieces.piece[0].area + pieces.piece[1].area, 4); // the outer halves would have 8 + 4
        for (const ConvexPart& piece : pieces.all())
            expect_sides_of_the_element(quad, piece);
    }
}

TEST(CutElement, TurnsAnInvertedElementToCounterClockwise)
{
    Mesh mesh = one_element({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
    points(mesh).col(0) *= -1; // moved, not listed, the other way round
    const ConvexParts pieces = split_convex(mesh, 0, Cut::where_dented);
    ASSERT_EQ(pieces.count, 1);
    EXPECT_EQ(pieces.piece[0].area, 2);
    EXPECT_EQ(area(pieces.piece[0].outline), 2);
    expect_sides_of_the_element(mesh, pieces.piece[0]);
    for (const ConvexParts both = split_convex(mesh, 0, Cut::triangles);
         const ConvexPart& half : both.all()) {
        EXPECT_EQ(area(half.outline), 1);
        expect_sides_of_the_element(mesh, half);
    }
}

TEST(TotalArea, IsThatOfTheSquare)
{
    constexpr double kSum = 1e-14; // of 20,000 rounded areas that sum to 1
    EXPECT_NEAR(total_area(build_mesh(test::uneven_square(100))), 1, kSum);
    EXPECT_NEAR(total_area(build_mesh(test::quad_square(141))), 1, kSum);
}

} // namespace
