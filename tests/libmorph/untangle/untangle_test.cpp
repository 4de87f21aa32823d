#include "libmorph/untangle/untangle.h"

#include "formats/formats.h"
#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace morph;

std::vector<Index> boundary_vertices(const Mesh& mesh)
{
    std::vector<Index> list;
    for (const VertexHandle v : mesh.kernel.vertices())
        if (mesh.kernel.is_boundary(v))
            list.push_back(v.idx());
    return list;
}

/// Every corner turns left, by a predicate that libmorph does not use for this.
bool every_corner_turns_left(const Mesh& mesh, const Points& x)
{
    using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto point = [&](Index v) { return Exact::Point_2(x(v, 0), x(v, 1)); };
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        const auto n = static_cast<std::size_t>(corner_count(e));
        for (std::size_t k = 0; k < n; ++k)
            if (CGAL::orientation(point(e[(k + n - 1) % n]), point(e[k]), point(e[(k + 1) % n])) !=
                CGAL::LEFT_TURN)
                return false;
    }
    return true;
}

void shake(const std::vector<Index>& held, double size, Points& x)
{
    std::vector<bool> still(static_cast<std::size_t>(x.rows()));
    for (const Index v : held)
        still[static_cast<std::size_t>(v)] = true;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-size, size);
    for (Index v = 0; v < x.rows(); ++v)
        if (!still[static_cast<std::size_t>(v)])
            x.row(v).head<2>() += Eigen::RowVector2d(uniform(random), uniform(random));
}

void expect_held(const std::vector<Index>& held, const Points& before, const Points& after)
{
    for (const Index v : held)
        EXPECT_EQ(before.row(v), after.row(v)) << v;
}

/// Triangles and quads in turn, row by row.
MeshData hybrid_square(Index cells)
{
    MeshData data = test::quad_square(cells);
    std::vector<Element> elements;
    for (std::size_t f = 0; f < data.elements.size(); ++f) {
        const auto [a, b, c, d] = data.elements[f];
        if (f % 3 == 0) {
            elements.push_back({a, b, c, -1});
            elements.push_back({a, c, d, -1});
        } else
            elements.push_back(data.elements[f]);
    }
    data.elements = elements;
    return data;
}

/// The test case of de Boer, van der Schoot and Bijl: a block of 5 x 1 cells in the middle of a unit square
/// of 25 x 25 quads.
MeshData square_around_a_block()
{
    constexpr Index cells = 25;
    MeshData data;
    std::vector<Index> number(static_cast<std::size_t>(cells + 1) * (cells + 1), -1);
    std::vector<std::array<double, 2>> places;
    const auto vertex = [&](Index i, Index j) {
        Index& known = number[static_cast<std::size_t>(j) * (cells + 1) + static_cast<std::size_t>(i)];
        if (known < 0) {
            known = static_cast<Index>(places.size());
            places.push_back({static_cast<double>(i) / cells, static_cast<double>(j) / cells});
        }
        return known;
    };
    for (Index j = 0; j < cells; ++j)
        for (Index i = 0; i < cells; ++i)
            if (j != 12 || i < 10 || i >= 15)
                data.elements.push_back(
                    {vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    data.points = Points::Zero(static_cast<Index>(places.size()), 3);
    for (Index v = 0; v < data.points.rows(); ++v)
        data.points.row(v).head<2>() << places[static_cast<std::size_t>(v)][0],
            places[static_cast<std::size_t>(v)][1];
    return data;
}

TEST(Untangle, LeavesAValidMeshAsItIsBitForBit)
{
    const Mesh mesh = build_mesh(test::quad_square(6));
    Points x = points(mesh);
    const UntangleResult result = untangle(mesh, points(mesh), boundary_vertices(mesh), x);
    EXPECT_TRUE(result.valid);
    EXPECT_EQ(result.patch_vertices, 0);
    EXPECT_EQ(x, Points(points(mesh)));
}

TEST(Untangle, LeavesARigidMotionOfEverythingAsItIs)
{
    const Mesh mesh = build_mesh(test::uneven_square(6));
    Points x = points(mesh);
    const Eigen::Rotation2D<double> turn(2.0);
    for (Index v = 0; v < x.rows(); ++v)
        x.row(v).head<2>() = (turn * x.row(v).head<2>().transpose() + Eigen::Vector2d(3, -1)).transpose();
    const Points moved = x;
    EXPECT_TRUE(untangle(mesh, points(mesh), boundary_vertices(mesh), x).valid);
    EXPECT_EQ(x, moved);
}

TEST(Untangle, RepairsShakenMeshesAndDoesNotMoveHeldVertices)
{
    constexpr Index cells = 20;
    for (const MeshData& data :
         {test::uneven_square(cells), test::quad_square(cells), hybrid_square(cells)}) {
        const Mesh mesh = build_mesh(data);
        const auto held = boundary_vertices(mesh);
        Points x = points(mesh);
        shake(held, 0.5 / cells, x);
        const Points before = x;
        ASSERT_FALSE(every_corner_turns_left(mesh, x));
        const UntangleResult result = untangle(mesh, points(mesh), held, x);
        EXPECT_TRUE(result.valid);
        EXPECT_TRUE(result.inverted.empty());
        EXPECT_TRUE(every_corner_turns_left(mesh, x));
        expect_held(held, before, x);
        EXPECT_TRUE((x.col(2).array() == 0).all());
    }
}

TEST(Untangle, FindsTheUndeformedMeshAgainInsideAnUnmovedBoundary)
{
    const Mesh mesh = build_mesh(test::uneven_square(12));
    const auto held = boundary_vertices(mesh);
    Points x = points(mesh);
    shake(held, 0.06, x);
    ASSERT_TRUE(untangle(mesh, points(mesh), held, x).valid);
    // It stops when the energy has settled to 1e-4, and the energy is quadratic about its minimum.
    EXPECT_LT((x - points(mesh)).rowwise().norm().maxCoeff(), 0.05 / 12);
}

TEST(Untangle, MovesNothingFarFromTheInvertedElements)
{
    const Mesh mesh = build_mesh(test::uneven_square(60));
    Points x = points(mesh);
    Index middle = 0;
    (x.rowwise() - Eigen::RowVector3d(0.5, 0.5, 0)).rowwise().norm().minCoeff(&middle);
    x(middle, 0) += 0.04;
    const Points before = x;
    const UntangleResult result = untangle(mesh, points(mesh), {}, x);
    EXPECT_TRUE(result.valid);
    Index moved = 0;
    for (Index v = 0; v < x.rows(); ++v) {
        moved += x.row(v) != before.row(v) ? 1 : 0;
        if ((before.row(v) - before.row(middle)).norm() > 0.6) {
            EXPECT_EQ(x.row(v), before.row(v));
        }
    }
    EXPECT_GT(moved, 0);
}

TEST(Untangle, MendsAQuadOfPositiveAreaWithOneDentedCorner)
{
    const Mesh mesh = build_mesh(test::quad_square(3));
    const auto held = boundary_vertices(mesh);
    Points x = points(mesh);
    for (const VertexHandle v : mesh.kernel.vertices())
        if (!mesh.kernel.is_boundary(v) && x(v.idx(), 0) < 0.5 && x(v.idx(), 1) < 0.5)
            x.row(v.idx()) << 0.1, 0.1, 0; // the element in the corner becomes a dart
    ASSERT_EQ(quality_report(mesh, x).negative_area, 0);
    ASSERT_GT(quality_report(mesh, x).inverted, 0);
    EXPECT_TRUE(untangle(mesh, points(mesh), held, x).valid);
    EXPECT_TRUE(every_corner_turns_left(mesh, x));
}

TEST(Untangle, ReachesThePublishedQualityAroundATurnedBlock)
{
    const Mesh mesh = build_mesh(square_around_a_block());
    const auto held = boundary_vertices(mesh);
    Points x = points(mesh);
    const Eigen::Rotation2D<double> turn(std::numbers::pi / 3);
    const Eigen::Vector2d centre(0.5, 0.5), shift(-0.2, -0.3);
    for (const Index v : held) {
        const Eigen::Vector2d from = x.row(v).head<2>().transpose() - centre;
        if (from.cwiseAbs().maxCoeff() < 0.4)
            x.row(v).head<2>() = (centre + turn * from + shift).transpose();
    }
    const Points before = x;
    const UntangleResult result = untangle(mesh, points(mesh), held, x);
    EXPECT_TRUE(result.valid);
    EXPECT_TRUE(every_corner_turns_left(mesh, x));
    expect_held(held, before, x);
    const QualityReport report = quality_report(mesh, x, points(mesh));
    EXPECT_GT(report.size_skew->min, 0.15);  // foldover-free as published: 0.146 and 0.793,
    EXPECT_GT(report.size_skew->mean, 0.79); // with the energy squared: 0.194 and 0.771
}

TEST(Untangle, RepairsAnInteriorThatWasLeftBehindAltogether)
{
    // The hole of a ring moves by half its radius and turns by 30 degrees; what is around it stays. VertexLists
    // around the tangle cannot give way that far.
    const Mesh mesh = build_mesh(test::annulus(1, 10, 60, 20));
    const auto held = boundary_vertices(mesh);
    Points x = points(mesh);
    const Eigen::Rotation2D<double> turn(std::numbers::pi / 6);
    for (const Index v : marker_vertices(marker(mesh, "inner")))
        x.row(v).head<2>() = (turn * x.row(v).head<2>().transpose() + Eigen::Vector2d(0.5, 0)).transpose();
    const Points before = x;
    ASSERT_FALSE(every_corner_turns_left(mesh, x));
    UntangleOptions options;
    options.rings = 1;
    EXPECT_TRUE(untangle(mesh, points(mesh), held, x, options).valid);
    EXPECT_TRUE(every_corner_turns_left(mesh, x));
    expect_held(held, before, x);
}

TEST(Untangle, RepairsRealMeshesWhoseBodyIsTurned)
{
    for (const char* name : {"naca0012_inv.su2", "naca0012_lam_hybrid.su2"}) {
        const Mesh mesh = build_mesh(read_mesh_data(test::data_path(std::string("meshes/") + name)));
        const auto held = boundary_vertices(mesh);
        Points x = points(mesh);
        const Eigen::Rotation2D<double> turn(std::numbers::pi / 9);
        const Eigen::Vector2d centre(0.5, 0);
        for (const Index v : marker_vertices(marker(mesh, "airfoil")))
            x.row(v).head<2>() = (centre + turn * (x.row(v).head<2>().transpose() - centre)).transpose();
        const Points before = x;
        ASSERT_FALSE(every_corner_turns_left(mesh, x));
        EXPECT_TRUE(untangle(mesh, points(mesh), held, x).valid) << name;
        EXPECT_TRUE(every_corner_turns_left(mesh, x)) << name;
        expect_held(held, before, x);
    }
}

TEST(Untangle, ReportsTheElementsThatHeldVerticesMakeHopeless)
{
    const Mesh mesh = build_mesh(test::uneven_square(8));
    std::vector<Index> held = boundary_vertices(mesh);
    Points x = points(mesh);
    shake(held, 0.06, x);
    // One element inside is held upside down.
    Index upside_down = -1;
    for (Index f = 0; f < element_count(mesh) && upside_down < 0; ++f) {
        const Element e = element_corners(mesh, f);
        if (std::none_of(e.begin(), e.begin() + 3,
                         [&](Index v) { return mesh.kernel.is_boundary(VertexHandle(v)); }))
            upside_down = f;
    }
    const Element e = element_corners(mesh, upside_down);
    x.row(e[0]) = points(mesh).row(e[1]);
    x.row(e[1]) = points(mesh).row(e[0]);
    x.row(e[2]) = points(mesh).row(e[2]);
    held.insert(held.end(), e.begin(), e.begin() + 3);
    const Points before = x;
    const UntangleResult result = untangle(mesh, points(mesh), held, x);
    EXPECT_FALSE(result.valid);
    EXPECT_EQ(result.unrepairable, std::vector<Index>{upside_down});
    EXPECT_TRUE(std::binary_search(result.inverted.begin(), result.inverted.end(), upside_down));
    EXPECT_EQ(result.inverted, inverted_elements(mesh, x));
    expect_held(held, before, x);
}

TEST(Untangle, RepairsTheRestBesideAHopelessElement)
{
    const Mesh mesh = build_mesh(test::uneven_square(8));
    std::vector<Index> held = boundary_vertices(mesh);
    Points x = points(mesh);
    shake(held, 0.06, x);
    // Flatten an element that has two vertices on the boundary onto it, and hold the third.
    Index flat = -1;
    for (Index f = 0; f < element_count(mesh) && flat < 0; ++f) {
        const Element e = element_corners(mesh, f);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto low = [&](std::size_t i) { return points(mesh)(e[(k + i) % 3], 1) == 0; };
            if (low(0) && low(1) && points(mesh)(e[k], 0) > 0.3 && points(mesh)(e[k], 0) < 0.6) {
                flat = f;
                x.row(e[(k + 2) % 3]) = 0.5 * (x.row(e[k]) + x.row(e[(k + 1) % 3]));
                held.push_back(e[(k + 2) % 3]);
                break;
            }
        }
    }
    ASSERT_GE(flat, 0);
    const UntangleResult result = untangle(mesh, points(mesh), held, x);
    EXPECT_EQ(result.unrepairable, std::vector<Index>{flat});
    EXPECT_EQ(result.inverted, std::vector<Index>{flat});
}

TEST(Untangle, RepairsTheRestWhereNoPlaceForAFreeVertexIsValid)
{
    const Mesh mesh = build_mesh(test::uneven_square(16));
    std::vector<Index> held = boundary_vertices(mesh);
    Points x = points(mesh);
    Index middle = 0;
    (x.rowwise() - Eigen::RowVector3d(0.5, 0.5, 0)).rowwise().norm().minCoeff(&middle);
    // The ring around a vertex is held and pushed together onto a line: no triangle in it can be positive,
    // but each has a vertex that is free.
    std::vector<Index> ring;
    for (const VertexHandle v : mesh.kernel.vv_range(VertexHandle(middle)))
        ring.push_back(v.idx());
    held.insert(held.end(), ring.begin(), ring.end());
    shake(held, 0.03, x);
    for (const Index v : ring)
        x(v, 1) = 0.5 + 0.01 * (x(v, 0) - 0.5);
    const UntangleResult result = untangle(mesh, points(mesh), held, x);
    EXPECT_FALSE(result.valid);
    EXPECT_EQ(result.inverted, inverted_elements(mesh, x));
    ring.push_back(middle);
    for (const Index f : result.inverted) {
        const Element e = element_corners(mesh, f);
        EXPECT_TRUE(std::any_of(e.begin(), e.begin() + 3, [&](Index v) {
            return std::find(ring.begin(), ring.end(), v) != ring.end();
        })) << f;
    }
}

TEST(Untangle, KeepsTheCopiesOfASplitVertexTogether)
{
    const Mesh mesh = build_mesh(test::touching_squares(6));
    std::vector<Index> copies;
    for (Index v = 0; v < vertex_count(mesh); ++v)
        if (std::hypot(points(mesh)(v, 0) - 1, points(mesh)(v, 1) - 1) < 1e-12)
            copies.push_back(v);
    ASSERT_EQ(copies.size(), 2U);
    std::vector<Index> held = boundary_vertices(mesh);
    std::erase_if(held, [&](Index v) { return v == copies[0] || v == copies[1]; });
    Points x = points(mesh);
    for (const Index v : copies)
        x.row(v) << 0.7, 0.7, 0;
    ASSERT_FALSE(every_corner_turns_left(mesh, x));
    EXPECT_TRUE(untangle(mesh, points(mesh), held, x).valid);
    EXPECT_EQ(x.row(copies[0]), x.row(copies[1]));

    Points same = points(mesh);
    for (const Index v : copies)
        same.row(v) << 0.7, 0.7, 0;
    held.push_back(copies[1]); // holding one holds both
    const Points before = same;
    static_cast<void>(untangle(mesh, points(mesh), held, same));
    expect_held(copies, before, same);
}

TEST(Untangle, GivesUpSoonerWithoutAFreshStart)
{
    // The hole has left the domain: there is no valid mesh to find.
    const Mesh mesh = build_mesh(test::uneven_annulus(0.5, 3, 30));
    const auto held = boundary_vertices(mesh);
    Points moved = points(mesh);
    for (const Index v : held)
        if (moved.row(v).norm() < 1)
            moved(v, 0) += 8;
    Points with = moved, without = moved;
    UntangleOptions options;
    const UntangleResult more = untangle(mesh, points(mesh), held, with, options);
    options.reinitialize = false;
    const UntangleResult less = untangle(mesh, points(mesh), held, without, options);
    EXPECT_FALSE(more.valid);
    EXPECT_FALSE(less.valid);
    EXPECT_LT(less.iterations, more.iterations / 2);
}

TEST(Untangle, IsTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = build_mesh(test::uneven_square(50));
    const auto held = boundary_vertices(mesh);
    Points shaken = points(mesh);
    shake(held, 0.3 / 50, shaken);
    ASSERT_FALSE(every_corner_turns_left(mesh, shaken));
    Points one = shaken, three = shaken;
    set_thread_count(1);
    const int iterations = untangle(mesh, points(mesh), held, one).iterations;
    set_thread_count(3);
    EXPECT_EQ(untangle(mesh, points(mesh), held, three).iterations, iterations);
    set_thread_count(0);
    EXPECT_EQ(one, three);
}

TEST(Untangle, RefusesWhatDoesNotFitTheMesh)
{
    Mesh mesh = build_mesh(test::quad_square(1));
    Points x = points(mesh);
    const Points few = Points::Zero(3, 3);
    EXPECT_EQ(test::message_of([&] { untangle(mesh, few, {}, x); }),
              "the matrix of reference positions has 3 rows, but the mesh has 4 vertices");
    EXPECT_EQ(test::message_of([&] { untangle(mesh, points(mesh), {4}, x); }),
              "held vertex 4 is out of range, there are 4 vertices");
    UntangleOptions options;
    options.exponent = 0.5;
    EXPECT_EQ(
        test::message_of([&] { untangle(mesh, points(mesh), {}, x, options); }),
        "the energy of untangling has the size weight 2.000000 and the exponent 0.500000, but they must be "
        "at least 0 and 1");
    options = {};
    options.rings = 0;
    EXPECT_EQ(test::message_of([&] { untangle(mesh, points(mesh), {}, x, options); }),
              "untangling was asked to use 0 rings and 200 iterations, but both must be at least 1");
    x(2, 1) = std::nan("");
    EXPECT_EQ(test::message_of([&] { untangle(mesh, points(mesh), {}, x); }),
              "the matrix of positions is not finite everywhere");
    x = points(mesh);
    mesh.dimension = 3;
    EXPECT_EQ(test::message_of([&] { untangle(mesh, points(mesh), {}, x); }),
              "untangling needs a planar mesh, but this is a surface in space");
}

} // namespace
