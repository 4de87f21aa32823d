#include "libmorph/geometry/hausdorff.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"
#include "tests/support/surfaces.h"

#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace morph {
namespace {

constexpr double kTolerance = 0.01; // the default: the value is at most that much too small
constexpr double kRounding = 1e-12;

MeshData moved(MeshData data, const Eigen::RowVector3d& shift)
{
    data.points.rowwise() += shift;
    return data;
}

/// The square [0, 1]² in space, its middle vertex lifted.
MeshData tent(double height)
{
    MeshData data;
    data.dimension = 3;
    data.points.resize(5, 3);
    data.points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, height;
    data.elements = {{0, 1, 4, -1}, {1, 2, 4, -1}, {2, 3, 4, -1}, {3, 0, 4, -1}};
    return data;
}

MeshData shaken(MeshData data, double by, unsigned seed)
{
    std::mt19937 random(seed);
    for (Index i = 0; i < data.points.size(); ++i)
        data.points.data()[i] += by * (double(random()) / double(std::mt19937::max()) - 0.5);
    return data;
}

/// Largest distance of a grid of points on every triangle of one mesh, from any triangle of the other.
double sampled(const MeshData& from, const MeshData& to, Index steps)
{
    using Kernel = CGAL::Simple_cartesian<double>;
    const auto point = [](const Eigen::RowVector3d& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
    const auto corner = [](const MeshData& data, const Element& e, std::size_t k) {
        return Eigen::RowVector3d(data.points.row(e[k]));
    };
    double farthest2 = 0;
    for (const Element& e : from.elements)
        for (Index i = 0; i <= steps; ++i)
            for (Index j = 0; i + j <= steps; ++j) {
                const Kernel::Point_3 p = point(
                    (i * corner(from, e, 0) + j * corner(from, e, 1) + (steps - i - j) * corner(from, e, 2)) /
                    steps);
                double nearest2 = 1e300;
                for (const Element& t : to.elements)
                    nearest2 = std::min(
                        nearest2, CGAL::squared_distance(p, Kernel::Triangle_3(point(corner(to, t, 0)),
                                                                               point(corner(to, t, 1)),
                                                                               point(corner(to, t, 2)))));
                farthest2 = std::max(farthest2, nearest2);
            }
    return std::sqrt(farthest2);
}

TEST(Hausdorff, OfAMeshFromItselfIsZero)
{
    for (const MeshData& data : {test::sphere(7), test::uneven_square(6), tent(0.3)}) {
        const Mesh mesh = build_mesh(data);
        EXPECT_LE(hausdorff_distance(mesh, mesh).bound, kRounding);
    }
}

TEST(Hausdorff, OfAnOctahedronFromTheNextFinerSphereIsTheSagittaOfItsEdges)
{
    // The middles of the edges move outwards from 1/sqrt(2) to 1.
    const Mesh coarse = build_mesh(test::sphere(1)), fine = build_mesh(test::sphere(2));
    const double sagitta = 1 - std::sqrt(0.5);
    const HausdorffDistance there = hausdorff_distance(coarse, fine), back = hausdorff_distance(fine, coarse);
    for (const HausdorffDistance& found : {there, back}) {
        EXPECT_NEAR(found.value, sagitta, kTolerance * sagitta);
        EXPECT_LE(found.value, sagitta + kRounding);
        EXPECT_GE(found.bound, sagitta - kRounding);
    }
    EXPECT_FALSE(there.on_first);
    EXPECT_TRUE(back.on_first);
    EXPECT_NEAR(there.place.norm(), 1, 0.02); // where the distance is within 1 % of the largest
}

TEST(Hausdorff, OfASquareFromItselfMovedIsTheLengthOfTheMove)
{
    const Eigen::RowVector3d shift(0.3, 0.1, 0); // the corner that goes ahead has no nearer point
    MeshData square = test::uneven_square(5);
    for (const int dimension : {2, 3}) {
        square.dimension = dimension;
        const Mesh a = build_mesh(square), b = build_mesh(moved(square, shift));
        const HausdorffDistance found = hausdorff_distance(a, b);
        EXPECT_NEAR(found.value, shift.norm(), kTolerance * shift.norm()) << dimension;
        EXPECT_GE(found.bound, shift.norm() - kRounding) << dimension;
    }
}

TEST(Hausdorff, OfAPlaneFromItselfWithABumpIsTheHeightOfTheBump)
{
    const Mesh flat = build_mesh(tent(0)), bump = build_mesh(tent(0.2));
    const HausdorffDistance found = hausdorff_distance(flat, bump);
    EXPECT_NEAR(found.value, 0.2, kTolerance * 0.2);
    EXPECT_GE(found.bound, 0.2 - kRounding);
    EXPECT_FALSE(found.on_first);
}

TEST(Hausdorff, IsWithinItsBoundsOfADenseSampleOfSurfacesOfAnyKind)
{
    constexpr Index kSteps = 12;
    const std::vector<std::pair<MeshData, MeshData>> pairs = {
        {test::sphere(4), shaken(test::sphere(3), 0.2, 1)},
        {test::torus(9, 6), test::torus(10, 7)},
        {test::cube(2), shaken(test::cube(3), 0.3, 2)},
        {tent(0.4), moved(shaken(tent(0.1), 0.3, 3), {0.1, -0.2, 0.4})}};
    for (const auto& [a, b] : pairs) {
        const HausdorffDistance found = hausdorff_distance(build_mesh(a), build_mesh(b));
        const double sample = std::max(sampled(a, b, kSteps), sampled(b, a, kSteps));
        EXPECT_GE(found.bound, sample - kRounding);
        EXPECT_LE(found.bound, found.value * (1 + kTolerance) + kRounding);
        // No point is farther from the sample than a third of a side of its grid's triangles.
        constexpr double kLongestSide = 1.5;
        EXPECT_LE(found.value, sample + kLongestSide / kSteps / 2);
    }
}

TEST(Hausdorff, TakesTrianglesWithoutAreaAsTheirSides)
{
    MeshData data = tent(0);
    data.points.row(4) << 0.5, 0, 0; // on the side of one triangle
    const Mesh thin = build_mesh(data), bump = build_mesh(tent(0.2));
    const HausdorffDistance found = hausdorff_distance(thin, bump);
    EXPECT_NEAR(found.value, 0.2, kTolerance * 0.2);
    EXPECT_LE(found.bound, found.value * (1 + kTolerance) + kRounding);
}

TEST(Hausdorff, HasTheSameBytesForAnyNumberOfThreads)
{
    const Mesh a = build_mesh(test::sphere(30)), b = build_mesh(shaken(test::sphere(25), 0.01, 4));
    set_thread_count(1);
    const HausdorffDistance one = hausdorff_distance(a, b);
    set_thread_count(3);
    const HausdorffDistance three = hausdorff_distance(a, b);
    set_thread_count(0);
    EXPECT_EQ(one.value, three.value);
    EXPECT_EQ(one.bound, three.bound);
    EXPECT_EQ(one.place, three.place);
}

TEST(Hausdorff, FindsThePlacesBeyondADistanceOnTheTrianglesThatHaveThem)
{
    const Mesh flat = build_mesh(tent(0)), bump = build_mesh(tent(0.2));
    const std::vector<DistantPlace> found = places_beyond(flat, bump, 0.15);
    ASSERT_GE(found.size(), 4U); // the four triangles of the bump
    for (const DistantPlace& place : found) {
        EXPECT_GT(place.distance, 0.15);
        EXPECT_LT((place.point.head<2>() - Eigen::Vector2d(0.5, 0.5)).norm(), 0.5);
    }
    EXPECT_TRUE(places_beyond(flat, bump, 0.21).empty());
}

TEST(Hausdorff, RefusesAPlanarMeshAndASurface)
{
    const Mesh planar = build_mesh(test::uneven_square(2)), surface = build_mesh(tent(1));
    EXPECT_EQ(test::message_of([&] { hausdorff_distance(planar, surface); }),
              "a planar mesh and a surface have no distance; both must be one or the other");
}

} // namespace
} // namespace morph
