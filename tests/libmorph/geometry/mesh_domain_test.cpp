#include "libmorph/geometry/mesh_domain.h"

#include "libmorph/basis/closest.h"
#include "libmorph/core/error.h"
#include "tests/support/curves.h"
#include "tests/support/domains.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

namespace morph {
namespace {

using namespace test;

// A node that the refinement adds has C(u) for some u; finding u again costs a Newton iteration that
// ends within a few units of roundoff of the coordinates (up to 25 here).
constexpr double kOnCurve = 1e-12;

// Areas are sums of some thousand terms of the size of the box.
constexpr double kAreaTolerance = 1e-12;

struct NamedSpec {
    std::string name;
    DomainSpec spec;
};

std::vector<NamedSpec> domains()
{
    const double gap = 0.01;
    double reach = 0; // of the round curve, to the right
    const Curve round = round_curve(0, 0, 1);
    for (int i = 0; i < 1000; ++i)
        reach = std::max(reach, round.point(i / 1000.0).x());
    return {
        {"thesis case 1", thesis_case(1)},
        {"thesis case 2", thesis_case(2)},
        {"clockwise curve", {kThesisBox, 1.0, {{"body", clockwise(Curve(test::thesis_case_1())), 100}}}},
        {"sharp trailing edge", {{-10, -10, 10, 10}, 2, {{"airfoil", sharp_airfoil(), 120}}}},
        {"tiny curve in a large box", {{-1e4, -1e4, 1e4, 1e4}, 2e3, {{"dot", round, 40}}}},
        {"two near bodies",
         {{-5, -5, 5, 5}, 1, {{"left", round, 40}, {"right", round_curve(2 * reach + gap, 0, 1), 40}}}},
        {"box coarser than itself", {kThesisBox, 1000, {{"body", Curve(test::thesis_case_1()), 100}}}},
        {"curve coarser than the box", {kThesisBox, 0.5, {{"body", Curve(test::thesis_case_1()), 3}}}},
        {"small corner", {{-5, -5, 5, 5}, 1, {{"notched", notched_square(), 60}}}},
        {"polygon whose corners are no nodes", {{-5, -5, 5, 5}, 1, {{"notched", notched_square(), 37}}}},
        {"empty box", {{0, 0, 3, 1}, 0.1, {}}},
        {"millimetres", {{-1e-3, -1e-3, 2e-3, 1e-3}, 2e-4, {{"dot", round_curve(0, 0, 1e-4), 40}}}},
    };
}

Eigen::Vector2d vertex(const MeshData& mesh, Index v)
{
    return mesh.points.row(v).head<2>();
}

double twice_area(const MeshData& mesh, const Element& e)
{
    const Eigen::Vector2d a = vertex(mesh, e[1]) - vertex(mesh, e[0]);
    const Eigen::Vector2d b = vertex(mesh, e[2]) - vertex(mesh, e[0]);
    return a.x() * b.y() - a.y() * b.x();
}

double smallest_angle(const MeshData& mesh, const Element& e)
{
    double smallest = 180;
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector2d a = (vertex(mesh, e[(i + 1) % 3]) - vertex(mesh, e[i])).normalized();
        const Eigen::Vector2d b = (vertex(mesh, e[(i + 2) % 3]) - vertex(mesh, e[i])).normalized();
        smallest = std::min(smallest, std::acos(std::clamp(a.dot(b), -1.0, 1.0)) * 180 / std::numbers::pi);
    }
    return smallest;
}

using DirectedEdge = std::array<Index, 2>;

/// The edges that belong to one element only, directed as in it.
std::set<DirectedEdge> boundary_edges(const MeshData& mesh)
{
    std::set<DirectedEdge> edges;
    for (const Element& e : mesh.elements)
        for (int i = 0; i < 3; ++i) {
            const DirectedEdge edge = {e[i], e[(i + 1) % 3]};
            if (edges.erase({edge[1], edge[0]}) == 0) {
                EXPECT_TRUE(edges.insert(edge).second)
                    << "edge " << edge[0] << " " << edge[1] << " occurs twice";
            }
        }
    return edges;
}

class EveryDomain : public testing::TestWithParam<NamedSpec> {
protected:
    const DomainSpec& spec() const { return GetParam().spec; }
    const MeshData mesh_ = mesh_domain(GetParam().spec);
};

TEST_P(EveryDomain, HasTheNodesAskedForBitForBit)
{
    for (std::size_t c = 0; c < spec().curves.size(); ++c) {
        const DomainCurve& curve = spec().curves[c];
        std::set<std::array<double, 2>> nodes;
        for (const auto& [from, to] : mesh_.markers[c].edges)
            nodes.insert({mesh_.points(from, 0), mesh_.points(from, 1)});
        for (Index i = 0; i < curve.nodes; ++i) {
            const Eigen::Vector2d x = curve.curve.point(static_cast<double>(i) / curve.nodes);
            EXPECT_TRUE(nodes.contains({x.x(), x.y()})) << curve.name << " node " << i;
        }
    }
}

TEST_P(EveryDomain, PutsEveryNodeOfACurveOnTheCurve)
{
    for (std::size_t c = 0; c < spec().curves.size(); ++c)
        for (const auto& [from, to] : mesh_.markers[c].edges) {
            const Eigen::Vector2d x = vertex(mesh_, from);
            EXPECT_LE(closest_parameter(spec().curves[c].curve, x).distance, kOnCurve * (1 + x.norm()));
        }
}

TEST_P(EveryDomain, PutsEveryNodeOfTheFarfieldOnTheBox)
{
    const auto& [xmin, ymin, xmax, ymax] = spec().box;
    double length = 0;
    for (const auto& [from, to] : mesh_.markers.back().edges) {
        const Eigen::Vector2d x = vertex(mesh_, from);
        EXPECT_TRUE(x.x() == xmin || x.x() == xmax || x.y() == ymin || x.y() == ymax) << x.transpose();
        length += (vertex(mesh_, to) - x).norm();
    }
    EXPECT_NEAR(length, 2 * (xmax - xmin + ymax - ymin), 1e-12 * length);
}

TEST_P(EveryDomain, HasOnlyTrianglesOfPositiveArea)
{
    EXPECT_EQ(mesh_.dimension, 2);
    EXPECT_TRUE((mesh_.points.col(2).array() == 0).all());
    for (const Element& e : mesh_.elements) {
        ASSERT_EQ(e[3], -1);
        EXPECT_GT(twice_area(mesh_, e), 0);
    }
}

TEST_P(EveryDomain, HasTheTopologyOfABoxWithHoles)
{
    std::set<DirectedEdge> edges;
    std::set<Index> used;
    for (const Element& e : mesh_.elements)
        for (int i = 0; i < 3; ++i) {
            used.insert(e[i]);
            edges.insert({std::min(e[i], e[(i + 1) % 3]), std::max(e[i], e[(i + 1) % 3])});
        }
    EXPECT_EQ(static_cast<Eigen::Index>(used.size()), mesh_.points.rows()) << "a vertex of no element";
    const auto euler = static_cast<long>(used.size()) - static_cast<long>(edges.size()) +
                       static_cast<long>(mesh_.elements.size());
    EXPECT_EQ(euler, 1 - static_cast<long>(spec().curves.size()));
}

TEST_P(EveryDomain, CoversTheBoxWithoutThePolygons)
{
    double meshed = 0;
    for (const Element& e : mesh_.elements)
        meshed += twice_area(mesh_, e) / 2;
    const double box = (spec().box[2] - spec().box[0]) * (spec().box[3] - spec().box[1]);
    double expected = box;
    for (std::size_t c = 0; c < spec().curves.size(); ++c) {
        double twice = 0; // the hole is on the right of its edges
        const Eigen::Vector2d origin = vertex(mesh_, mesh_.markers[c].edges.front()[0]);
        for (const auto& [from, to] : mesh_.markers[c].edges) {
            const Eigen::Vector2d a = vertex(mesh_, from) - origin;
            const Eigen::Vector2d b = vertex(mesh_, to) - origin;
            twice += a.y() * b.x() - a.x() * b.y();
        }
        EXPECT_GT(twice, 0) << spec().curves[c].name;
        expected -= twice / 2;
    }
    EXPECT_NEAR(meshed, expected, kAreaTolerance * box);
}

TEST_P(EveryDomain, HasNoSmallAngleAwayFromSmallCorners)
{
    const bool notched = GetParam().name.find("corner") != std::string::npos;
    for (const Element& e : mesh_.elements) {
        // The tip of the notch; its two edges are a sixtieth to a thirty-seventh of the period long.
        const double from_tip = (vertex(mesh_, e[0]) - Eigen::Vector2d(0, 0.95)).norm();
        if (!notched || from_tip > 0.6) {
            EXPECT_GE(smallest_angle(mesh_, e), kMinMeshAngle) << vertex(mesh_, e[0]).transpose();
        }
    }
}

TEST_P(EveryDomain, ListsEveryBoundaryEdgeOnceWithTheDomainOnItsLeft)
{
    std::set<DirectedEdge> marked;
    ASSERT_EQ(mesh_.markers.size(), spec().curves.size() + 1);
    EXPECT_EQ(mesh_.markers.back().name, kFarfield);
    for (const Marker& marker : mesh_.markers)
        for (std::size_t i = 0; i < marker.edges.size(); ++i) {
            EXPECT_TRUE(marked.insert(marker.edges[i]).second);
            EXPECT_EQ(marker.edges[i][1], marker.edges[(i + 1) % marker.edges.size()][0]) << marker.name;
        }
    EXPECT_EQ(marked, boundary_edges(mesh_));
}

TEST_P(EveryDomain, NumbersCurvesFirstThenTheBoxThenTheInside)
{
    Index next = 0;
    for (const Marker& marker : mesh_.markers) {
        std::set<Index> vertices;
        for (const auto& [from, to] : marker.edges)
            vertices.insert(from);
        EXPECT_EQ(*vertices.begin(), next) << marker.name;
        EXPECT_EQ(static_cast<std::size_t>(*vertices.rbegin() - next + 1), vertices.size()) << marker.name;
        next += static_cast<Index>(vertices.size());
    }
}

TEST_P(EveryDomain, GradesEdgeLengthsSmoothly)
{
    // An angle of at least 25 degrees bounds the ratio within a triangle by 1 / sin(25) = 2.37; two
    // triangles apart it could be the square of that. Graded meshes stay far below on average.
    double log_sum = 0;
    for (const Element& e : mesh_.elements) {
        double shortest = std::numeric_limits<double>::infinity();
        double longest = 0;
        for (int i = 0; i < 3; ++i) {
            const double length = (vertex(mesh_, e[(i + 1) % 3]) - vertex(mesh_, e[i])).norm();
            shortest = std::min(shortest, length);
            longest = std::max(longest, length);
        }
        log_sum += std::log(longest / shortest);
    }
    EXPECT_LT(std::exp(log_sum / static_cast<double>(mesh_.elements.size())), 1.6);
}

TEST_P(EveryDomain, ComesOutTheSameBitForBit)
{
    const MeshData again = mesh_domain(spec());
    EXPECT_EQ(again.points, mesh_.points);
    EXPECT_EQ(again.elements, mesh_.elements);
}

INSTANTIATE_TEST_SUITE_P(MeshDomain, EveryDomain, testing::ValuesIn(domains()), [](const auto& domain) {
    std::string name = domain.param.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
});

TEST(MeshDomain, KeepsTheNumberOfNodesOfTheThesisCases)
{
    for (const int number : {1, 2})
        for (const Marker& marker : mesh_domain(thesis_case(number)).markers)
            EXPECT_TRUE(marker.name == kFarfield || marker.edges.size() == 100) << marker.name;
}

TEST(MeshDomain, KeepsCornersThatAreNoNodes)
{
    // 7 nodes at equal steps miss the corners of the square but for the first.
    const Curve square = closed_curve(1, {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    const MeshData mesh = mesh_domain({{-5, -5, 5, 5}, 1, {{"square", square, 7}}});
    double hole = 0;
    for (const auto& [from, to] : mesh.markers[0].edges)
        hole -= (mesh.points(from, 0) * mesh.points(to, 1) - mesh.points(from, 1) * mesh.points(to, 0)) / 2;
    EXPECT_NEAR(hole, 4, 4 * kAreaTolerance);
}

TEST(MeshDomain, AddsNodesWhereBodiesComeNearerThanTheirNodes)
{
    const DomainSpec near = domains()[5].spec;
    const MeshData mesh = mesh_domain(near);
    EXPECT_GT(mesh.markers[0].edges.size(), 40U);
    EXPECT_GT(mesh.markers[1].edges.size(), 40U);
}

TEST(MeshDomain, HasTheWantedEdgeLengthOnTheBoxAndFarFromCurves)
{
    for (const double size : {0.5, 0.05}) {
        const MeshData mesh = mesh_domain({{0, 0, 10, 10}, size, {}});
        double edges = 0;
        double length = 0;
        for (const Element& e : mesh.elements)
            for (int i = 0; i < 3; ++i) {
                length += (vertex(mesh, e[(i + 1) % 3]) - vertex(mesh, e[i])).norm();
                edges += 1;
            }
        // On average, that is: Delaunay refinement leaves edges of 0.6 to 1.6 times the size.
        EXPECT_NEAR(length / edges, size, 0.15 * size);
        EXPECT_EQ(static_cast<double>(mesh.markers[0].edges.size()), 40 / size);
    }
}

TEST(MeshDomain, ScalesWithTheUnitOfLength)
{
    // Powers of two scale every intermediate result without rounding.
    const DomainSpec metres = thesis_case(2);
    for (const double unit : {std::ldexp(1.0, 20), std::ldexp(1.0, -20)}) {
        DomainSpec scaled = metres;
        for (double& x : scaled.box)
            x *= unit;
        scaled.size *= unit;
        for (DomainCurve& curve : scaled.curves)
            curve.curve = curve.curve.with_control_points(curve.curve.definition().control_points * unit);
        const MeshData mesh = mesh_domain(scaled);
        EXPECT_EQ(mesh.elements, mesh_domain(metres).elements) << unit;
    }
}

} // namespace
} // namespace morph
