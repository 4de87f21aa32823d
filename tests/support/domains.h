#pragma once

#include "libmorph/geometry/mesh_domain.h"

#include <array>
#include <vector>

namespace morph::test {

/// The outer rectangle of the thesis's cases.
inline constexpr std::array<double, 4> kThesisBox = {-15, -5, 25, 25};

/// Closed curve over its control points in order; uniform knots when none are given.
Curve closed_curve(int degree, const std::vector<std::array<double, 2>>& points,
                   std::vector<double> knots = {});

/// Nearly a circle about (x, y), counter-clockwise.
Curve round_curve(double x, double y, double radius);

/// The curve the other way round.
Curve clockwise(const Curve& curve);

/// A thick airfoil of unit chord whose upper and lower sides meet in a sharp trailing edge at u = 0.
Curve sharp_airfoil();

/// A square with a wedge of 5.7 degrees cut into its right side: a small corner of the domain.
Curve notched_square();

/// Test case 1 or 2 of the thesis, 100 nodes on each curve.
DomainSpec thesis_case(int number);

} // namespace morph::test
