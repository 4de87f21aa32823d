// [constraints] of morph-deform, measured on the meshes it writes.
#include "formats/formats.h"
#include "libmorph/mesh/builder.h"
#include "libmorph/mesh/chain.h"
#include "tests/support/cases.h"
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
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Nodes of a closed marker in order, as the file numbers them.
std::vector<Index> nodes_of(const Mesh& mesh, const std::string& name)
{
    std::vector<Index> nodes = marker_chain(marker(mesh, name), mesh.numbering).vertices;
    for (Index& v : nodes)
        v = mesh.numbering.vertex[static_cast<std::size_t>(v)];
    return nodes;
}

/// Area inside a polygon, by the shoelace formula about its first node.
double area_inside(const std::vector<Index>& nodes, const Points& at)
{
    double twice = 0;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        const Eigen::RowVector3d a = at.row(nodes[i]) - at.row(nodes[0]);
        const Eigen::RowVector3d b = at.row(nodes[i + 1]) - at.row(nodes[0]);
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return std::abs(twice / 2);
}

/// Extent in y of a polygon at x.
double thickness_at(const std::vector<Index>& nodes, const Points& at, double x)
{
    double low = std::numeric_limits<double>::max();
    double high = -low;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Eigen::RowVector3d a = at.row(nodes[i]);
        const Eigen::RowVector3d b = at.row(nodes[(i + 1) % nodes.size()]);
        if (std::min(a.x(), b.x()) > x || std::max(a.x(), b.x()) < x || a.x() == b.x())
            continue;
        const double y = a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
        low = std::min(low, y);
        high = std::max(high, y);
    }
    return high - low;
}

class ConstrainedCase : public ::testing::Test {
protected:
    static constexpr double kSwing = 0.02; // chords: enough to change the area by some percent

    /// A move of all control points that keeps nothing by itself.
    static CaseFile moved_case()
    {
        CaseFile file = test::fitted_case(test::example_path("naca0012_inv.su2"), {"airfoil"});
        Points2& moves = file.motion.curves[0].displacements;
        for (Eigen::Index k = 0; k < moves.rows(); ++k)
            moves.row(k) = kSwing * Eigen::RowVector2d(std::sin(2.0 * static_cast<double>(k)),
                                                       std::cos(5.0 * static_cast<double>(k)));
        return file;
    }

    test::ProcessResult deform(const std::string& text)
    {
        return run_tool("morph-deform", {folder_.write("case.toml", text), "-o", folder_.file("moved.su2"),
                                         "--json", folder_.file("report.json")});
    }

    Points moved(const std::string& text)
    {
        const auto result = deform(text);
        EXPECT_EQ(result.status, 0) << result.errors;
        return read_mesh_data(folder_.file("moved.su2")).points;
    }

    Points moved_by_curve(const std::string& constraints)
    {
        return moved(test::case_text(moved_case()) + constraints);
    }

    nlohmann::json constraints_report() const
    {
        return nlohmann::json::parse(test::read_text(folder_.file("report.json")))["constraints"];
    }

    std::string refusal(const std::string& constraints)
    {
        const auto result = deform(test::case_text(moved_case()) + constraints);
        EXPECT_EQ(result.status, 1) << result.errors;
        EXPECT_THAT(folder_.names(), ::testing::ElementsAre("case.toml"));
        return result.errors;
    }

    TemporaryFolder folder_;
    std::string mesh_file_ = test::example_path("naca0012_inv.su2");
    Points before_ = read_mesh_data(mesh_file_).points;
    std::vector<Index> airfoil_ = nodes_of(build_mesh(read_mesh_data(mesh_file_)), "airfoil");
};

TEST_F(ConstrainedCase, KeepTheAreaOfABoundaryUnderHarmonicWeights)
{
    const double area = area_inside(airfoil_, before_);
    EXPECT_GT(std::abs(area_inside(airfoil_, moved_by_curve("")) / area - 1), 0.02);
    const Points kept = moved_by_curve("[constraints]\narea = [\"airfoil\"]\n");
    EXPECT_NEAR(area_inside(airfoil_, kept) / area, 1, 1e-12);
    const auto report = constraints_report();
    EXPECT_NEAR(report["measured"][0]["before"].get<double>(), area, 1e-12 * area);
    EXPECT_NEAR(report["measured"][0]["reached"].get<double>(), area, 1e-12 * area);
    EXPECT_TRUE(report["measured"][0]["active"].get<bool>());
    EXPECT_GT(report["change"].get<double>(), 0);
}

TEST_F(ConstrainedCase, KeepTheAreaOfABoundaryInALattice)
{
    const std::string lattice = "[mesh]\nfile = \"" + mesh_file_ +
                                "\"\n[lattice]\npoints = [6, 5]\ndegree = [3, 3]\n"
                                "box = [-0.5, -0.5, 1.5, 0.5]\ncontinuity = 0\n"
                                "displacements = [[2, 2, 0.0, 0.03], [3, 3, 0.02, 0.05]]\n";
    const std::string method = "[deform]\nmethod = \"ffd\"\n";
    const double area = area_inside(airfoil_, before_);
    EXPECT_GT(std::abs(area_inside(airfoil_, moved(lattice + method)) / area - 1), 0.01);
    const Points kept = moved(lattice + method + "[constraints]\narea = [\"airfoil\"]\n");
    EXPECT_NEAR(area_inside(airfoil_, kept) / area, 1, 1e-12);
    Index far = 0; // outside the box, where nothing may move
    before_.col(0).maxCoeff(&far);
    EXPECT_EQ(kept.row(far), before_.row(far));
}

TEST_F(ConstrainedCase, KeepThicknessesAndFixedPointsAndPulls)
{
    const double area = area_inside(airfoil_, before_);
    const Points kept = moved_by_curve("[[pull]]\nvertices = [100]\ndisplacements = [[0.001, 0.012]]\n"
                                       "[constraints]\narea = [\"airfoil\"]\nfixed_points = [[1.0, 0.0]]\n"
                                       "[[constraints.thickness]]\nboundary = \"airfoil\"\nat = [0.6]\n"
                                       "keep = 1.1\n"
                                       "[[constraints.thickness]]\nboundary = \"airfoil\"\nat = [0.2, 0.35]\n"
                                       "at_least = 0.115\n");
    constexpr double kTight = 1e-11; // chords; the solver promises 1e-12 of the size, the file is exact
    EXPECT_NEAR(area_inside(airfoil_, kept) / area, 1, 1e-12);
    EXPECT_NEAR(thickness_at(airfoil_, kept, 0.6), 1.1 * thickness_at(airfoil_, before_, 0.6), kTight);
    EXPECT_GE(thickness_at(airfoil_, kept, 0.2), 0.115 - kTight);
    EXPECT_GE(thickness_at(airfoil_, kept, 0.35), 0.115 - kTight);
    EXPECT_LT((kept.row(100) - before_.row(100) - Eigen::RowVector3d(0.001, 0.012, 0)).norm(), 1e-10);
    Index tail = 0;
    (before_.rowwise() - Eigen::RowVector3d(1, 0, 0)).rowwise().norm().minCoeff(&tail);
    EXPECT_LT((kept.row(tail) - before_.row(tail)).norm(), kTight);
}

TEST_F(ConstrainedCase, MirrorAndTieTheControlPointsOfALattice)
{
    const std::string lattice = "[mesh]\nfile = \"" + mesh_file_ +
                                "\"\n[lattice]\npoints = [5, 4]\ndegree = [2, 2]\n"
                                "box = [-0.5, -0.5, 1.5, 0.5]\n"
                                "displacements = [[2, 2, 0.01, 0.04]]\n[deform]\nmethod = \"ffd\"\n";
    const Points kept = moved(lattice + "[constraints]\n[[constraints.mirrored]]\nboundary = \"lattice\"\n"
                                        "normal = [0, 1]\n[[constraints.tied]]\nboundary = \"lattice\"\n"
                                        "control_points = [[0, 0], [0, 1], [0, 2], [0, 3]]\n");
    // Half of the requested move on either side: the symmetric part of it.
    const Points wanted = moved(lattice);
    const auto mirror_image = [&](Index v) {
        Index image = 0;
        (before_.rowwise() - Eigen::RowVector3d(before_(v, 0), -before_(v, 1), 0))
            .rowwise()
            .norm()
            .minCoeff(&image);
        return image;
    };
    int compared = 0;
    for (const Index v : airfoil_) {
        const Index image = mirror_image(v);
        if (std::abs(before_(v, 1) + before_(image, 1)) > 1e-12)
            continue;
        ++compared;
        EXPECT_NEAR(kept(v, 1) + kept(image, 1), 0, 1e-9);
        EXPECT_NEAR(kept(v, 0), kept(image, 0), 1e-9);
        EXPECT_NEAR(kept(v, 0) - before_(v, 0),
                    (wanted(v, 0) - before_(v, 0) + wanted(image, 0) - before_(image, 0)) / 2, 1e-9);
    }
    EXPECT_GT(compared, 50);
}

TEST_F(ConstrainedCase, KeepTheEndsOfTwoCurvesTogether)
{
    const std::string halves = test::data_path("meshes/naca0012_multiffd.su2");
    const Mesh mesh = build_mesh(read_mesh_data(halves));
    const std::vector<std::string> names{"airfoil_lower", "airfoil_upper"};
    CaseFile file = test::fitted_case(halves, names);
    file.motion.curves[0].displacements.row(5) = Eigen::RowVector2d(0.0, 0.03);
    file.motion.curves[1].displacements.row(5) = Eigen::RowVector2d(0.0, 0.03);
    const Index middle = nodes_of(mesh, names[0])[3];
    const Points after =
        moved(test::case_text(file) + "[constraints]\nfixed_vertices = [" + std::to_string(middle) + "]\n");
    EXPECT_LT((after.row(middle) - read_mesh_data(halves).points.row(middle)).norm(), 1e-11);
}

TEST_F(ConstrainedCase, ContradictionsAreNamed)
{
    const std::string station = "[[constraints.thickness]]\nboundary = \"airfoil\"\nat = [0.3]\n";
    EXPECT_THAT(refusal("[constraints]\n" + station + "equal = 0.1\n" + station + "at_least = 0.2\n"),
                AllOf(HasSubstr("case.toml:"), HasSubstr("thickness of 'airfoil' at x = 0.3"),
                      HasSubstr("contradict")));
    EXPECT_THAT(refusal("[[pull]]\nvertices = [100]\ndisplacements = [[0, 0.01]]\n"
                        "[constraints]\nfixed_vertices = [100]\n"),
                AllOf(HasSubstr("'fixed points'"), HasSubstr("'[[pull]]'"), HasSubstr("contradict")));
}

TEST_F(ConstrainedCase, SaysWhatIsWrongWithConstraints)
{
    const auto with = [&](const std::string& text) { return refusal("[constraints]\n" + text); };
    const std::string station = "[[constraints.thickness]]\nboundary = \"airfoil\"\n";
    EXPECT_THAT(with("area = [\"wing\"]\n"), HasSubstr("the mesh has no marker 'wing'"));
    EXPECT_THAT(with("aera = [\"airfoil\"]\n"), HasSubstr("did you mean 'area'?"));
    EXPECT_THAT(with("fixed_vertices = [7000]\n"), HasSubstr("names vertex 7000, but the mesh has 5233"));
    EXPECT_THAT(with(station + "at_least = 0.1\n"), HasSubstr("needs at, such as at = [0.25"));
    EXPECT_THAT(with(station + "at = [0.5]\n"), HasSubstr("needs one of at_least and equal"));
    EXPECT_THAT(with(station + "at = [0.5]\nkeep = 1\nequal = 0.1\n"), HasSubstr("needs one of"));
    EXPECT_THAT(with(station + "at = [0.5]\nequal = -0.1\n"), HasSubstr("equal must be above 0"));
    EXPECT_THAT(with(station + "at = [7]\nkeep = 1\n"), HasSubstr("thickness of 'airfoil' at x = 7"));
    const std::string tied = "[[constraints.tied]]\nboundary = \"airfoil\"\n";
    EXPECT_THAT(with(tied + "control_points = [3]\n"), HasSubstr("at least two"));
    EXPECT_THAT(with(tied + "control_points = [3, 13]\n"),
                HasSubstr("there is no such control point of 'airfoil': 13"));
    EXPECT_THAT(with("[[constraints.tied]]\nboundary = \"lattice\"\ncontrol_points = [[0, 0], [0, 1]]\n"),
                HasSubstr("there is no such control point of 'lattice'"));
    const std::string mirrored = "[[constraints.mirrored]]\nboundary = \"airfoil\"\n";
    EXPECT_THAT(with(mirrored), HasSubstr("needs normal"));
    EXPECT_THAT(with(mirrored + "normal = [1, 0]\n"), HasSubstr("has no image"));
}

} // namespace
