#include "libmorph/geometry/element_tree.h"

#include "libmorph/geometry/closest_on_triangle.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/meshes.h"
#include "tests/support/random_meshes.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace {

using namespace morph;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;

Eigen::Vector3d random_vector(std::mt19937& random, double low, double high)
{
    std::uniform_real_distribution<double> uniform(low, high);
    return {uniform(random), uniform(random), uniform(random)};
}

/// A wavy surface of triangles over the unit square.
Mesh waves(Index cells)
{
    MeshData data = test::uneven_square(cells);
    data.dimension = 3;
    for (Index v = 0; v < data.points.rows(); ++v)
        data.points(v, 2) = 0.2 * std::sin(9 * data.points(v, 0)) * std::cos(7 * data.points(v, 1));
    return build_mesh(data);
}

TEST(ElementTree, FindsTheClosestPointOfASurfaceAsCgalsOwnTreeDoes)
{
    const Mesh mesh = waves(30);
    std::vector<K::Triangle_3> triangles;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const auto at = [&, e = element_corners(mesh, f)](std::size_t k) {
            const auto p = points(mesh).row(e[k]);
            return K::Point_3(p.x(), p.y(), p.z());
        };
        triangles.emplace_back(at(0), at(1), at(2));
    }
    using Primitive = CGAL::AABB_triangle_primitive<K, std::vector<K::Triangle_3>::const_iterator>;
    const CGAL::AABB_tree<CGAL::AABB_traits<K, Primitive>> peer(triangles.cbegin(), triangles.cend());
    const ElementTree tree(mesh);
    std::mt19937 random(3);
    for (int i = 0; i < 2000; ++i) {
        const Eigen::Vector3d p = random_vector(random, -0.5, 1.5);
        const ElementTree::Closest closest = tree.closest(p);
        const double expected = std::sqrt(peer.squared_distance({p.x(), p.y(), p.z()}));
        EXPECT_NEAR(closest.distance, expected, 1e-14);
        EXPECT_NEAR((closest.point - p).norm(), expected, 1e-14);
    }
}

TEST(ElementTree, GivesTheFirstElementInTheFileOfThoseEquallyNear)
{
    const MeshData data = test::uneven_square(6);
    const Mesh mesh = build_mesh(data);
    const ElementTree tree(mesh);
    for (Index v = 0; v < data.points.rows(); ++v) {
        Eigen::Vector3d above = data.points.row(v).transpose();
        above.z() = 0.25; // over a vertex all elements around it are equally near
        Index first = 0;
        while (std::find(data.elements[static_cast<std::size_t>(first)].begin(),
                         data.elements[static_cast<std::size_t>(first)].end(),
                         v) == data.elements[static_cast<std::size_t>(first)].end())
            ++first;
        const ElementTree::Closest closest = tree.closest(above);
        EXPECT_EQ(mesh.numbering.element[static_cast<std::size_t>(closest.face)], first);
        EXPECT_EQ(closest.distance, 0.25);
        EXPECT_LT(closest.feature, 0);
        const auto corner = static_cast<std::size_t>(-closest.feature - 1);
        EXPECT_EQ(
            mesh.numbering.vertex[static_cast<std::size_t>(element_corners(mesh, closest.face)[corner])], v);
    }
}

TEST(ElementTree, NamesTheSideOfAQuadAndTakesItsDiagonalForTheInside)
{
    const Mesh mesh = build_mesh(test::quad_square(1));
    const ElementTree tree(mesh);
    EXPECT_EQ(tree.closest({0.5, -1, 0}).feature, 1);
    EXPECT_EQ(tree.closest({2, 0.5, 0}).feature, 2);
    EXPECT_EQ(tree.closest({0.5, 2, 0}).feature, 3);
    EXPECT_EQ(tree.closest({-1, 0.5, 0}).feature, 4);
    EXPECT_EQ(tree.closest({0.5, 0.5, 1}).feature, 0); // on the diagonal
    EXPECT_EQ(tree.closest({2, 2, 0}).feature, -3);
}

TEST(ElementTree, FindsTheElementsWhoseBoxesMeet)
{
    std::mt19937 random(8);
    for (std::uint32_t seed = 1; seed <= 300; ++seed) {
        const Mesh mesh = build_mesh(test::random_mesh(test::some_settings(seed)));
        const ElementTree tree(mesh);
        Eigen::AlignedBox3d box(random_vector(random, 0, 1));
        box.extend(random_vector(random, 0, 1));
        box.min().z() = box.max().z() = 0;
        std::vector<Index> expected, found;
        for (Index f = 0; f < element_count(mesh); ++f) {
            Eigen::AlignedBox3d around;
            for (const Index v : element_corners(mesh, f))
                if (v >= 0)
                    around.extend(points(mesh).row(v).transpose());
            if (around.intersects(box))
                expected.push_back(f);
        }
        tree.overlapping(box, found);
        EXPECT_EQ(found, expected) << "seed " << seed;
    }
}

TEST(ElementTree, OfAMeshWithoutElementsFindsNothing)
{
    const Mesh mesh = build_mesh({});
    const ElementTree tree(mesh);
    EXPECT_EQ(tree.containing(0, 0), -1);
    std::vector<Index> found{7};
    tree.overlapping(Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)), found);
    EXPECT_TRUE(found.empty());
}

TEST(ClosestOnTriangle, OfATriangleWithoutAreaIsOnItsSides)
{
    const std::array<Eigen::Vector3d, 3> flat{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 0, 0),
                                              Eigen::Vector3d(1, 0, 0)};
    const TrianglePoint beside = closest_on_triangle(flat, {2, 1, 0});
    EXPECT_EQ(beside.point, Eigen::Vector3d(2, 0, 0));
    EXPECT_EQ(beside.distance2, 1);
    const std::array<Eigen::Vector3d, 3> point{flat[1], flat[1], flat[1]};
    EXPECT_EQ(closest_on_triangle(point, {0, 4, 0}).distance2, 25);
}

} // namespace
