#include "libmorph/quality/safe_step.h"

#include "formats/formats.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tests/support/errors.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/meshes.h"
#include "tests/support/random_meshes.h"

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <random>

namespace morph {
namespace {

using Exact = CGAL::Exact_rational;

MeshData one_element(const Points& corners)
{
    MeshData data;
    data.points = corners;
    data.elements = {corners.rows() == 3 ? Element{0, 1, 2, -1} : Element{0, 1, 2, 3}};
    return data;
}

/// Points given in the file's order, in the order of the mesh.
Points in_mesh_order(const Mesh& mesh, const Points& file_points)
{
    Points result(vertex_count(mesh), 3);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        result.row(v) = file_points.row(mesh.numbering.vertex[static_cast<std::size_t>(v)]);
    return result;
}

SafeStep step_of(const MeshData& data, const Points& after)
{
    const Mesh mesh = build_mesh(data);
    return safe_step(mesh, points(mesh), in_mesh_order(mesh, after));
}

/// The real mesh turned about the middle of its chord by @p degrees.
Points turned(const Mesh& mesh, double degrees)
{
    const Eigen::Rotation2Dd rotation(degrees / 180 * M_PI);
    Points after = points(mesh);
    for (Index v = 0; v < after.rows(); ++v)
        after.row(v).head<2>() = (rotation * Eigen::Vector2d(after(v, 0) - 0.5, after(v, 1))).transpose();
    return after;
}

Points shaken(const Points& points, double amount, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shift(-amount, amount);
    Points moved = points;
    for (Index i = 0; i < moved.rows(); ++i)
        moved.row(i).head<2>() += Eigen::RowVector2d(shift(random), shift(random));
    return moved;
}

/// Whether all corners of an element turn left at one moment, and from 0 to it: each Jacobian as
/// c0 + c1 t + c2 t^2 in rational numbers is positive at 0, at the moment, and at its lowest point between.
bool valid_until(const Points& before, const Points& after, const Element& e, double time)
{
    const auto n = static_cast<std::size_t>(corner_count(e));
    for (std::size_t k = 0; k < n; ++k) {
        const auto edge = [&](const Points& p, std::size_t to, int axis) -> Exact {
            return Exact(p(e[to], axis)) - Exact(p(e[k], axis));
        };
        const std::size_t next = (k + 1) % n, previous = (k + n - 1) % n;
        const Exact ax = edge(before, next, 0), ay = edge(before, next, 1);
        const Exact bx = edge(before, previous, 0), by = edge(before, previous, 1);
        const Exact ux = edge(after, next, 0) - ax, uy = edge(after, next, 1) - ay;
        const Exact vx = edge(after, previous, 0) - bx, vy = edge(after, previous, 1) - by;
        const Exact c0 = ax * by - ay * bx, c1 = ax * vy - ay * vx + ux * by - uy * bx,
                    c2 = ux * vy - uy * vx;
        const auto at = [&](const Exact& t) -> Exact { return c0 + t * (c1 + t * c2); };
        if (c0 <= 0 || at(time) <= 0)
            return false;
        if (c2 > 0 && c1 < 0 && -c1 < 2 * c2 * Exact(time) && at(-c1 / (2 * c2)) <= 0)
            return false;
    }
    return true;
}

/// The safe step as the definition has it, element by element, by bisection over what valid_until() says.
SafeStep plain_safe_step(const MeshData& data, const Points& after)
{
    SafeStep found;
    for (std::size_t e = 0; e < data.elements.size(); ++e) {
        const auto valid = [&](double t) { return valid_until(data.points, after, data.elements[e], t); };
        if (valid(found.step))
            continue;
        double low = 0, high = found.step;
        for (double middle = high / 2; low < middle && middle < high; middle = low + (high - low) / 2)
            (valid(middle) ? low : high) = middle;
        if (low < found.step)
            found = {low, static_cast<Index>(e)};
    }
    return found;
}

TEST(SafeStep, IsAllOfAMoveThatTurnsNoElementOver)
{
    const MeshData data = test::uneven_square(5);
    const SafeStep none = step_of(data, data.points);
    EXPECT_EQ(none.step, 1);
    EXPECT_EQ(none.element, -1);
    Points sheared = data.points; // an affine map with positive determinant, straight from the identity
    sheared.col(0) = 3 * data.points.col(0) + 2 * data.points.col(1);
    EXPECT_EQ(step_of(data, sheared).step, 1);
}

TEST(SafeStep, EndsAtTheLastDoubleBeforeATriangleCollapses)
{
    Points corners(3, 3);
    corners << 0, 0, 0, 1, 0, 0, 0, 1, 0;
    for (const double time : {0.5, 0.25, 0.75, 1.0}) {
        Points after = corners;
        after(2, 1) = 1 - 1 / time; // its height is 1 - t / time
        const SafeStep safe = step_of(one_element(corners), after);
        if (time == 0.75) // 1 / 0.75 is rounded
            EXPECT_NEAR(safe.step, 0.75, 1e-15);
        else
            EXPECT_EQ(safe.step, std::nextafter(time, 0));
        EXPECT_EQ(safe.element, 0);
    }
}

TEST(SafeStep, SeesAQuadOfPositiveAreaFoldAtOneCorner)
{
    Points corners(4, 3);
    corners << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    Points after = corners;
    after.row(2) << 0.25, 0.25, 0; // crosses the diagonal between its neighbours when 1 - 0.75 t = 0.5
    const SafeStep safe = step_of(one_element(corners), after);
    EXPECT_NEAR(safe.step, 2.0 / 3, 1e-15);
    EXPECT_EQ(safe.element, 0);
    const Mesh mesh = build_mesh(one_element(corners));
    EXPECT_EQ(quality_report(mesh, in_mesh_order(mesh, after)).negative_area, 0);
}

TEST(SafeStep, OfHalfATurnInOneMoveIsTheFirstHalf)
{
    const MeshData data = test::quad_square(3);
    Points after = data.points;
    after.leftCols<2>() *=
        -1; // every element shrinks to a point at t = 0.5 and comes out turned, not inverted
    const SafeStep safe = step_of(data, after);
    EXPECT_EQ(safe.step, std::nextafter(0.5, 0));
    EXPECT_EQ(safe.element, 0);
    const Mesh mesh = build_mesh(data);
    EXPECT_EQ(quality_report(mesh, in_mesh_order(mesh, after)).inverted, 0);
}

TEST(SafeStep, LetsRotationsBelowHalfATurnThroughOnRealMeshes)
{
    for (const char* name : {"naca0012_inv.su2", "naca0012_lam_hybrid.su2", "rae2822_turb.su2"}) {
        const Mesh mesh = read_mesh(test::data_path(std::string("meshes/") + name));
        for (const double degrees : {30.0, 90.0, 170.0})
            EXPECT_EQ(safe_step(mesh, points(mesh), turned(mesh, degrees)).step, 1) << name << ' ' << degrees;
        EXPECT_NEAR(safe_step(mesh, points(mesh), turned(mesh, 180)).step, 0.5, 1e-6) << name;
    }
}

TEST(SafeStep, IsNothingWhenAnElementIsInvertedBefore)
{
    MeshData data = test::uneven_square(4);
    const Mesh mesh = build_mesh(data);
    Points before = points(mesh);
    before.row(element_corners(mesh, 7)[0]) = Eigen::RowVector3d(5, 5, 0);
    const QualityReport report = quality_report(mesh, before);
    ASSERT_GT(report.inverted, 0);
    const SafeStep safe = safe_step(mesh, before, points(mesh)); // though the move repairs it
    EXPECT_EQ(safe.step, 0);
    EXPECT_EQ(safe.element, report.inverted_elements.front());
}

TEST(SafeStep, OfAMeshWithAPlaceThatIsNoNumberIsNothing)
{
    const Mesh mesh = build_mesh(test::uneven_square(2));
    Points after = points(mesh);
    after(4, 0) = std::nan("");
    EXPECT_EQ(safe_step(mesh, points(mesh), after).step, 0);
}

TEST(SafeStep, AgreesWithBisectionInRationalNumbersOnRandomMeshes)
{
    int limited = 0;
    for (std::uint32_t seed = 1; seed <= 120; ++seed) {
        test::RandomMesh settings;
        settings.vertices = 15;
        settings.quads = seed % 3 == 0 ? 0.5 : 0;
        settings.grid = seed % 2 == 0 ? 8 : 0;
        settings.seed = seed;
        const MeshData data = test::random_mesh(settings);
        Points after = shaken(data.points, seed % 4 == 0 ? 0.05 : 0.4, seed);
        if (seed % 2 == 0)
            after = (after * 8).array().round() / 8; // ties and points that meet sides
        const SafeStep expected = plain_safe_step(data, after);
        const SafeStep safe = step_of(data, after);
        ASSERT_EQ(safe.step, expected.step) << seed;
        ASSERT_EQ(safe.element, expected.element) << seed;
        limited += expected.step < 1 ? 1 : 0;
    }
    EXPECT_GT(limited, 60);
}

TEST(SafeStep, NamesElementsByTheirNumberInAShuffledFile)
{
    const MeshData data = test::shuffled(test::quad_square(12), 3);
    const Points after = shaken(data.points, 0.1, 4);
    const SafeStep expected = plain_safe_step(data, after);
    const SafeStep safe = step_of(data, after);
    ASSERT_LT(expected.step, 1);
    EXPECT_EQ(safe.step, expected.step);
    EXPECT_EQ(safe.element, expected.element);
}

TEST(SafeStep, IsTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = build_mesh(test::shuffled(test::uneven_square(90), 5)); // four blocks
    for (const Points& after : {shaken(points(mesh), 0.02, 6), Points(-points(mesh))}) {
        set_thread_count(1);
        const SafeStep one = safe_step(mesh, points(mesh), after);
        EXPECT_LT(one.step, 1);
        for (const int threads : {2, 3, 8}) {
            set_thread_count(threads);
            const SafeStep many = safe_step(mesh, points(mesh), after);
            EXPECT_EQ(one.step, many.step);
            EXPECT_EQ(one.element, many.element);
        }
    }
    set_thread_count(0);
}

TEST(SafeStep, RefusesSurfacesAndPositionsOfAnotherMesh)
{
    Mesh mesh = build_mesh(test::quad_square(1));
    const Points few = Points::Zero(3, 3);
    EXPECT_EQ(test::message_of([&] { safe_step(mesh, points(mesh), few); }),
              "there are 3 positions, but the mesh has 4 vertices");
    mesh.dimension = 3;
    EXPECT_EQ(test::message_of([&] { safe_step(mesh, points(mesh), points(mesh)); }),
              "a safe step is known for planar meshes only, but this is a surface in space");
}

} // namespace
} // namespace morph
