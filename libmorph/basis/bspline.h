#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <vector>

namespace morph {

inline constexpr int kMaxDegree = 7;

/// Values of the degree + 1 B-spline functions that are not zero on one span.
using SpanValues = std::array<double, kMaxDegree + 1>;

/// Uniform knots as a case file would give them: K + 1 values j / K (closed, one period), or the
/// clamped vector of K + degree + 1 values (open), over [0, 1].
std::vector<double> uniform_knots(int degree, Index control_points, bool closed);

/// Knots in the form of the textbooks: span s, from knot s to knot s + 1, carries the functions
/// s - degree ... s, and the curve runs from knot `degree` to the one `degree` before the last.
///
/// Closed: one period with @p degree knots of each neighbouring period, function i stands for control
/// point i mod K. Open: the knots themselves.
std::vector<double> extended_knots(int degree, bool closed, const std::vector<double>& knots);

/// The span s, not empty, with knot s <= u < knot s + 1; the last one at the end of the curve.
/// @param knots   as from extended_knots(); @p u within the curve
/// @param degree  p
/// @param u       parameter, clamped to the range of the knots
int find_span(const std::vector<double>& knots, int degree, double u);

/// N_{span-degree}(u) ... N_{span}(u) by the recursion of Cox and de Boor
/// [Piegl & Tiller, The NURBS Book, algorithm A2.2].
/// @param knots   as from extended_knots(); a lower @p degree than theirs is allowed
/// @param span    from find_span()
/// @param degree  p
/// @param u       parameter inside the span
SpanValues basis_functions(const std::vector<double>& knots, int span, int degree, double u);

} // namespace morph
