#include "tests/support/domains.h"

#include "tests/support/curves.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace morph::test {

Curve closed_curve(int degree, const std::vector<std::array<double, 2>>& points, std::vector<double> knots)
{
    CurveDefinition definition;
    definition.degree = degree;
    definition.closed = true;
    definition.knots = std::move(knots);
    definition.control_points.resize(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i)
        definition.control_points.row(static_cast<Eigen::Index>(i)) << points[i][0], points[i][1];
    return Curve(definition);
}

Curve round_curve(double x, double y, double radius)
{
    std::vector<std::array<double, 2>> points;
    for (int i = 0; i < 8; ++i)
        points.push_back({x + radius * std::cos(i * std::numbers::pi / 4),
                          y + radius * std::sin(i * std::numbers::pi / 4)});
    return closed_curve(3, points);
}

Curve clockwise(const Curve& curve)
{
    CurveDefinition definition = curve.definition();
    definition.control_points = definition.control_points.colwise().reverse().eval();
    return Curve(definition);
}

Curve sharp_airfoil()
{
    const std::vector<std::array<double, 2>> points = {{1, 0},     {0.7, 0.08},  {0.35, 0.13},  {0.05, 0.1},
                                                       {-0.02, 0}, {0.05, -0.1}, {0.35, -0.13}, {0.7, -0.08}};
    // The corner is a knot of multiplicity 3 at the start of the period.
    return closed_curve(3, points, {0, 0, 0, 1. / 6, 2. / 6, 3. / 6, 4. / 6, 5. / 6, 1});
}

Curve notched_square()
{
    return closed_curve(1, {{-1, -1}, {1, -1}, {1, 0.9}, {0, 0.95}, {1, 1}, {-1, 1}});
}

DomainSpec thesis_case(int number)
{
    DomainSpec spec{kThesisBox, 1.0, {}};
    if (number == 1) {
        spec.curves.push_back({"body", Curve(thesis_case_1()), 100});
        return spec;
    }
    for (const char* which : {"1", "2"}) {
        CurveDefinition definition;
        definition.degree = 3;
        definition.closed = true;
        definition.control_points = thesis_points("case2_curve" + std::string(which) + "_control_points.csv");
        spec.curves.push_back({"body" + std::string(which), Curve(definition), 100});
    }
    return spec;
}

} // namespace morph::test
