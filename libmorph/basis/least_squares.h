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

/// One step towards the curve that is nearest to points whatever their parameters.
///
/// Minimises (distance along the normal of the curve at u)^2 + @p tangential x (distance along its
/// tangent)^2. With 1 the result is least_squares_points(); a small value lets points slide along the
/// curve and brings a sequence of steps and projections to its end many times sooner
/// [Wang, Pottmann & Liu 2006, ACM Transactions on Graphics 25(2), 214-238, TDM with a share of PDM].
/// Parameters, result and errors as least_squares_points().
Points2 fitting_step(const Curve& curve, const Points2& points, const std::vector<double>& u,
                     const std::vector<Index>& interpolated, double tangential);

} // namespace morph
