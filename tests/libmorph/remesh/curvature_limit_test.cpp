#include "libmorph/remesh/remesh.h"

#include "libmorph/geometry/mesh_domain.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "libmorph/remesh/bad_region.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace morph {
namespace {

Eigen::VectorXd uniform(const Mesh& mesh, double size)
{
    return Eigen::VectorXd::Constant(vertex_count(mesh), size);
}

/// Largest angle between edges that follow each other, in degrees; the marker is a closed loop in order.
double largest_turn(const MeshData& data, const Marker& marker)
{
    double largest = 0;
    for (std::size_t i = 0; i < marker.edges.size(); ++i) {
        const auto& [a, b] = marker.edges[i];
        const auto& [c, d] = marker.edges[(i + 1) % marker.edges.size()];
        const Eigen::RowVector3d p = data.points.row(b) - data.points.row(a);
        const Eigen::RowVector3d q = data.points.row(d) - data.points.row(c);
        largest = std::max(largest, std::atan2(std::abs(p[0] * q[1] - p[1] * q[0]), p.dot(q)));
    }
    return largest * 180 / std::numbers::pi;
}

/// The unit square with a round hole of a two-thousandth of it in the middle.
MeshData square_with_hole(double radius)
{
    DomainSpec spec;
    spec.box = {0, 0, 1, 1};
    spec.size = 0.05;
    spec.curves.push_back({"hole", test::round_curve(0.5, 0.5, radius), 40});
    return mesh_domain(spec);
}

TEST(CurveLimit, AHoleATwoThousandthOfTheBoxStaysRoundWhenEdgesAreAsked200TimesAsLong)
{
    constexpr double kRadius = 0.0005;
    const Mesh mesh = build_mesh(square_with_hole(kRadius));
    const MeshData data = remesh(mesh, uniform(mesh, 0.1)).data;
    const Mesh made = build_mesh(data);
    EXPECT_EQ(quality_report(made).inverted, 0);
    const std::vector<double> quality = triangle_qualities(made);
    EXPECT_GT(*std::min_element(quality.begin(), quality.end()), 0.5);
    // 30 degrees an edge, which may be 1.4 times as long as the target.
    const Marker& hole = *find_marker(data.markers, "hole");
    EXPECT_LT(largest_turn(data, hole), 1.4 * 30);
    EXPECT_LT(hole.edges.size(), 40U * 2 / 3); // it was coarsened as far as that allows
}

TEST(CurveLimit, LowersSizesToThirtyDegreesOfTheCircleAndLeavesThoseFarAway)
{
    constexpr double kRadius = 0.01, kSize = 0.03;
    const Mesh mesh = build_mesh(square_with_hole(kRadius));
    const Eigen::VectorXd sizes = remesh(mesh, uniform(mesh, kSize)).sizes;
    const auto place = points(mesh);
    for (Index v = 0; v < vertex_count(mesh); ++v) {
        const double away = (place.row(v) - Eigen::RowVector3d(0.5, 0.5, 0)).norm() - kRadius;
        const double limit = kRadius * std::numbers::pi / 6 + 0.2 * std::max(away, 0.0);
        // Paths along edges are longer than the straight line, by up to a third where triangles are thin.
        EXPECT_LE(sizes[v], std::min(kSize, 1.34 * limit));
        // The radius of curvature of the B-spline is down to 0.88 of that of the circle it is near.
        EXPECT_GE(sizes[v], std::min(kSize, 0.87 * limit));
    }
}

TEST(CurveLimit, AsksForNoMoreEdgesThanACoarsePolygonHas)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 8, 3)); // 45 degrees an edge
    const Eigen::VectorXd sizes = remesh(mesh, uniform(mesh, 5)).sizes;
    const double edge = 2 * std::sin(std::numbers::pi / 8);
    for (Index v = 0; v < vertex_count(mesh); ++v)
        EXPECT_GE(sizes[v], edge * (1 - 1e-12)); // rounding of the annulus's nodes
}

/// A closed cylinder of radius 1 and height 2 about the z axis.
MeshData cylinder(Index around)
{
    MeshData data;
    data.dimension = 3;
    const Index nodes = 2 * around + 2;
    data.points.resize(nodes, 3);
    for (Index i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * i / around;
        data.points.row(i) << std::cos(angle), std::sin(angle), 0;
        data.points.row(around + i) << std::cos(angle), std::sin(angle), 2;
    }
    data.points.row(nodes - 2) << 0, 0, 0;
    data.points.row(nodes - 1) << 0, 0, 2;
    for (Index i = 0; i < around; ++i) {
        const Index next = (i + 1) % around;
        data.elements.push_back({i, next, around + next, -1});
        data.elements.push_back({i, around + next, around + i, -1});
        data.elements.push_back({nodes - 2, next, i, -1});
        data.elements.push_back({nodes - 1, around + i, around + next, -1});
    }
    return data;
}

TEST(CurveLimit, KeepsTheRimsOfACylinderRound)
{
    const Mesh mesh = build_mesh(cylinder(48));
    const Points made = remesh(mesh, uniform(mesh, 2)).data.points;
    for (const double height : {0.0, 2.0}) {
        Index on_rim = 0;
        for (Index v = 0; v < made.rows(); ++v)
            on_rim += made(v, 2) == height && made.row(v).head<2>().norm() > 0.99 ? 1 : 0;
        EXPECT_GE(on_rim, 9); // 30 degrees times 1.4
        EXPECT_LE(on_rim, 18);
    }
}

TEST(CurveLimit, TrianglesBesideKeptElementsAreNotFlatHoweverLongEdgesAreAsked)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 100, 20));
    RemeshSettings settings;
    for (Index f = 0; f < element_count(mesh); ++f) {
        const Element e = element_corners(mesh, f);
        double nearest = 3;
        for (const Index v : {e[0], e[1], e[2]})
            nearest = std::min(nearest, points(mesh).row(v).norm());
        settings.kept.push_back(nearest < 1.3);
    }
    const Mesh made = build_mesh(remesh(mesh, uniform(mesh, 1), settings).data);
    const std::vector<double> quality = triangle_qualities(made);
    EXPECT_GT(*std::min_element(quality.begin(), quality.end()), 0.5);
    EXPECT_LT(element_count(made), element_count(mesh) * 2 / 3);
}

} // namespace
} // namespace morph
