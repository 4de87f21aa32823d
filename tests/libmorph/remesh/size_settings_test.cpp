#include "libmorph/remesh/size_settings.h"

#include "libmorph/mesh/builder.h"
#include "libmorph/remesh/target_size.h"
#include "tests/support/errors.h"
#include "tests/support/meshes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace morph {
namespace {

using test::message_of;
using testing::HasSubstr;

/// The uneven square with a nodal field.
MeshData square_with(const std::string& name, Index cells, const std::function<double(double, double)>& value)
{
    MeshData mesh = test::uneven_square(cells);
    Field field{name, FieldLocation::vertex, Matrix(mesh.points.rows(), 1)};
    for (Index v = 0; v < mesh.points.rows(); ++v)
        field.values(v, 0) = value(mesh.points(v, 0), mesh.points(v, 1));
    mesh.fields.push_back(std::move(field));
    return mesh;
}

double growing(double x, double)
{
    return 0.1 + x / 10; // slowly enough for every gradation
}

double front(double x, double y)
{
    return std::tanh((std::hypot(x, y) - 0.7) / 0.03);
}

double steepest(const Mesh& mesh, const Eigen::VectorXd& sizes)
{
    double slope = 0;
    for (const auto edge : mesh.kernel.edges()) {
        const Index a = edge.v0().idx(), b = edge.v1().idx();
        slope = std::max(slope,
                         std::abs(sizes[a] - sizes[b]) / (points(mesh).row(a) - points(mesh).row(b)).norm());
    }
    return slope;
}

TEST(SizeSettings, AreTheEdgesOfTheMeshUnlessTheyNameAnotherSource)
{
    const Mesh mesh = build_mesh(square_with("h", 10, growing));
    EXPECT_EQ(target_sizes(mesh, {}), current_sizes(mesh));
    EXPECT_EQ(target_sizes(mesh, {.scale = 2}), 2 * current_sizes(mesh));
    EXPECT_TRUE(target_sizes(mesh, {.size = 0.3, .scale = 0.5}).isApproxToConstant(0.15));
    EXPECT_EQ(target_sizes(mesh, {.size_field = "h"}), mesh.fields[0].values.col(0));
}

TEST(SizeSettings, OfCurvatureAreChordsOfTheErrorAndAtMostATenthOfTheBox)
{
    constexpr double kInner = 1, kOuter = 3, kError = 1e-4;
    const Mesh mesh = build_mesh(test::annulus(kInner, kOuter, 200, 12));
    const Eigen::VectorXd sizes = target_sizes(mesh, {.curvature = kError, .gradation = 10});
    for (const Index v : marker_vertices(marker(mesh, "inner")))
        EXPECT_NEAR(sizes[v], std::sqrt(8 * kError * kInner), 1e-3);
    for (const Index v : marker_vertices(marker(mesh, "outer")))
        EXPECT_NEAR(sizes[v], std::sqrt(8 * kError * kOuter), 1e-3);
    EXPECT_NEAR(target_sizes(mesh, {.curvature = 1e3}).maxCoeff(), 0.1 * std::hypot(6, 6), 1e-9);
    EXPECT_LE(target_sizes(mesh, {.size = 0.02, .curvature = kError}).maxCoeff(), 0.02);
}

TEST(SizeSettings, AdaptToAFieldForAsManyVerticesAsTheMeshHas)
{
    const Mesh mesh = build_mesh(square_with("u", 40, front));
    const SizeSettings settings{.adapt = "u"};
    EXPECT_EQ(target_vertices(mesh, settings), 41 * 41);
    EXPECT_EQ(target_vertices(mesh, {.adapt = "u", .vertices = 500}), 500);
    EXPECT_EQ(target_vertices(mesh, {}), 0);
    const Eigen::VectorXd sizes = target_sizes(mesh, settings);
    EXPECT_GT(sizes.maxCoeff(), 3 * sizes.minCoeff()) << "small at the front";
    EXPECT_LE(steepest(mesh, sizes), 0.2 + 1e-12) << "the usual gradation";
    EXPECT_LE(target_sizes(mesh, {.size = 0.03, .adapt = "u"}).maxCoeff(), 0.03);
}

TEST(SizeSettings, LimitTheGradationWhereItIsGiven)
{
    const Mesh mesh = build_mesh(square_with("h", 20, [](double x, double) { return x < 0.5 ? 0.01 : 1; }));
    EXPECT_LE(steepest(mesh, target_sizes(mesh, {.size_field = "h", .gradation = 1.5})), 0.5 + 1e-12);
    EXPECT_LE(steepest(mesh, target_sizes(mesh, {.size_field = "h"})), 0.2 + 1e-12);
}

TEST(SizeSettings, NameFieldAndVertexOfASizeThatIsNotPositive)
{
    for (const auto& [bad, number] : {std::pair{-1.0, "-1"}, {0.0, "0"}, {std::nan(""), "nan"}}) {
        MeshData data = square_with("h", 4, growing);
        data.fields[0].values(17, 0) = data.fields[0].values(5, 0) = bad;
        const Mesh mesh = build_mesh(data);
        const std::string expected =
            std::string("field 'h': vertex 5 has the target size ") + number + ", but it has to be positive";
        EXPECT_EQ(message_of([&] { target_sizes(mesh, {.size_field = "h"}); }), expected);
        EXPECT_EQ(message_of([&] { target_sizes(mesh, {.size_field = "h"}, {}, "in.vtu: "); }),
                  "in.vtu: " + expected);
    }
}

TEST(SizeSettings, RefuseFieldsThatAreMissingOrDoNotFit)
{
    MeshData data = square_with("u", 4, front);
    data.fields.push_back({"velocity", FieldLocation::vertex, Matrix::Ones(25, 2)});
    data.fields[0].values(7, 0) = std::nan("");
    const Mesh mesh = build_mesh(data);
    const auto complaint = [&](const SizeSettings& settings) {
        return message_of([&] { target_sizes(mesh, settings); });
    };
    EXPECT_THAT(complaint({.adapt = "u"}), HasSubstr("field 'u': vertex 7 has a value that is not finite"));
    EXPECT_THAT(complaint({.adapt = "v"}), HasSubstr("the mesh has no nodal field 'v'"));
    EXPECT_THAT(complaint({.size_field = "velocitie"}), HasSubstr("did you mean 'velocity'?"));
    EXPECT_THAT(complaint({.size_field = "velocity"}), HasSubstr("has 2 components, but a size has 1"));
}

} // namespace
} // namespace morph
