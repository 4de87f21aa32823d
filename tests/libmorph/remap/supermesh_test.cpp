#include "libmorph/remap/supermesh.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/exact_overlap.h"
#include "tests/support/meshes.h"
#include "tests/support/random_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace {

using namespace morph;

/// Areas of overlapping pairs (target, source), in numbers of the file.
using Areas = std::map<std::pair<Index, Index>, double>;

Areas found_overlaps(const Mesh& source, const Mesh& target, Cut cut)
{
    const Locator locator(source);
    const Supermesh overlaps(locator, target, cut);
    Areas areas;
    overlaps.visit(0, static_cast<std::size_t>(element_count(target)), [&](const SupermeshCell& piece) {
        for (const Overlap& overlap : piece.covers)
            areas[{target.numbering.element[static_cast<std::size_t>(piece.face)],
                   source.numbering.element[static_cast<std::size_t>(overlap.face)]}] += overlap.area;
    });
    return areas;
}

Areas found_overlaps(const MeshData& source, const MeshData& target, Cut cut)
{
    return found_overlaps(build_mesh(source), build_mesh(target), cut);
}

double sum(const Areas& areas)
{
    double total = 0;
    for (const auto& [pair, area] : areas)
        total += area;
    return total;
}

Eigen::Array2d size_of(const MeshData& mesh, Index element)
{
    Eigen::AlignedBox2d box;
    for (const Index v : mesh.elements[static_cast<std::size_t>(element)])
        if (v >= 0)
            box.extend(mesh.points.row(v).head<2>().transpose());
    return box.sizes().array();
}

/// What moving the sides of the smaller element by rounding of the larger one changes of an area.
double area_of_rounding(const Eigen::Array2d& a, const Eigen::Array2d& b)
{
    constexpr double kRounding = 4e-16; // two units in the last place
    const Eigen::Array2d small = a.min(b), large = a.max(b);
    return kRounding * (small.x() * large.y() + large.x() * small.y());
}

MeshData one_quad(const std::array<std::array<double, 2>, 4>& corners)
{
    MeshData mesh;
    mesh.points = Points::Zero(4, 3);
    for (Index k = 0; k < 4; ++k)
        mesh.points.row(k) << corners[static_cast<std::size_t>(k)][0],
            corners[static_cast<std::size_t>(k)][1], 0;
    mesh.elements = {{0, 1, 2, 3}};
    return mesh;
}

TEST(Supermesh, AgreeWithExactIntersectionsOfAllPairsOnRandomMeshes)
{
    for (std::uint32_t seed = 1; seed <= 1200; ++seed) {
        const MeshData source = test::random_mesh(test::some_settings(seed));
        const MeshData target = test::random_mesh(test::some_settings(1000 + 7 * seed));
        Areas exact;
        for (const test::ExactOverlap& overlap : test::exact_overlaps(source, target))
            exact[{overlap.target, overlap.source}] = overlap.area;
        for (const Cut cut : {Cut::where_dented, Cut::triangles}) {
            Areas difference = exact;
            for (const auto& [pair, area] : found_overlaps(source, target, cut))
                difference[pair] -= area;
            for (const auto& [pair, area] : difference) {
                EXPECT_NEAR(area, 0,
                            area_of_rounding(size_of(target, pair.first), size_of(source, pair.second)))
                    << "seed " << seed << ", target " << pair.first << ", source " << pair.second;
            }
        }
    }
}

TEST(Supermesh, OfAMeshWithItselfAreItsElements)
{
    for (const MeshData& data : {test::uneven_square(20), test::quad_square(20), test::touching_squares(5),
                                 test::random_mesh({.vertices = 300, .quads = 0.5, .holes = 0.2})}) {
        const Areas found = found_overlaps(data, data, Cut::where_dented);
        EXPECT_EQ(found.size(), data.elements.size());
        for (const auto& [pair, area] : found)
            EXPECT_EQ(pair.first, pair.second);
    }
}

TEST(Supermesh, FindAllOfASourceWithinOneElementAndAllTheSameTheOtherWayRound)
{
    constexpr double kSum = 1e-13; // of 20,000 areas cut from something a hundred times as wide
    const MeshData fine = test::uneven_square(100);
    const MeshData coarse = one_quad({{{-1, -2}, {4, -1}, {3, 5}, {-2, 3}}});
    for (const Cut cut : {Cut::where_dented, Cut::triangles}) {
        const Areas inside = found_overlaps(fine, coarse, cut), around = found_overlaps(coarse, fine, cut);
        EXPECT_EQ(inside.size(), fine.elements.size());
        EXPECT_EQ(around.size(), fine.elements.size());
        EXPECT_NEAR(sum(inside), 1, kSum);
        EXPECT_NEAR(sum(around), 1, kSum);
    }
}

TEST(Supermesh, FindWhatLiesBeyondAHoleAndInSeparateParts)
{
    // The target's centre lies in one of four small squares that a cross of holes keeps apart.
    MeshData source;
    source.points = Points::Zero(16, 3);
    for (Index part = 0; part < 4; ++part) {
        const double x = part % 2 == 0 ? 0 : 0.5, y = part < 2 ? 0 : 0.75;
        const Index first = 4 * part;
        source.points.middleRows(first, 4) << x, y, 0, x + 0.25, y, 0, x + 0.25, y + 0.625, 0, x, y + 0.625,
            0;
        source.elements.push_back({first, first + 1, first + 2, first + 3});
    }
    const MeshData target = one_quad({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
    const Areas found = found_overlaps(source, target, Cut::where_dented);
    const Areas expected{{{0, 0}, 0.15625}, {{0, 1}, 0.15625}, {{0, 2}, 0.0625}, {{0, 3}, 0.0625}};
    EXPECT_EQ(found, expected);
}

TEST(Supermesh, LeaveOutElementsThatOnlyTouch)
{
    // Turned, the common line of the two squares is rounded differently at the vertices of each.
    const auto turned = [](MeshData mesh, double shift, double angle) {
        const Points old = mesh.points;
        mesh.points.col(0) =
            std::cos(angle) * (old.col(0).array() + shift) - std::sin(angle) * old.col(1).array();
        mesh.points.col(1) =
            std::sin(angle) * (old.col(0).array() + shift) + std::cos(angle) * old.col(1).array();
        return mesh;
    };
    for (const double angle : {0.1, 0.4, 1.0, 2.0, 3.0})
        for (const Cut cut : {Cut::where_dented, Cut::triangles})
            EXPECT_TRUE(found_overlaps(turned(test::uneven_square(17), 0, angle),
                                       turned(test::quad_square(12), 1, angle), cut)
                            .empty())
                << "angle " << angle;
}

TEST(Supermesh, CutDentedElementsOfEitherMesh)
{
    constexpr double kSum = 1e-14; // of some hundred areas
    const MeshData dented = one_quad({{{1, 0}, {0.25, 0.25}, {0, 1}, {0, 0}}});
    const MeshData squares = test::quad_square(9);
    for (const Cut cut : {Cut::where_dented, Cut::triangles}) {
        EXPECT_NEAR(sum(found_overlaps(squares, dented, cut)), 0.25, kSum);
        EXPECT_NEAR(sum(found_overlaps(dented, squares, cut)), 0.25, kSum);
    }
}

TEST(Supermesh, PassThroughAnElementWithoutArea)
{
    constexpr double kSum = 1e-15; // of three areas
    // Triangle A M C between the halves of the unit square is flat: M is the middle of A C.
    MeshData source = one_quad({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
    source.points.conservativeResize(5, 3);
    source.points.row(4) << 0.5, 0.5, 0;
    source.elements = {{0, 1, 2, -1}, {0, 2, 4, -1}, {0, 4, 3, -1}, {4, 2, 3, -1}};
    const MeshData target = one_quad({{{0.25, 0.5}, {0.5, 0.25}, {0.75, 0.5}, {0.5, 0.75}}});
    const Areas found = found_overlaps(source, target, Cut::where_dented);
    EXPECT_EQ(found.size(), 3U);
    EXPECT_NEAR(sum(found), 0.125, kSum);
}

TEST(Supermesh, CountInvertedElementsWithPositiveArea)
{
    Mesh source = build_mesh(test::uneven_square(4));
    points(source).col(0) = 1 - points(source).col(0).array(); // every element is clockwise now
    const Mesh target = build_mesh(test::quad_square(3));
    constexpr double kSum = 1e-14; // of some hundred areas
    EXPECT_NEAR(sum(found_overlaps(source, target, Cut::where_dented)), 1, kSum);
    EXPECT_NEAR(sum(found_overlaps(target, source, Cut::where_dented)), 1, kSum);
}

TEST(Supermesh, StayOnOneSheetOfASourceThatLiesTwiceOverItself)
{
    constexpr double kSum = 1e-14; // of some hundred areas
    MeshData source = test::uneven_square(6);
    const auto sheet = static_cast<Index>(source.points.rows());
    source.points = source.points.replicate(2, 1).eval();
    for (const Element& e : test::uneven_square(6).elements)
        source.elements.push_back({e[0] + sheet, e[1] + sheet, e[2] + sheet, -1});
    EXPECT_NEAR(sum(found_overlaps(source, test::quad_square(4), Cut::where_dented)), 1, kSum);
}

TEST(Supermesh, AreNumberedAndVisitedInTheOrderOfTheTarget)
{
    const Mesh source = build_mesh(test::uneven_square(3)), target = build_mesh(test::quad_square(4));
    const Locator locator(source);
    const Supermesh overlaps(locator, target, Cut::triangles);
    EXPECT_EQ(overlaps.first_piece().back(), 32);
    Index next = 10;
    overlaps.visit(5, 9, [&](const SupermeshCell& piece) {
        EXPECT_EQ(piece.number, next++);
        EXPECT_EQ(piece.face, piece.number / 2);
    });
    EXPECT_EQ(next, 18);
}

TEST(Supermesh, RefuseSurfacesAndAnEmptySource)
{
    const Mesh flat = build_mesh(test::uneven_square(2));
    MeshData data = test::uneven_square(2);
    data.dimension = 3;
    const Mesh surface = build_mesh(data);
    MeshData points;
    points.points = Points::Zero(1, 3);
    const Mesh empty = build_mesh(points);
    const auto refusal = [](const Mesh& source, const Mesh& target) {
        return test::message_of([&] { Supermesh(Locator(source), target, Cut::triangles); });
    };
    EXPECT_EQ(refusal(surface, flat),
              "the source lies in space, but only planar meshes can be remapped conservatively");
    EXPECT_EQ(refusal(flat, surface),
              "the target lies in space, but only planar meshes can be remapped conservatively");
    EXPECT_EQ(refusal(empty, flat), "the source has no element to take values from");
    EXPECT_EQ(refusal(flat, empty), "nothing was thrown");
}

} // namespace
