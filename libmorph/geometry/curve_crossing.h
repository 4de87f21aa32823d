#pragma once

#include "libmorph/basis/curve.h"

#include <optional>

namespace morph {

/// A place where a curve meets itself, or two curves meet each other.
struct CurveCrossing {
    double u = 0;          ///< parameter on the (first) curve
    double v = 0;          ///< parameter on the same curve, u < v, or on the second one
    Eigen::Vector2d point; ///< where it is, to 1e-7 of the curves' size
};

/// A place where a curve crosses or retraces itself, if there is one.
///
/// The pieces are halved until separating lines between their control polygons, or a direction in which
/// joined pieces only advance, prove that they do not meet, or until they are straight to 1e-10 of
/// the curve's size; then their chords decide, by exact predicates. So a crossing is missed, or a near
/// touch taken for one, only where the curve comes within 1e-10 of its size of itself. Equal ends of an
/// open curve are no crossing.
std::optional<CurveCrossing> find_self_crossing(const Curve& curve);

/// A place where two curves meet, if there is one, decided as in find_self_crossing(). Ends of open
/// curves that coincide to 1e-12 of the size, as of two curves that make up one body, do not count.
std::optional<CurveCrossing> find_crossing(const Curve& a, const Curve& b);

} // namespace morph
