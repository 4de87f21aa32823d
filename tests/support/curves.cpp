#include "tests/support/curves.h"

#include "formats/csv/table.h"
#include "tests/support/meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace morph::test {

namespace {

std::vector<double> uneven_knots(const std::vector<double>& uniform, double shift)
{
    std::vector<double> knots = uniform;
    for (double& knot : knots)
        knot = knot + 0.05 * std::sin(2 * std::numbers::pi * knot) * shift;
    knots.front() = 0;
    knots.back() = 1;
    for (double& knot : knots) // the sine of a full turn is not quite zero
        knot = knot > 1 - 1e-12 ? 1 : knot;
    return knots;
}

} // namespace

CurveDefinition wobbly_curve(int degree, Index control_points, bool closed, bool rational, std::uint32_t seed)
{
    std::mt19937 random(seed); // its bits are the same everywhere, unlike those of the distributions
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
    CurveDefinition curve;
    curve.degree = degree;
    curve.closed = closed;
    curve.control_points.resize(control_points, 2);
    for (Index i = 0; i < control_points; ++i) {
        const double angle =
            2 * std::numbers::pi * (i + 0.4 * number()) / (control_points + (closed ? 0 : 1));
        const double radius = 0.6 + 0.8 * number();
        curve.control_points.row(i) << radius * std::cos(angle), radius * std::sin(angle);
        if (rational)
            curve.weights.push_back(0.5 + 1.5 * number());
    }
    curve.knots = uneven_knots(uniform_knots(degree, control_points, closed), 0.5 + number());
    return curve;
}

Points2 thesis_points(const std::string& file)
{
    return csv_columns(read_csv_table(data_path("thesis/" + file)), {"x", "y"});
}

CurveDefinition thesis_case_1()
{
    const Points2 printed = thesis_points("case1_control_points.csv");
    CurveDefinition curve;
    curve.degree = 2;
    curve.closed = true;
    curve.control_points.resize(4, 2);
    curve.control_points << printed.row(1), printed.row(0), printed.row(3), printed.row(2);
    return curve;
}

} // namespace morph::test
