#pragma once

#include "libmorph/basis/curve.h"

#include <cstdint>
#include <string>

namespace morph::test {

/// A reproducible curve: control points around a wobbly circle of radius about 1, knots of uneven
/// spacing; with @p rational also weights between 0.5 and 2.
CurveDefinition wobbly_curve(int degree, Index control_points, bool closed, bool rational,
                             std::uint32_t seed);

/// Control points of a table in tests/data/thesis.
Points2 thesis_points(const std::string& file);

/// The curve of test case 1 of the thesis: closed, degree 2, the table's points in the order 2, 1, 4, 3.
CurveDefinition thesis_case_1();

} // namespace morph::test
