#pragma once

#include <vector>

namespace morph {

/// Check that knots are finite, do not decrease, and are either equal or at least 1e-9 of their range apart.
/// @throws InputError  names the knot, counted from 1
void require_increasing(const std::vector<double>& knots);

/// Check that the first and the last knot are there degree + 1 times.
/// @param knots  at least degree + 1
/// @throws InputError  they are not
void require_clamped(const std::vector<double>& knots, int degree);

/// Check that no knot in [0, 1] is there more than @p degree times, but for the clamped ends.
/// @param knots  over [0, 1], as from extended_knots()
/// @throws InputError  names the knot
void require_multiplicity(const std::vector<double>& knots, int degree);

/// Map knots to [0, 1]; their range is not zero.
void map_to_unit(std::vector<double>& knots);

} // namespace morph
