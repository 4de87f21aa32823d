#include "libmorph/remap/locate.h"

#include "libmorph/core/parallel.h"
#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/mesh_checks.h"
#include "tests/support/meshes.h"
#include "tests/support/random_meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace morph;
using ExactKernel = CGAL::Exact_predicates_exact_constructions_kernel;

/// Of the elements that hold each target the lowest in the file, by CGAL's exact polygons, one after the
/// other.
std::vector<Index> brute_force(const MeshData& mesh, const Points& targets)
{
    std::vector<CGAL::Polygon_2<ExactKernel>> polygons;
    for (const Element& element : mesh.elements) {
        auto& polygon = polygons.emplace_back();
        for (int k = 0; k < corner_count(element); ++k) {
            const Index v = element[static_cast<std::size_t>(k)];
            polygon.push_back({mesh.points(v, 0), mesh.points(v, 1)});
        }
    }
    std::vector<Index> lowest(static_cast<std::size_t>(targets.rows()), -1);
    for (Index i = 0; i < targets.rows(); ++i)
        for (std::size_t e = 0; e < polygons.size(); ++e)
            if (!polygons[e].has_on_unbounded_side({targets(i, 0), targets(i, 1)})) {
                lowest[static_cast<std::size_t>(i)] = static_cast<Index>(e);
                break;
            }
    return lowest;
}

/// Elements as the file numbers them.
std::vector<Index> file_elements(const Mesh& mesh, const std::vector<Index>& faces)
{
    std::vector<Index> elements;
    for (const Index face : faces)
        elements.push_back(face < 0 ? -1 : mesh.numbering.element[static_cast<std::size_t>(face)]);
    return elements;
}

std::vector<Index> located(const MeshData& data, const Points& targets)
{
    const Mesh mesh = build_mesh(data);
    return file_elements(mesh, Locator(mesh).locate(targets).face);
}

TEST(Locator, AgreesWithExactPolygonsOnTenThousandRandomMeshes)
{
    std::mt19937 random(7);
    for (std::uint32_t seed = 1; seed <= 10000; ++seed) {
        const MeshData mesh = test::random_mesh(test::some_settings(seed));
        const Points targets = test::random_targets(mesh, 24, random);
        ASSERT_EQ(located(mesh, targets), brute_force(mesh, targets)) << "seed " << seed;
    }
}

TEST(Locator, FindsEveryVertexInTheFirstElementAroundIt)
{
    const MeshData mesh = test::uneven_square(40);
    std::vector<Index> first(static_cast<std::size_t>(mesh.points.rows()), -1);
    for (std::size_t e = mesh.elements.size(); e-- > 0;)
        for (const Index v : mesh.elements[e])
            if (v >= 0)
                first[static_cast<std::size_t>(v)] = static_cast<Index>(e);
    EXPECT_EQ(located(mesh, mesh.points), first);
}

TEST(Locator, FindsPointsOfADentedQuadAndNotThoseInItsDent)
{
    MeshData mesh;
    mesh.points.resize(4, 3);
    mesh.points << 0, 0, 0, 4, 0, 0, 1, 1, 0, 0, 4, 0; // dented at (1, 1)
    mesh.elements = {{0, 1, 2, 3}};
    Points targets(4, 3);
    targets << 0.9, 0.9, 0, 1, 1, 0, 1.5, 1.5, 0, 0.25, 3, 0;
    EXPECT_EQ(located(mesh, targets), brute_force(mesh, targets));
    EXPECT_EQ(located(mesh, targets), (std::vector<Index>{0, 0, -1, 0}));
}

TEST(Locator, PrefersTheFirstElementInTheFileWherePartsTouch)
{
    // Two unit squares of a quad each that touch along x = 1 without sharing a vertex.
    MeshData mesh;
    mesh.points.resize(8, 3);
    mesh.points << 1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    mesh.elements = {{4, 5, 6, 7}, {0, 1, 2, 3}};
    Points targets(3, 3);
    targets << 1, 0.5, 0, 1, 1, 0, 1.5, 1, 0;
    EXPECT_EQ(located(mesh, targets), (std::vector<Index>{0, 0, 1}));
    std::swap(mesh.elements[0], mesh.elements[1]);
    EXPECT_EQ(located(mesh, targets), (std::vector<Index>{0, 0, 0}));
}

TEST(Locator, GivesTheSameAnswerForAnyThreadCountAndAnyOrderOfTheFile)
{
    const MeshData data = test::annulus(1, 3, 90, 20);
    std::mt19937 random(3);
    const Points targets = test::random_targets(data, 20000, random);
    const Mesh mesh = build_mesh(data);
    set_thread_count(1);
    const ContainingElements one = Locator(mesh).locate(targets);
    set_thread_count(5);
    const ContainingElements five = Locator(mesh).locate(targets);
    set_thread_count(0);
    EXPECT_EQ(one.face, five.face);
    EXPECT_EQ(one.order, five.order);
    EXPECT_EQ(file_elements(mesh, one.face), located(data, targets));
}

TEST(Locator, RefusesTargetsOffThePlaneOrNotFinite)
{
    const Mesh mesh = build_mesh(test::uneven_square(2));
    const Locator locator(mesh);
    Points targets = Points::Constant(3, 3, 0.5);
    targets.col(2).setZero();
    targets(2, 2) = 0.25;
    EXPECT_EQ(test::message_of([&] { locator.locate(targets); }),
              "target 2 has z = 0.250000, but the source is planar, with z = 0");
    targets(1, 0) = NAN;
    EXPECT_EQ(test::message_of([&] { locator.locate(targets); }),
              "target 1 has a coordinate that is not finite");
}

TEST(Locator, FindsNothingInAMeshWithoutElements)
{
    MeshData data;
    data.points = Points::Zero(1, 3);
    EXPECT_EQ(located(data, data.points), (std::vector<Index>{-1}));
}

} // namespace
