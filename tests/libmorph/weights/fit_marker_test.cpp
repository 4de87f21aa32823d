#include "formats/formats.h"
#include "libmorph/basis/closest.h"
#include "libmorph/core/error.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/weights/fit_marker.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace morph;
using test::message_of;
using testing::HasSubstr;

Mesh real_mesh(const std::string& name)
{
    return read_mesh(test::data_path("meshes/" + name + ".su2"));
}

/// A body of a real mesh, and how near 12 and 20 control points must come; the bodies have a size of 1.
struct Body {
    std::string mesh;
    std::vector<std::string> markers;
    std::size_t corners;
    double with_12;
    double with_20;
};

const std::vector<Body> kBodies{
    {"naca0012_inv", {"airfoil"}, 1, 1e-3, 1e-4},
    {"naca0012_lam_hybrid", {"airfoil"}, 1, 1e-3, 1e-4},
    {"rae2822_turb", {"AIRFOIL"}, 1, 1.5e-3, 3e-4},
    {"cylinder_lam", {"cylinder"}, 0, 3e-4, 3e-4}, // its nodes lie 2e-4 off a circle
    {"naca0012_multiffd", {"airfoil_lower", "airfoil_upper"}, 0, 1e-4, 1e-5},
};

void expect_fitted(const Mesh& mesh, const FittedMarker& fitted, const Body& body, double tolerance)
{
    EXPECT_LE(fitted.fit.max_distance, tolerance) << body.mesh;
    EXPECT_LE(fitted.fit.mean_distance, fitted.fit.max_distance);
    EXPECT_EQ(fitted.corner_ids.size(), body.corners) << body.mesh;
    EXPECT_EQ(fitted.fit.curve.closed, fitted.chain.closed);
    const Points2 nodes = points(mesh)(fitted.chain.vertices, {0, 1});
    double largest = 0;
    for (const CurveParameter& place : node_parameters(Curve(fitted.fit.curve), nodes, fitted.chain.closed))
        largest = std::max(largest, place.distance);
    EXPECT_EQ(largest, fitted.fit.max_distance);
}

TEST(FitMarker, FitsTheBodiesOfRealMeshesWithoutACrossing)
{
    for (const Body& body : kBodies) {
        const Mesh mesh = real_mesh(body.mesh);
        for (const Index points : {12, 20}) {
            std::vector<FittedMarker> all;
            for (const std::string& name : body.markers)
                all.push_back(fit_marker(mesh, name, {.control_points = points}));
            for (const FittedMarker& fitted : all)
                expect_fitted(mesh, fitted, body, points == 12 ? body.with_12 : body.with_20);
            EXPECT_TRUE(fitted_crossings(all).empty()) << body.mesh;
        }
    }
}

TEST(FitMarker, NamesCornersByTheNumbersOfTheFile)
{
    const Mesh mesh = real_mesh("wedge");
    const auto corners = [&](double angle) {
        return fit_marker(mesh, "lower", {.corner_angle = angle}).corner_ids;
    };
    ASSERT_EQ(corners(5).size(), 1U) << "the ramp of 10 degrees";
    const MeshData data = to_mesh_data(mesh);
    EXPECT_NEAR(data.points(corners(5)[0], 0), 0.5, 1e-12) << "where the ramp begins";
    EXPECT_TRUE(corners(15).empty());
}

TEST(FitMarker, RefusesWhatHasNoCurveAndNamesTheMarker)
{
    const Mesh mesh = real_mesh("naca0012_inv");
    EXPECT_THAT(message_of([&] { fit_marker(mesh, "airfiol"); }), HasSubstr("did you mean 'airfoil'?"));
    EXPECT_THAT(message_of([&] { fit_marker(mesh, "airfoil", {.control_points = 201}); }),
                HasSubstr("marker 'airfoil': "));

    MeshData data = test::uneven_square(4);
    data.dimension = 3;
    data.points.col(2).setConstant(0.5);
    EXPECT_THAT(message_of([&] { fit_marker(build_mesh(data), "bottom"); }), HasSubstr("surface in space"));

    data = test::uneven_square(4);
    data.markers[0].edges.push_back({2, 7});
    EXPECT_THAT(message_of([&] { fit_marker(build_mesh(data), "bottom"); }),
                HasSubstr("branches at vertex 2"));
}

FittedMarker polygon(const std::string& name, const Points2& corners)
{
    FittedMarker fitted{name, {}, {}, {}};
    fitted.fit.curve.degree = 1;
    fitted.fit.curve.closed = false;
    fitted.fit.curve.control_points = corners;
    return fitted;
}

TEST(FitMarker, FindsCurvesThatCrossThemselvesAndEachOther)
{
    Points2 loop(4, 2), line(2, 2), far(2, 2);
    loop << 0, 0, 2, 2, 2, 0, 0, 2; // crosses itself at (1, 1)
    line << -1, 0.5, 0.75, 0.5;     // and this at (0.5, 0.5)
    far << 5, 0, 5, 1;
    const std::vector<FittedCrossing> found =
        fitted_crossings({polygon("far", far), polygon("loop", loop), polygon("line", line)});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].first, 1);
    EXPECT_EQ(found[0].second, 1);
    EXPECT_NEAR((found[0].crossing.point - Eigen::Vector2d(1, 1)).norm(), 0, 1e-6);
    EXPECT_EQ(found[1].first, 1);
    EXPECT_EQ(found[1].second, 2);
    EXPECT_NEAR((found[1].crossing.point - Eigen::Vector2d(0.5, 0.5)).norm(), 0, 1e-6);
}

} // namespace
