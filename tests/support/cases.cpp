#include "tests/support/cases.h"

#include "tests/support/process.h"

#include <Eigen/Geometry>

#include <numbers>
#include <sstream>
#include <stdexcept>

namespace morph::test {

namespace {

template <typename Numbers>
std::string list(const Numbers& numbers)
{
    std::ostringstream text;
    text.precision(17);
    const char* separator = "[";
    for (const double number : numbers) {
        text << separator << number;
        separator = ", ";
    }
    text << ']';
    return text.str();
}

std::string pairs(const Points2& rows)
{
    std::string text = "[";
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
        text += (i > 0 ? ", " : "") + list(std::array{rows(i, 0), rows(i, 1)});
    return text + "]";
}

std::string boundary_text(const CurveMove& entry)
{
    std::ostringstream text;
    text << "[[boundary]]\nname = \"" << entry.marker << "\"\ndegree = " << entry.curve.degree
         << "\nclosed = " << (entry.curve.closed ? "true" : "false")
         << "\ncontrol_points = " << pairs(entry.curve.control_points)
         << "\ndisplacements = " << pairs(entry.displacements) << '\n';
    if (!entry.curve.knots.empty())
        text << "knots = " << list(entry.curve.knots) << '\n';
    if (!entry.curve.weights.empty())
        text << "weights = " << list(entry.curve.weights) << '\n';
    if (entry.nodes > 0)
        text << "nodes = " << entry.nodes << '\n';
    return text.str();
}

} // namespace

std::string case_text(const CaseFile& file)
{
    std::ostringstream text;
    text << "[mesh]\n";
    if (file.generate)
        text << "generate = { box = " << list(file.generate->box) << ", size = " << file.generate->size
             << " }\n";
    else
        text << "file = \"" << file.mesh_file << "\"\n";
    for (const CurveMove& entry : file.motion.curves)
        text << '\n' << boundary_text(entry);
    const DeformSettings& deform = file.motion.deform;
    text << "\n[deform]\nmethod = \"" << to_string(deform.method) << "\"\ndiffusivity = \""
         << to_string(deform.diffusivity) << "\"\nguard = \"" << to_string(deform.guard) << "\"\n";
    return text.str();
}

CaseFile fitted_case(const std::string& mesh, const std::vector<std::string>& markers, int points)
{
    const TemporaryFolder folder;
    std::vector<std::string> arguments{mesh, "--points", std::to_string(points), "-o",
                                       folder.file("case.toml")};
    for (const std::string& marker : markers)
        arguments.insert(arguments.end(), {"--marker", marker});
    const ProcessResult result = run_tool("morph-fit", arguments);
    if (result.status != 0)
        throw std::runtime_error("morph-fit: " + result.errors);
    CaseFile file = read_case_file(folder.file("case.toml"));
    file.mesh_file = mesh;
    return file;
}

void turn(CaseFile& file, double degrees, const Eigen::Vector2d& centre)
{
    const Eigen::Matrix2d R = Eigen::Rotation2Dd(degrees * std::numbers::pi / 180).toRotationMatrix();
    for (CurveMove& entry : file.motion.curves) {
        const Points2 arms = entry.curve.control_points.rowwise() - centre.transpose();
        entry.displacements = arms * R.transpose() - arms;
    }
}

void shift(CaseFile& file, const Eigen::Vector2d& shift)
{
    for (CurveMove& entry : file.motion.curves)
        entry.displacements =
            Points2(entry.curve.control_points.rows(), 2).setZero().rowwise() + shift.transpose();
}

} // namespace morph::test
