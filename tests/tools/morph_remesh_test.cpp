#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/quality/quality.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"
#include "tests/support/surfaces.h"
#include "tests/tools/remeshed.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace morph {
namespace {

using test::remeshed;

TEST(MorphRemesh, CoarsensEveryRealMeshWithoutInvertingAnElementOrLosingAMarker)
{
    const test::TemporaryFolder folder;
    for (const std::string& path : test::real_meshes()) {
        const std::string out = folder.file("out.su2");
        const nlohmann::json report = remeshed({path, "-o", out, "--scale", "1.5"});
        const Mesh before = read_mesh(path), after = read_mesh(out);
        EXPECT_EQ(quality_report(after).inverted, quality_report(before).inverted) << path;
        ASSERT_EQ(after.markers.size(), before.markers.size()) << path;
        for (std::size_t i = 0; i < before.markers.size(); ++i) {
            EXPECT_EQ(after.markers[i].name, before.markers[i].name);
            EXPECT_FALSE(after.markers[i].edges.empty());
        }
        EXPECT_EQ(report["quality"]["after"]["vertices"], vertex_count(after)) << path;
    }
}

TEST(MorphRemesh, ReportsTheWorstTriangleThatIsInTheFile)
{
    const test::TemporaryFolder folder;
    const std::string out = folder.file("out.su2");
    const nlohmann::json worst = remeshed({test::data_path("meshes/naca0012_inv.su2"), "-o", out, "--scale",
                                           "1.5"})["triangle_quality"]["after"];
    const MeshData data = read_mesh_data(out);
    const Element e = data.elements.at(worst["worst_element"].get<std::size_t>());
    double sides = 0;
    for (std::size_t k = 0; k < 3; ++k)
        sides += (data.points.row(e[(k + 1) % 3]) - data.points.row(e[k])).squaredNorm();
    const Eigen::RowVector3d ab = data.points.row(e[1]) - data.points.row(e[0]);
    const Eigen::RowVector3d ac = data.points.row(e[2]) - data.points.row(e[0]);
    const double area = (ab[0] * ac[1] - ab[1] * ac[0]) / 2;
    // The file has 17 digits; the formula loses a few.
    EXPECT_NEAR(worst["min"].get<double>(), 4 * std::sqrt(3) * area / sides, 1e-12);
    EXPECT_GE(worst["min"].get<double>(), 0.62);
}

double planar_area(const MeshData& mesh)
{
    double area = 0;
    for (const Element& e : mesh.elements)
        for (int k = 0, n = corner_count(e); k < n; ++k) {
            const auto a = mesh.points.row(e[static_cast<std::size_t>(k)]);
            const auto b = mesh.points.row(e[static_cast<std::size_t>((k + 1) % n)]);
            area += (a[0] * b[1] - a[1] * b[0]) / 2;
        }
    return area;
}

TEST(MorphRemesh, MeshesEveryPlanarRealMeshAnew)
{
    const test::TemporaryFolder folder;
    int planar = 0;
    for (const std::string& path : test::real_meshes()) {
        const Mesh before = read_mesh(path);
        if (before.dimension != 2)
            continue;
        ++planar;
        const std::string out = folder.file("out.su2");
        const nlohmann::json report = remeshed({path, "-o", out, "--fresh"});
        const Mesh after = read_mesh(out);
        EXPECT_EQ(quality_report(after).inverted, 0) << path;
        ASSERT_EQ(after.markers.size(), before.markers.size()) << path;
        for (std::size_t i = 0; i < before.markers.size(); ++i) {
            EXPECT_EQ(after.markers[i].name, before.markers[i].name);
            EXPECT_FALSE(after.markers[i].edges.empty());
        }
        // Chords of other nodes on the same curves: a polygon of 60 edges has 0.2 % less than its circle.
        const double area = planar_area(to_mesh_data(before));
        EXPECT_NEAR(planar_area(to_mesh_data(after)), area, 2e-3 * area) << path;
        if (const nlohmann::json& quality = report["triangle_quality"]["after"]; !quality.is_null()) {
            EXPECT_GE(quality["min"].get<double>(), 0.5) << path;
            EXPECT_GE(quality["mean"].get<double>(), 0.95) << path;
        }
    }
    EXPECT_GE(planar, 5);
}

TEST(MorphRemesh, RefusesToMeshASurfaceAnew)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.off");
    MeshData surface = test::uneven_square(4);
    surface.dimension = 3;
    surface.points(12, 2) = 0.1;
    surface.markers.clear();
    write_mesh_data(surface, in);
    const test::ProcessResult result =
        test::run_tool("morph-remesh", {in, "-o", folder.file("out.off"), "--fresh"});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.errors.find("only planar meshes"), std::string::npos) << result.errors;
}

/// A real mesh whose airfoil was turned about the middle of its chord and nothing else with it.
MeshData turned_airfoil(double degrees)
{
    MeshData mesh = read_mesh_data(test::data_path("meshes/naca0012_inv.su2"));
    const double angle = degrees * std::numbers::pi / 180;
    std::vector<bool> turned(static_cast<std::size_t>(mesh.points.rows()), false);
    for (const auto& edge : find_marker(mesh.markers, "airfoil")->edges)
        for (const Index v : edge) {
            if (turned[static_cast<std::size_t>(v)])
                continue;
            turned[static_cast<std::size_t>(v)] = true;
            const double x = mesh.points(v, 0) - 0.5, y = mesh.points(v, 1);
            mesh.points(v, 0) = 0.5 + std::cos(angle) * x - std::sin(angle) * y;
            mesh.points(v, 1) = std::sin(angle) * x + std::cos(angle) * y;
        }
    return mesh;
}

TEST(MorphRemesh, CutsInvertedElementsOutAndMeshesThemAnew)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.su2"), out = folder.file("out.su2");
    for (const double degrees : {5.0, 90.0}) {
        const MeshData before = turned_airfoil(degrees);
        write_mesh_data(before, in);
        const nlohmann::json report = remeshed({in, "-o", out});
        EXPECT_GT(report["cut_out"]["inverted"], 100);
        EXPECT_EQ(report["cut_out"]["inverted"], report["quality"]["before"]["inverted"]);
        EXPECT_EQ(report["quality"]["after"]["inverted"], 0);
        EXPECT_GE(report["triangle_quality"]["after"]["min"].get<double>(), 0.4);
        const MeshData after = read_mesh_data(out);
        EXPECT_EQ(quality_report(build_mesh(after)).inverted, 0);
        const double area = planar_area(before);
        EXPECT_NEAR(planar_area(after), area, 1e-4 * area);
    }
}

TEST(MorphRemesh, RemakesThesisCaseTwoAfterItsMove)
{
    const test::TemporaryFolder folder;
    const std::string moved = folder.file("moved.su2"), out = folder.file("out.su2");
    const test::ProcessResult deformed =
        test::run_tool("morph-deform", {test::example_path("02_thesis_case2/case.toml"), "-o", moved});
    ASSERT_EQ(deformed.status, 0) << deformed.errors;
    const double area = planar_area(read_mesh_data(moved));
    for (const std::vector<std::string>& how : {std::vector<std::string>{}, {"--fresh"}}) {
        std::vector<std::string> arguments{moved, "-o", out, "--gradation", "1.3"};
        arguments.insert(arguments.end(), how.begin(), how.end());
        const nlohmann::json report = remeshed(arguments);
        EXPECT_EQ(report["quality"]["after"]["inverted"], 0);
        EXPECT_GE(report["triangle_quality"]["after"]["min"].get<double>(), 0.5);
        EXPECT_GE(report["triangle_quality"]["after"]["mean"].get<double>(), 0.95);
        const MeshData after = read_mesh_data(out);
        EXPECT_EQ(after.markers.size(), 3U);
        EXPECT_NEAR(planar_area(after), area, 1e-4 * area);
    }
}

TEST(MorphRemesh, SaysThatABoundaryCrossesItself)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.su2");
    MeshData mesh = test::uneven_square(4);
    mesh.points.row(2) << 0.5, 1.2, 0;
    write_mesh_data(mesh, in);
    const test::ProcessResult result = test::run_tool("morph-remesh", {in, "-o", folder.file("out.su2")});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.errors.find("in.su2: the boundary of the mesh crosses itself near ("), std::string::npos)
        << result.errors;
}

/// The uneven square cut by the line through its cells' corners at half height, which is not straight.
MeshData two_halves()
{
    MeshData mesh = test::uneven_square(20);
    mesh.groups = {{"low", {}}, {"all", {}}, {"high", {}}};
    for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
        const auto number = static_cast<Index>(e);
        (e < mesh.elements.size() / 2 ? mesh.groups[0] : mesh.groups[2]).elements.push_back(number);
        mesh.groups[1].elements.push_back(number);
    }
    return mesh;
}

double group_area(const MeshData& mesh, const ElementGroup& group)
{
    double area = 0;
    for (const Index number : group.elements) {
        const Element& e = mesh.elements[static_cast<std::size_t>(number)];
        const Eigen::RowVector3d ab = mesh.points.row(e[1]) - mesh.points.row(e[0]);
        const Eigen::RowVector3d ac = mesh.points.row(e[2]) - mesh.points.row(e[0]);
        area += (ab[0] * ac[1] - ab[1] * ac[0]) / 2;
    }
    return area;
}

TEST(MorphRemesh, KeepsGroupsAndTheLinesBetweenThem)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.vtu"), out = folder.file("out.vtu");
    const MeshData before = two_halves();
    write_mesh_data(before, in);
    for (const char* scale : {"0.6", "1.5"}) {
        remeshed({in, "-o", out, "--scale", scale});
        const MeshData after = read_mesh_data(out);
        ASSERT_EQ(after.groups.size(), 3U);
        for (std::size_t g = 0; g < 3; ++g) {
            EXPECT_EQ(after.groups[g].name, before.groups[g].name);
            // The border's polygon changes a little where it is not straight: by less than 1 % of a cell's
            // height.
            EXPECT_NEAR(group_area(after, after.groups[g]), group_area(before, before.groups[g]), 5e-4);
        }
        EXPECT_EQ(after.groups[0].elements.size() + after.groups[2].elements.size(), after.elements.size());
        EXPECT_EQ(after.groups[1].elements.size(), after.elements.size());
        ASSERT_EQ(after.markers.size(), before.markers.size());
    }
}

TEST(MorphRemesh, MakesAboutAsManyVerticesAsAskedFor)
{
    const test::TemporaryFolder folder;
    const nlohmann::json report = remeshed(
        {test::data_path("meshes/naca0012_inv.su2"), "-o", folder.file("out.su2"), "--vertices", "3000"});
    EXPECT_NEAR(report["quality"]["after"]["vertices"].get<double>(), 3000, 60); // 2 %, as the tool aims
}

TEST(MorphRemesh, OnlyBadLeavesAGoodMeshAsItIs)
{
    const test::TemporaryFolder folder;
    const std::string first = folder.file("first.su2"), second = folder.file("second.su2");
    remeshed({test::data_path("meshes/naca0012_inv.su2"), "-o", first});
    remeshed({first, "-o", second, "--only-bad", "0.5"});
    EXPECT_EQ(read_mesh_data(first).points, read_mesh_data(second).points);
    EXPECT_EQ(read_mesh_data(first).elements, read_mesh_data(second).elements);
}

/// Distance of a point from the border edges of a planar mesh.
double border_distance(const Mesh& mesh, const Eigen::RowVector3d& p)
{
    double nearest = 1e300;
    const auto place = points(mesh);
    for (const auto edge : mesh.kernel.edges()) {
        if (!edge.is_boundary())
            continue;
        const Eigen::RowVector3d a = place.row(edge.v0().idx()), ab = place.row(edge.v1().idx()) - a;
        const double t = std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - a - t * ab).norm());
    }
    return nearest;
}

/// Largest of those of points along the border of another.
double sampled_distance(const Mesh& from, const Mesh& to)
{
    constexpr int kSamples = 20;
    double farthest = 0;
    const auto place = points(from);
    for (const auto edge : from.kernel.edges())
        for (int i = 0; edge.is_boundary() && i <= kSamples; ++i)
            farthest = std::max(
                farthest, border_distance(to, place.row(edge.v0().idx()) +
                                                  (place.row(edge.v1().idx()) - place.row(edge.v0().idx())) *
                                                      i / kSamples));
    return farthest;
}

TEST(MorphRemesh, ReportsTheDistanceOfTheBoundariesThatASampleFinds)
{
    const test::TemporaryFolder folder;
    const std::string in = test::data_path("meshes/naca0012_inv.su2"), out = folder.file("out.su2");
    const nlohmann::json found = remeshed({in, "-o", out, "--scale", "1.5"})["hausdorff"];
    const Mesh before = read_mesh(in), after = read_mesh(out);
    const double sample = std::max(sampled_distance(before, after), sampled_distance(after, before));
    // The report is at most 1 % too small; a sample of 20 points an edge misses less than 1 % of a sagitta.
    EXPECT_NEAR(found["distance"].get<double>(), sample, 0.02 * sample);
    EXPECT_GE(found["bound"].get<double>(), sample * (1 - 1e-9));
    const Eigen::RowVector3d at(found["at"][0], found["at"][1], 0);
    EXPECT_NEAR(border_distance(found["of"] == "input" ? after : before, at), found["distance"], 1e-12);
}

TEST(MorphRemesh, NamesTheEdgeFarthestFromTheLengthWanted)
{
    const test::TemporaryFolder folder;
    const std::string out = folder.file("out.su2");
    const nlohmann::json report =
        remeshed({test::data_path("meshes/naca0012_inv.su2"), "-o", out, "--size", "3"});
    const Mesh mesh = read_mesh(out);
    double worst = 1;
    for (const auto edge : mesh.kernel.edges()) {
        const double part =
            (points(mesh).row(edge.v0().idx()) - points(mesh).row(edge.v1().idx())).norm() / 3;
        if (std::max(part, 1 / part) > std::max(worst, 1 / worst))
            worst = part;
    }
    EXPECT_LT(worst, 0.5); // the chord of the airfoil is 1 long
    EXPECT_NEAR(report["worst_edge"]["part_of_size"].get<double>(), worst, 1e-9 * worst);
}

TEST(MorphRemesh, KeepsASurfaceWithinTheDistanceAskedForAndSaysWhenThatCannotBe)
{
    const test::TemporaryFolder folder;
    const std::string ball = folder.file("ball.obj"), out = folder.file("out.obj");
    write_mesh_data(test::sphere(20), ball);
    constexpr double kDistance = 0.004;
    const nlohmann::json report = remeshed({ball, "-o", out, "--size", "0.5", "--hausdorff", "0.004"});
    EXPECT_LE(report["hausdorff"]["distance"].get<double>(), kDistance);
    EXPECT_EQ(report["folds"], 0);
    // All corners are on the input, between the unit sphere and its chords: no centre of a triangle is
    // farther inside than both sagittas.
    const MeshData data = read_mesh_data(out);
    const double chords = 1 - std::cos(std::numbers::pi / 40) + 0.002;
    for (const Element& e : data.elements) {
        const Eigen::RowVector3d sum = data.points.row(e[0]) + data.points.row(e[1]) + data.points.row(e[2]);
        EXPECT_GT(sum.norm() / 3, 1 - kDistance - chords);
    }
    const test::ProcessResult result =
        test::run_tool("morph-remesh", {test::data_path("meshes/naca0012_inv.su2"), "-o",
                                        folder.file("out.su2"), "--hausdorff", "1e-9"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.errors.find("of --hausdorff"), std::string::npos) << result.errors;
}

TEST(MorphRemesh, RefusesASurfaceWithThreeTrianglesAtAnEdgeInOneLine)
{
    const test::TemporaryFolder folder;
    MeshData data;
    data.dimension = 3;
    data.points.resize(5, 3);
    data.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 0;
    data.elements = {{0, 1, 2, -1}, {0, 1, 3, -1}, {0, 1, 4, -1}};
    const std::string in = folder.file("book.obj");
    write_mesh_data(data, in);
    const test::ProcessResult result = test::run_tool("morph-remesh", {in, "-o", folder.file("out.obj")});
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_NE(result.errors.find("edge"), std::string::npos) << result.errors;
    EXPECT_EQ(folder.names(), std::vector<std::string>{"book.obj"});
}

/// Two unit squares of a grid that meet at 30 degrees.
MeshData flat_roof()
{
    constexpr Index kCells = 10;
    MeshData roof;
    roof.dimension = 3;
    roof.points.resize((Eigen::Index{2} * kCells + 1) * (kCells + 1), 3);
    const auto number = [](Index i, Index j) { return i * (kCells + 1) + j; };
    for (Index i = 0; i <= 2 * kCells; ++i)
        for (Index j = 0; j <= kCells; ++j) {
            const double x = static_cast<double>(i) / kCells - 1;
            const double slope = x > 0 ? std::sqrt(3.0) / 3 : 0;
            roof.points.row(number(i, j)) << x, static_cast<double>(j) / kCells, slope * x;
        }
    for (Index i = 0; i < 2 * kCells; ++i)
        for (Index j = 0; j < kCells; ++j) {
            roof.elements.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1), -1});
            roof.elements.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1), -1});
        }
    return roof;
}

double surface_area(const MeshData& mesh)
{
    double area = 0;
    for (const Element& e : mesh.elements) {
        const Eigen::Vector3d ab = mesh.points.row(e[1]) - mesh.points.row(e[0]);
        const Eigen::Vector3d ac = mesh.points.row(e[2]) - mesh.points.row(e[0]);
        area += ab.cross(ac).norm() / 2;
    }
    return area;
}

TEST(MorphRemesh, KeepsEdgesOfASurfaceFromTheAngleAskedForOn)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.vtu"), out = folder.file("out.vtu");
    write_mesh_data(flat_roof(), in);
    const double whole = 1 + 2 / std::sqrt(3.0);
    remeshed({in, "-o", out, "--scale", "0.7", "--crease", "20"});
    EXPECT_NEAR(surface_area(read_mesh_data(out)), whole, 1e-12); // sums of some hundred areas
    remeshed({in, "-o", out, "--scale", "0.7"}); // 30 degrees are no crease, and corners are cut
    EXPECT_LT(surface_area(read_mesh_data(out)), whole - 1e-4);
}

TEST(MorphRemesh, LeavesOutVerticesOfNoElementAndSaysSo)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.vtu"), out = folder.file("out.vtu");
    MeshData data = test::uneven_square(6);
    const Index count = static_cast<Index>(data.points.rows());
    data.points.conservativeResize(count + 2, 3);
    data.points.bottomRows(2) << 0.5, 0.5, 0, 7, 7, 0; // such as the centres of arcs
    write_mesh_data(data, in);
    for (const std::vector<std::string>& option : std::vector<std::vector<std::string>>{{}, {"--fresh"}}) {
        std::vector<std::string> arguments{in, "-o", out};
        arguments.insert(arguments.end(), option.begin(), option.end());
        const test::ProcessResult result = test::run_tool("morph-remesh", arguments);
        EXPECT_EQ(result.status, 0) << result.errors;
        EXPECT_NE(result.output.find("2 vertices of no element were left out"), std::string::npos)
            << result.output;
        EXPECT_LE(read_mesh_data(out).points.maxCoeff(), 1);
    }
}

TEST(MorphRemesh, NamesAMissingSizeFieldAndWritesNothing)
{
    const test::TemporaryFolder folder;
    const test::ProcessResult result =
        test::run_tool("morph-remesh", {test::data_path("meshes/naca0012_inv.su2"), "-o",
                                        folder.file("out.su2"), "--size-field", "h"});
    EXPECT_EQ(result.status, 1);
    EXPECT_NE(result.errors.find("has no nodal field 'h'"), std::string::npos) << result.errors;
    EXPECT_TRUE(folder.names().empty());
}

} // namespace
} // namespace morph
