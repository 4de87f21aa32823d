#include "formats/formats.h"
#include "libmorph/core/types.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"
#include "tests/tools/remeshed.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <utility>

namespace morph {
namespace {

using test::remeshed;

std::string errors_of(const std::vector<std::string>& arguments)
{
    const test::ProcessResult result = test::run_tool("morph-remesh", arguments);
    EXPECT_EQ(result.status, 1);
    return result.errors;
}

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

constexpr double kWidth = 0.03;

/// A front on a quarter circle.
double front(double x, double y)
{
    return std::tanh((std::hypot(x, y) - 0.7) / kWidth);
}

/// L2 norm of a function less its linear interpolant at the nodes of a mesh, by the midpoints of 1024
/// triangles in each.
double interpolation_error(const MeshData& mesh, const std::function<double(double, double)>& f)
{
    constexpr int kParts = 32;
    double sum = 0;
    for (const Element& e : mesh.elements) {
        const Eigen::RowVector3d a = mesh.points.row(e[0]), b = mesh.points.row(e[1]),
                                 c = mesh.points.row(e[2]);
        const double fa = f(a[0], a[1]), fb = f(b[0], b[1]), fc = f(c[0], c[1]);
        const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
        const auto add = [&](double s, double t) {
            const Eigen::RowVector3d x = a + s * (b - a) + t * (c - a);
            const double difference = f(x[0], x[1]) - (fa + s * (fb - fa) + t * (fc - fa));
            sum += area / (kParts * kParts) * difference * difference;
        };
        for (int i = 0; i < kParts; ++i)
            for (int j = 0; i + j < kParts; ++j) {
                add((i + 1.0 / 3) / kParts, (j + 1.0 / 3) / kParts);
                if (i + j + 1 < kParts)
                    add((i + 2.0 / 3) / kParts, (j + 2.0 / 3) / kParts);
            }
    }
    return std::sqrt(sum);
}

TEST(MorphRemeshSizes, AdaptingLowersTheInterpolationErrorOfAFrontSeveralTimesAtTheSameCount)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.vtu"), out = folder.file("out.vtu");
    write_mesh_data(square_with("u", 150, front), in);
    std::vector<double> errors;
    for (const std::string count : {"4000", "16000"}) {
        remeshed({in, "-o", out, "--size", "0.1", "--vertices", count});
        const double uniform = interpolation_error(read_mesh_data(out), front);
        const nlohmann::json report = remeshed({in, "-o", out, "--adapt", "u", "--vertices", count});
        EXPECT_NEAR(report["quality"]["after"]["vertices"].get<double>(), std::stod(count),
                    0.02 * std::stod(count));
        errors.push_back(interpolation_error(read_mesh_data(out), front));
        EXPECT_LT(errors.back(), uniform / 4);
    }
    // Second order in the edge length, which is the root of the count; counts are within 2 %.
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2, 0.25);
}

TEST(MorphRemeshSizes, CurvatureMakesChordsOfTheErrorAskedFor)
{
    const test::TemporaryFolder folder;
    const std::string in = folder.file("in.su2"), out = folder.file("out.su2");
    constexpr double kInner = 1, kOuter = 3;
    write_mesh_data(test::annulus(kInner, kOuter, 200, 12), in);
    for (const std::string error : {"0.001", "0.01"}) {
        remeshed({in, "-o", out, "--curvature", error});
        const MeshData mesh = read_mesh_data(out);
        for (const Marker& marker : mesh.markers) {
            const double radius = marker.name == "inner" ? kInner : kOuter;
            double sum = 0;
            for (const auto& [a, b] : marker.edges) {
                const double sagitta = radius - (mesh.points.row(a) + mesh.points.row(b)).norm() / 2;
                EXPECT_LT(sagitta,
                          1.4 * 1.4 * std::stod(error)); // edges are up to 1.4 times the target length
                sum += sagitta;
            }
            EXPECT_GT(sum / static_cast<double>(marker.edges.size()), std::stod(error) / 2);
        }
    }
}

TEST(MorphRemeshSizes, NamesFileFieldAndVertexOfASizeThatIsNotPositive)
{
    const test::TemporaryFolder folder;
    const std::vector<std::pair<double, std::string>> all = {{-1, "-1"}, {0, "0"}, {std::nan(""), "nan"}};
    for (const auto& [bad, number] : all) {
        MeshData mesh = square_with("h", 4, [](double, double) { return 0.1; });
        mesh.fields[0].values(17, 0) = bad;
        mesh.fields[0].values(5, 0) = bad;
        const std::string in = folder.file("in.vtu"), out = folder.file("out.vtu");
        write_mesh_data(mesh, in);
        std::string expected = "morph-remesh: ";
        expected += in + ": field 'h': vertex 5 has the target size ";
        expected += number + ", but it has to be positive\n";
        EXPECT_EQ(errors_of({in, "-o", out, "--size-field", "h"}), expected);
        EXPECT_EQ(folder.names(), std::vector<std::string>{"in.vtu"});
    }
}

TEST(MorphRemeshSizes, NamesTheVertexWhoseValueIsNotFiniteWhenAdapting)
{
    const test::TemporaryFolder folder;
    MeshData mesh = square_with("u", 4, front);
    mesh.fields[0].values(7, 0) = std::nan("");
    const std::string in = folder.file("in.vtu");
    write_mesh_data(mesh, in);
    EXPECT_NE(errors_of({in, "-o", folder.file("out.vtu"), "--adapt", "u"}).find("field 'u': vertex 7 has"),
              std::string::npos);
    EXPECT_NE(errors_of({in, "-o", folder.file("out.vtu"), "--adapt", "v"}).find("no nodal field 'v'"),
              std::string::npos);
}

TEST(MorphRemeshSizes, RefusesAGradationOfOneOrLess)
{
    for (const char* gradation : {"1", "0.5", "-2", "nan", "1.2x"}) {
        const test::ProcessResult result =
            test::run_tool("morph-remesh", {"in.su2", "-o", "out.su2", "--gradation", gradation});
        EXPECT_EQ(result.status, 2);
        EXPECT_NE(result.errors.find("is not a number above 1"), std::string::npos) << result.errors;
    }
}

} // namespace
} // namespace morph
