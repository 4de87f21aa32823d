#pragma once

#include "libmorph/basis/curve.h"

#include <vector>

namespace morph {

/// Control points of the curve that is nearest to points at given parameters, in the sense of least
/// squares [Piegl & Tiller, The NURBS Book, 9.4.1].
///
/// @param shape         degree, knots and weights; its control points are replaced
/// @param points        m x 2
/// @param u             m parameters
/// @param interpolated  rows of @p points the curve passes through exactly; each at an end of an open
///                      curve or at a corner, where a single control point decides
/// @return K x 2
/// @throws InputError   the parameters do not determine the control points: some span of the curve has
///                      too few points (Schoenberg and Whitney's condition)
Points2 least_squares_points(const Curve& shape, const Points2& points, const std::vector<double>& u,
                             const std::vector<Index>& interpolated);

} // namespace morph
