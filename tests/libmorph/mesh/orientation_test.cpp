#include "libmorph/mesh/orientation.h"

#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morph {

namespace {

/// File numbers of the elements that were turned, sorted.
std::vector<Index> turned_elements(const Mesh& mesh)
{
    std::vector<Index> ids;
    for (std::size_t f = 0; f < mesh.numbering.reversed.size(); ++f)
        if (mesh.numbering.reversed[f])
            ids.push_back(mesh.numbering.element[f]);
    std::sort(ids.begin(), ids.end());
    return ids;
}

std::size_t count_of_sign(const Mesh& mesh, int sign)
{
    std::size_t count = 0;
    for (const Element& e : element_table(mesh))
        count += area_sign(e, points(mesh)) == sign ? 1 : 0;
    return count;
}

void list_backwards(MeshData& data, std::size_t element)
{
    data.elements[element] = reversed(data.elements[element]);
}

/// A strip of @p count quads, closed to a ring; each half turn of it goes around the ring once.
MeshData twisted_ring(Index count, int half_turns)
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(2 * count, 3);
    for (Index i = 0; i < count; ++i) {
        const double around = 2 * std::numbers::pi * i / count;
        const double tilt = half_turns * around / 2;
        for (const int side : {-1, 1}) {
            const double r = 3 + side * std::cos(tilt);
            data.points.row(2 * i + (side + 1) / 2) << r * std::cos(around), r * std::sin(around),
                side * std::sin(tilt);
        }
        const Index next = (i + 1) % count;
        const bool crossed = next == 0 && half_turns % 2 == 1;
        data.elements.push_back(
            {2 * i, 2 * next + (crossed ? 1 : 0), 2 * next + (crossed ? 0 : 1), 2 * i + 1});
    }
    return data;
}

TEST(Orientation, LeavesAProperMeshAlone)
{
    for (const MeshData& data : {test::uneven_square(5), test::quad_square(5), twisted_ring(20, 2)})
        EXPECT_THAT(turned_elements(build_mesh(data)), testing::IsEmpty());
}

TEST(Orientation, TurnsWhatIsListedClockwise)
{
    for (MeshData data : {test::uneven_square(5), test::quad_square(5)}) {
        for (const std::size_t f : {3U, 4U, 11U})
            list_backwards(data, f);
        const Mesh mesh = build_mesh(data);
        EXPECT_THAT(turned_elements(mesh), testing::ElementsAre(3, 4, 11));
        EXPECT_EQ(count_of_sign(mesh, 1), data.elements.size());
        EXPECT_EQ(test::difference(to_mesh_data(mesh), data), "");
    }
}

TEST(Orientation, TurnsAMeshListedClockwiseThroughout)
{
    MeshData data = test::uneven_square(5);
    test::turn_some(data, 1, 1);
    const Mesh mesh = build_mesh(data);
    EXPECT_EQ(turned_elements(mesh).size(), data.elements.size());
    EXPECT_EQ(count_of_sign(mesh, 1), data.elements.size());
}

TEST(Orientation, TurnsAPartListedClockwise)
{
    MeshData data = test::quad_square(3);
    const MeshData other = test::quad_square(2);
    const auto shift = static_cast<Index>(data.points.rows());
    data.points.conservativeResize(shift + other.points.rows(), 3);
    data.points.bottomRows(other.points.rows()) = other.points.rowwise() + Eigen::RowVector3d(4, 0, 0);
    for (Element e : other.elements)
        data.elements.push_back(reversed({e[0] + shift, e[1] + shift, e[2] + shift, e[3] + shift}));
    EXPECT_THAT(turned_elements(build_mesh(data)), testing::ElementsAre(9, 10, 11, 12));
}

TEST(Orientation, DoesNotTurnAnElementThatIsInvertedByItsCoordinates)
{
    MeshData data = test::uneven_square(6);
    const Index inner = 3 * 7 + 3;
    data.points.row(inner) << 0.5 + 0.3, 0.5, 0; // beyond its neighbours
    const Mesh mesh = build_mesh(data);
    EXPECT_THAT(turned_elements(mesh), testing::IsEmpty());
    EXPECT_GT(count_of_sign(mesh, -1), 0U);

    list_backwards(data, 0); // the tangle is distinguished from an order of listing when both are there
    EXPECT_THAT(turned_elements(build_mesh(data)), testing::ElementsAre(0));
    test::turn_some(data, 1, 1);
    EXPECT_EQ(count_of_sign(build_mesh(data), -1), count_of_sign(mesh, -1));
}

TEST(Orientation, KeepsTheMajorityOfASurface)
{
    MeshData data = twisted_ring(20, 0);
    for (const std::size_t f : {2U, 3U, 9U})
        list_backwards(data, f);
    EXPECT_THAT(turned_elements(build_mesh(data)), testing::ElementsAre(2, 3, 9));
    for (std::size_t f = 0; f < 20; ++f)
        list_backwards(data, f);
    EXPECT_THAT(turned_elements(build_mesh(data)), testing::ElementsAre(2, 3, 9));
}

TEST(Orientation, KeepsTheFirstListedElementOnATie)
{
    MeshData data = twisted_ring(20, 0);
    for (std::size_t f = 0; f < 20; f += 2)
        list_backwards(data, f);
    const Mesh mesh = build_mesh(data);
    EXPECT_THAT(turned_elements(mesh), testing::ElementsAre(1, 3, 5, 7, 9, 11, 13, 15, 17, 19));
    test::expect_sound(mesh);
}

TEST(Orientation, LeavesElementsWithoutAreaAsListed)
{
    MeshData data;
    data.points.resize(3, 3);
    data.points << 0, 0, 0, 1, 0, 0, 2, 0, 0;
    data.elements = {{2, 1, 0, -1}};
    EXPECT_THAT(turned_elements(build_mesh(data)), testing::IsEmpty());
}

TEST(Orientation, RefusesAMoebiusStrip)
{
    for (const unsigned seed : {1U, 2U, 3U}) {
        MeshData strip = test::shuffled(twisted_ring(12, 1), seed);
        try {
            build_mesh(strip);
            ADD_FAILURE() << "a Moebius strip was taken";
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(),
                        testing::ContainsRegex("cannot be oriented: elements [0-9]+ and [0-9]+"));
        }
        EXPECT_NO_THROW(build_mesh(test::shuffled(twisted_ring(12, 2), seed)));
    }
}

TEST(AreaSign, IsExact)
{
    Points p(4, 3);
    const Element triangle{0, 1, 2, -1};
    const auto sign = [&](const Element& e) { return area_sign(e, {p.data(), p.rows(), 3}); };
    // Points on the line y = x, far from the origin, and one moved off it by one unit in the last place.
    p << 12, 12, 0, 24, 24, 0, 0.5, 0.5, 0, 0, 0, 0;
    EXPECT_EQ(sign(triangle), 0);
    p(2, 1) = std::nextafter(0.5, 1);
    EXPECT_EQ(sign(triangle), 1);
    p(2, 1) = std::nextafter(0.5, 0);
    EXPECT_EQ(sign(triangle), -1);
    EXPECT_EQ(sign(reversed(triangle)), 1);
}

TEST(AreaSign, HoldsOutAtTheLimitsOfNumbers)
{
    Points p(4, 3);
    p << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    for (const double scale : {1e308, 1e160, 1e-160, 1e-308}) {
        const Points scaled = p * scale;
        EXPECT_EQ(area_sign({0, 1, 2, 3}, {scaled.data(), 4, 3}), 1) << scale;
        EXPECT_EQ(area_sign({0, 3, 2, 1}, {scaled.data(), 4, 3}), -1) << scale;
        EXPECT_EQ(area_sign({0, 2, 1, -1}, {scaled.data(), 4, 3}), -1) << scale;
    }
}

TEST(AreaSign, OfAQuadIsThatOfItsWholeArea)
{
    Points p(4, 3);
    p << 0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 0; // not convex at the third corner
    EXPECT_EQ(area_sign({0, 1, 2, 3}, {p.data(), 4, 3}), 1);
    p.row(2) << -3, -3, 0; // more area outside than inside
    EXPECT_EQ(area_sign({0, 1, 2, 3}, {p.data(), 4, 3}), -1);
}

} // namespace

} // namespace morph
