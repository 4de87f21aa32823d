#include "libmorph/remesh/near_marker.h"

#include "libmorph/mesh/builder.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace morph {
namespace {

TEST(NearMarker, FindsTheElementsWithAVertexInsideALargerCircle)
{
    constexpr Index kAround = 64;
    const Mesh mesh = build_mesh(test::annulus(1, 3, kAround, 12));
    const double inner = std::cos(std::acos(-1) / kAround); // the polygon's middle of an edge
    for (const double distance : {0.0, 0.21, 0.9}) {
        const std::vector<bool> found = elements_near(mesh, marker(mesh, "inner"), distance);
        for (Index f = 0; f < element_count(mesh); ++f) {
            double nearest = 3;
            for (const Index v : element_corners(mesh, f))
                if (v >= 0)
                    nearest = std::min(nearest, points(mesh).row(v).norm());
            // The distance to the polygon is between those to the circles around and in it.
            const bool is_near = found[static_cast<std::size_t>(f)];
            EXPECT_TRUE(is_near || nearest > inner + distance);
            EXPECT_TRUE(!is_near || nearest <= 1 + distance + 1e-12);
        }
    }
}

TEST(NearMarker, MeasuresOnASurfaceInSpaceAndToTheMiddleOfLongEdges)
{
    MeshData data = test::uneven_square(20);
    data.dimension = 3;
    data.points.col(2) = 2 * data.points.col(0); // the plane z = 2 x
    const Mesh mesh = build_mesh(data);
    const auto vertex_at = [&](const Eigen::RowVector3d& place) {
        Index nearest = 0;
        (points(mesh).rowwise() - place).rowwise().norm().minCoeff(&nearest);
        return nearest;
    };
    const Marker across{"across", {{vertex_at({0, 0, 0}), vertex_at({1, 0, 2})}}}; // y = 0, in one edge
    constexpr double kDistance = 0.3;
    const std::vector<bool> found = elements_near(mesh, across, kDistance);
    for (Index f = 0; f < element_count(mesh); ++f) {
        double nearest = 1;
        for (const Index v : element_corners(mesh, f))
            if (v >= 0)
                nearest = std::min(nearest, points(mesh)(v, 1));
        EXPECT_EQ(found[static_cast<std::size_t>(f)], nearest <= kDistance);
    }
    const std::vector<bool> none = elements_near(mesh, {"empty", {}}, kDistance);
    EXPECT_EQ(std::count(none.begin(), none.end(), true), 0);
}

TEST(NearMarker, MarksTheElementsOfAllZonesBesidesThoseMarked)
{
    const Mesh mesh = build_mesh(test::annulus(1, 3, 40, 10));
    std::vector<bool> kept;
    keep_zones(mesh, {}, kept);
    EXPECT_TRUE(kept.empty());
    keep_zones(mesh, {{"inner", 0.3}, {"outer", 0}}, kept);
    const std::vector<bool> inner = elements_near(mesh, marker(mesh, "inner"), 0.3);
    const std::vector<bool> outer = elements_near(mesh, marker(mesh, "outer"), 0);
    ASSERT_EQ(kept.size(), inner.size());
    for (std::size_t f = 0; f < kept.size(); ++f)
        EXPECT_EQ(kept[f], inner[f] || outer[f]);
    std::vector<bool> all(inner.size(), true);
    keep_zones(mesh, {{"inner", 0.3}}, all);
    EXPECT_EQ(std::count(all.begin(), all.end(), false), 0);
    EXPECT_NE(test::message_of([&] {
                  keep_zones(mesh, {{"iner", 0.1}}, kept);
              }).find("did you mean 'inner'"),
              std::string::npos);
}

} // namespace
} // namespace morph
