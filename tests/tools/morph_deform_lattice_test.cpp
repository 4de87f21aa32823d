// morph-deform with a [lattice].
#include "formats/formats.h"
#include "tests/support/cases.h"
#include "tests/support/mesh_data_compare.h"
#include "tests/support/meshes.h"
#include "tests/support/process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using namespace morph;
using test::run_tool;
using test::TemporaryFolder;
using ::testing::HasSubstr;

class LatticeCase : public ::testing::Test {
protected:
    test::ProcessResult deform(const std::string& text)
    {
        return run_tool("morph-deform", {folder_.write("case.toml", text), "-o", output_, "--json",
                                         folder_.file("report.json")});
    }

    Points moved(const std::string& text)
    {
        const auto result = deform(text);
        EXPECT_EQ(result.status, 0) << result.errors;
        return read_mesh_data(output_).points;
    }

    nlohmann::json report() const
    {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")));
    }

    std::string refusal(const std::string& text)
    {
        const auto result = deform(text);
        EXPECT_EQ(result.status, 1);
        return result.errors;
    }

    std::string case_of(const std::string& lattice, const std::string& method = "ffd") const
    {
        return "[mesh]\nfile = \"" + mesh_ + "\"\n[lattice]\n" + lattice + "\n[deform]\nmethod = \"" +
               method + "\"\n";
    }

    TemporaryFolder folder_;
    std::string output_ = folder_.file("moved.su2");
    std::string mesh_ = test::example_path("naca0012_inv.su2");
    Points before_ = read_mesh_data(mesh_).points;
};

const std::string kBox = "points = [6, 5]\nbox = [-0.5, -0.5, 1.5, 0.5]\n";

bool in_box(const Points& points, Index v)
{
    return std::abs(points(v, 0) - 0.5) <= 1 && std::abs(points(v, 1)) <= 0.5;
}

TEST_F(LatticeCase, MovesWhatLiesInTheBoxAndNothingElse)
{
    // All control points move alike, so all of the box does.
    std::string rows;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 5; ++j)
            rows += "[" + std::to_string(i) + ", " + std::to_string(j) + ", 0.25, -0.125], ";
    const auto result = deform(case_of(kBox + "displacements = [" + rows + "]"));
    EXPECT_EQ(result.status, 3); // at the faces of the box the mesh is torn
    EXPECT_THAT(result.errors, HasSubstr("it tears there; continuity = 1 holds them"));
    const Points after = read_mesh_data(output_).points;
    for (Index v = 0; v < after.rows(); ++v) {
        const Eigen::RowVector3d move =
            in_box(before_, v) ? Eigen::RowVector3d(0.25, -0.125, 0) : Eigen::RowVector3d::Zero();
        EXPECT_LT((after.row(v) - before_.row(v) - move).norm(), 1e-13) << v;
    }
    EXPECT_EQ(report()["lattice"]["inside"].get<int>() + report()["lattice"]["outside"].get<int>(), 5233);
    EXPECT_LT(report()["weights"]["partition_error"], 1e-14);
}

TEST_F(LatticeCase, UndisplacedMovesNothing)
{
    std::string weights;
    for (int k = 0; k < 30; ++k)
        weights += std::to_string(1 + 0.05 * k) + ", ";
    const std::vector<std::string> shapes{"degree = [2, 4]\n", "basis = \"bernstein\"\n",
                                          "weights = [" + weights + "]\n"};
    for (const std::string& shape : shapes)
        EXPECT_EQ(moved(case_of(kBox + shape)), before_) << shape;
}

TEST_F(LatticeCase, IsBernsteinsSumOfControlPoints)
{
    const Points after = moved(case_of("basis = \"bernstein\"\npoints = [4, 3]\nbox = [-1, -1, 2, 1]\n"
                                       "displacements = [[1, 1, 0.01, 0.03], [2, 1, 0.0, 0.02]]\n"));
    const auto bernstein = [](int n, int i, double u) {
        const std::array<std::array<double, 4>, 4> choose{
            {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}}};
        return choose[static_cast<std::size_t>(n)][static_cast<std::size_t>(i)] * std::pow(u, i) *
               std::pow(1 - u, n - i);
    };
    for (Index v = 0; v < after.rows(); ++v) {
        const double x = before_(v, 0), y = before_(v, 1);
        const bool inside = x >= -1 && x <= 2 && y >= -1 && y <= 1;
        const double u = (x + 1) / 3, w = (y + 1) / 2;
        const double one = inside ? bernstein(3, 1, u) * bernstein(2, 1, w) : 0;
        const double two = inside ? bernstein(3, 2, u) * bernstein(2, 1, w) : 0;
        EXPECT_NEAR(after(v, 0) - x, 0.01 * one, 1e-14);
        EXPECT_NEAR(after(v, 1) - y, 0.03 * one + 0.02 * two, 1e-14);
    }
}

TEST_F(LatticeCase, ContinuityHoldsTheOuterControlPoints)
{
    const auto result =
        deform(case_of(kBox + "continuity = 1\ndisplacements = [[2, 2, 0, 0.03], [0, 0, 1, 1]]\n"));
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr("continuity = 1 holds 1 control points that have displacements"));
    EXPECT_EQ(report()["lattice"]["held"], 28); // all but 2 x 1 of 30
}

/// Vertices at x = 0, h, 2 h, 4 h ... 1 on three lines, next to the face x = 0 of the unit square, and at x =
/// -1.
MeshData strip_at_a_face(double h)
{
    MeshData strip;
    std::vector<double> x{-1, 0};
    for (double at = h; at < 1; at *= 2)
        x.push_back(at);
    const auto columns = static_cast<Index>(x.size());
    strip.points = Points::Zero(Eigen::Index{3} * columns, 3);
    for (Index row = 0; row < 3; ++row)
        for (Index i = 0; i < columns; ++i)
            strip.points.row(row * columns + i) << x[static_cast<std::size_t>(i)], 0.4 + 0.1 * row, 0;
    for (Index row = 0; row < 2; ++row)
        for (Index i = 0; i + 1 < columns; ++i) {
            const Index v = row * columns + i;
            strip.elements.push_back({v, v + 1, v + columns + 1, v + columns});
        }
    return strip;
}

TEST_F(LatticeCase, WithContinuityKTheFirstKDerivativesOfTheMoveVanishAtTheBox)
{
    constexpr double kStep = 1e-3;
    mesh_ = folder_.file("strip.vtu");
    output_ = folder_.file("moved.vtu");
    write_mesh_data(strip_at_a_face(kStep), mesh_);
    std::string rows;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j)
            rows += "[" + std::to_string(i) + ", " + std::to_string(j) + ", 0, 0.01], ";
    for (int k = 0; k <= 2; ++k) {
        const auto result =
            deform(case_of("points = [8, 8]\ndegree = [3, 3]\nbox = [0, 0, 1, 1]\ncontinuity = " +
                           std::to_string(k) + "\ndisplacements = [" + rows + "]\n"));
        const Points moves = read_mesh_data(output_).points - strip_at_a_face(kStep).points;
        EXPECT_EQ(moves(0, 1), 0) << k << result.errors; // outside
        EXPECT_EQ(moves(1, 1), 0) << k;                  // on the face
        // The move at h, 2 h and 4 h grows as h^(k + 1): derivatives up to the k-th are zero, the next is
        // not. The term after it is 15 h times as large at most.
        for (const Index at : {2, 3})
            EXPECT_NEAR(moves(at + 1, 1) / moves(at, 1), std::pow(2, k + 1),
                        15 * 4 * kStep * std::pow(2, k + 1))
                << k;
    }
}

TEST_F(LatticeCase, MovesTheBoundaryWhileHarmonicWeightsCarryTheMesh)
{
    const std::string lattice = kBox + "displacements = [[2, 3, 0, 0.05]]\nmarkers = [\"airfoil\"]\n";
    const Points by_ffd = moved(case_of(kBox + "displacements = [[2, 3, 0, 0.05]]\n"));
    const Points by_both = moved(case_of(lattice, "harmonic"));
    const MeshData mesh = read_mesh_data(mesh_);
    for (const auto& edge : find_marker(mesh.markers, "airfoil")->edges)
        EXPECT_LT((by_both.row(edge[0]) - by_ffd.row(edge[0])).norm(), 1e-15);
    for (const auto& edge : find_marker(mesh.markers, "farfield")->edges)
        EXPECT_EQ(by_both.row(edge[0]), before_.row(edge[0]));
    EXPECT_GT((by_both - by_ffd).norm(), 1e-3);
    EXPECT_EQ(report()["safe_step"]["step"], 1);
}

TEST_F(LatticeCase, TurnedBoxesAndControlPointsInPlaceMakeTheSameLattice)
{
    const std::string displaced = "displacements = [[1, 1, 0.02, 0.01]]\n";
    const Points box = moved(case_of("degree = [2, 2]\npoints = [3, 3]\nbox = [-1, -1, 3, 1]\n" + displaced));
    const Points axes = moved(case_of(
        "degree = [2, 2]\npoints = [3, 3]\norigin = [-1, -1]\naxes = [[4, 0], [0, 2]]\n" + displaced));
    const Points placed =
        moved(case_of("degree = [2, 2]\npoints = [3, 3]\ncontrol_points = [[-1, -1], [1, -1], [3, -1], "
                      "[-1, 0], [1, 0], [3, 0], [-1, 1], [1, 1], [3, 1]]\n" +
                      displaced));
    EXPECT_LT((axes - box).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_LT((placed - box).cwiseAbs().maxCoeff(), 1e-15);
}

TEST_F(LatticeCase, TakesTheFfdBoxesOfAnSu2File)
{
    mesh_ = test::data_path("meshes/naca0012_multiffd.su2");
    const Points before = read_mesh_data(mesh_).points;
    const Points after = moved(case_of("su2_box = \"UPPER\"\ndisplacements = [[2, 1, 0, 0.01]]\n"));
    for (Index v = 0; v < after.rows(); ++v) {
        const double u = (before(v, 0) - 0.075) / 0.55, w = (before(v, 1) - 0.02) / 0.055;
        const bool inside = u >= 0 && u <= 1 && w >= 0 && w <= 1;
        const double basis = inside ? 6 * u * u * (1 - u) * (1 - u) * w : 0; // Bernstein of degrees 4 and 1
        EXPECT_NEAR(after(v, 1) - before(v, 1), 0.01 * basis, 1e-14);
    }
    EXPECT_THAT(
        refusal(case_of("su2_box = \"UPER\"\n")),
        HasSubstr("su2_box 'UPER' is not in " + mesh_ + ", which has UPPER, LOWER; did you mean 'UPPER'?"));
}

TEST_F(LatticeCase, MovesByWeightsOfItsControlPointsAsWell)
{
    // Of a lattice over the unit square [Lamousin & Waggenspack]: with weight w of control point (1, 0) of
    // degree 1 along u, x goes to w x / (1 - x + w x).
    write_mesh_data(test::quad_square(8), folder_.file("square.su2"));
    mesh_ = folder_.file("square.su2");
    const Points before = read_mesh_data(mesh_).points;
    const Points after = moved(
        case_of("degree = [1, 1]\npoints = [2, 2]\nbox = [0, 0, 1, 1]\nmoved_weights = [1, 3, 1, 3]\n"));
    for (Index v = 0; v < after.rows(); ++v) {
        const double x = before(v, 0);
        EXPECT_NEAR(after(v, 0), 3 * x / (1 - x + 3 * x), 1e-13);
        EXPECT_NEAR(after(v, 1), before(v, 1), 1e-13);
    }
    EXPECT_FALSE(report().contains("safe_step")); // the move is not linear in the weights
}

TEST_F(LatticeCase, DeformsSurfacesInSpace)
{
    MeshData surface = test::uneven_square(6);
    surface.dimension = 3;
    for (Index v = 0; v < surface.points.rows(); ++v)
        surface.points(v, 2) = 0.5 + 0.1 * surface.points(v, 0) * surface.points(v, 1);
    for (const std::string extension : {".stl", ".obj", ".ply", ".vtu"}) {
        mesh_ = folder_.file("surface" + extension);
        write_mesh_data(surface, mesh_);
        const MeshData read = read_mesh_data(mesh_);
        output_ = folder_.file("moved" + extension);
        std::string rows; // a shear of the whole lattice: z += x / 2
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                for (int k = 0; k < 3; ++k)
                    rows += "[" + std::to_string(i) + "," + std::to_string(j) + "," + std::to_string(k) +
                            ",0,0," + std::to_string(0.25 * i) + "], ";
        const Points after =
            moved(case_of("degree = [2, 2, 2]\npoints = [3, 3, 3]\nbox = [0, 0, 0, 1, 1, 1]\n"
                          "displacements = [" +
                          rows + "]\n"));
        const double tolerance = extension == ".stl" ? 1e-6 : 1e-13; // STL holds single precision
        for (Index v = 0; v < after.rows(); ++v)
            EXPECT_NEAR(after(v, 2), read.points(v, 2) + read.points(v, 0) / 2, tolerance) << extension;
    }
}

TEST_F(LatticeCase, MovesAnStlOfAHundredThousandTrianglesByTheTripleSum)
{
    MeshData surface = test::uneven_square(224);
    surface.dimension = 3;
    surface.markers.clear();
    for (Index v = 0; v < surface.points.rows(); ++v)
        surface.points(v, 2) = 0.5 + 0.3 * std::sin(3 * surface.points(v, 0)) * surface.points(v, 1);
    mesh_ = folder_.file("surface.stl");
    output_ = folder_.file("moved.stl");
    write_mesh_data(surface, mesh_);
    const Points before = read_mesh_data(mesh_).points;
    const Points after = moved(case_of("basis = \"bernstein\"\npoints = [3, 3, 3]\nbox = [0, 0, 0, 1, 1, 1]\n"
                                       "displacements = [[1, 1, 2, 0.2, 0, 0.4], [2, 0, 1, 0, -0.3, 0]]\n"));
    EXPECT_EQ(report()["quality"]["after"]["triangles"], 100352);
    ASSERT_EQ(after.rows(), before.rows());
    const auto quadratic = [](int i, double u) {
        return i == 0 ? (1 - u) * (1 - u) : i == 1 ? 2 * u * (1 - u) : u * u;
    };
    double farthest = 0;
    for (Eigen::Index v = 0; v < before.rows(); ++v) {
        const double x = before(v, 0), y = before(v, 1), z = before(v, 2);
        const double first = quadratic(1, x) * quadratic(1, y) * quadratic(2, z);
        const double second = quadratic(2, x) * quadratic(0, y) * quadratic(1, z);
        const Eigen::RowVector3d wanted =
            before.row(v) + first * Eigen::RowVector3d(0.2, 0, 0.4) + second * Eigen::RowVector3d(0, -0.3, 0);
        farthest = std::max(farthest, (after.row(v) - wanted).norm());
    }
    EXPECT_LT(farthest, 1e-6); // STL holds single precision
}

TEST_F(LatticeCase, WarnsOfAFoldedLatticeAndNamesTheCell)
{
    // The two middle columns of control points are in each other's place.
    const auto result = deform(
        case_of("degree = [1, 1]\npoints = [4, 2]\ncontrol_points = [[-1, -1], [2, -1], [1, -1], [4, -1], "
                "[-1, 1], [2, 1], [1, 1], [4, 1]]\n"));
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_THAT(result.errors,
                HasSubstr("[lattice] is folded in 1 of its cells, the first from control point (1, 0) on"));
}

TEST_F(LatticeCase, IsFittedToTheCurvesOfACase)
{
    CaseFile file = test::fitted_case(mesh_, {"airfoil"});
    test::turn(file, 3, {0.5, 0});
    const std::string text = test::case_text(file);
    const auto result = deform(text + "[lattice]\npoints = [10, 8]\nbox = [-0.5, -0.6, 1.5, 0.6]\n");
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_FALSE(report().contains("curve_misfit")); // harmonic weights need no fit
    const auto fitted = run_tool("morph-deform", {folder_.file("case.toml"), "--method", "ffd", "-o", output_,
                                                  "--json", folder_.file("report.json")});
    ASSERT_LE(fitted.status, 3) << fitted.errors;
    EXPECT_GT(report()["curve_misfit"], 0);
    EXPECT_LT(report()["curve_misfit"], 1e-3); // a small turn is nearly affine, which a lattice makes exactly
}

TEST_F(LatticeCase, SaysWhatIsWrongWithALattice)
{
    EXPECT_THAT(refusal(case_of("points = [3, 5]\ndegree = [3, 3]\nbox = [0, 0, 1, 1]\n")),
                HasSubstr("[lattice] degree 3 needs at least 4 control points along i, but there are 3"));
    EXPECT_THAT(refusal(case_of("points = [4, 4]\nbox = [0, 0, 0, 1]\n")),
                HasSubstr("case.toml:3: [lattice] "));
    EXPECT_THAT(refusal(case_of("points = [4, 4]\nbox = [90, 90, 91, 91]\n")),
                HasSubstr("holds no vertex of the mesh"));
    EXPECT_THAT(refusal(case_of("points = [999, 999]\nbox = [0, 0, 1, 1]\n")),
                HasSubstr("[lattice] points make more than 100000 control points"));
    EXPECT_THAT(refusal(case_of("points = [1e300, 4]\nbox = [0, 0, 1, 1]\n")),
                HasSubstr("[lattice] points must be whole numbers from 2 to 1000"));
    EXPECT_THAT(refusal(case_of("points = [4, 4]\n")),
                HasSubstr("[lattice] needs one of box, origin with axes"));
    EXPECT_THAT(refusal(case_of(kBox + "displacements = [[6, 0, 1, 1]]\n")),
                HasSubstr("names no control point: i must be a whole number from 0 to 5"));
    EXPECT_THAT(refusal(case_of("points = [4, 4, 4]\nbox = [0, 0, 0, 1, 1, 1]\n")),
                HasSubstr("is in space, but the mesh is planar"));
    EXPECT_THAT(refusal(case_of(kBox + "colour = 3\n")), HasSubstr("unknown key 'colour' in [lattice]"));
    EXPECT_THAT(refusal("[mesh]\nfile = \"" + mesh_ +
                        "\"\n[[boundary]]\nname = \"airfoil\"\ncontrol_points = [[0,0],[1,0],[1,1],[0,1]]\n"
                        "[deform]\nmethod = \"ffd\"\n"),
                HasSubstr("method = \"ffd\" needs a [lattice]"));
}

} // namespace
