#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <array>

namespace morph {

/// Corner points of an element in order around it; the fourth of a triangle is not looked at.
using CornerPoints = std::array<Eigen::Vector3d, 4>;

/// What every metric of an element is computed from.
struct ElementShape {
    int corners = 3;                  ///< 3 or 4
    std::array<double, 4> jacobian{}; ///< at each corner: edge to the next x edge to the previous; sign exact
    std::array<double, 4> dot{};      ///< scalar product of the same two edges
    std::array<double, 4> length{};   ///< of the edge from each corner to the next
    double area = 0;                  ///< signed: negative when the element runs clockwise
};

/// Shape of an element of a planar mesh (z is not looked at), whose elements run counter-clockwise.
ElementShape planar_shape(const CornerPoints& points, int corners);

/// Shape of an element of a surface. Jacobians and area are taken against the element's own mean normal (the
/// cross product of a quad's diagonals), so a triangle's are never negative.
ElementShape surface_shape(const CornerPoints& points, int corners);

/// Smallest of the corner Jacobians; length unit squared. For a triangle twice its area.
double min_jacobian(const ElementShape& shape);

/// Some corner Jacobian is zero or negative, decided exactly: also a quad of positive area that is dented or
/// degenerate at one corner.
bool is_inverted(const ElementShape& shape);

/// Scaled Jacobian of Verdict [Stimpson et al., The Verdict Library Reference Manual, Sandia 2007]. Quad: the
/// smallest of its corner Jacobians, each over the lengths of its two edges. Triangle: its Jacobian over the
/// largest product of two edges, times 2/sqrt(3).
///
/// In [-1, 1], 1 for a rectangle or an equilateral triangle, 0 when a quad has an edge without length or a
/// triangle is one point.
double scaled_jacobian(const ElementShape& shape);

/// Smallest and largest angle inside an element, degrees.
struct AngleRange {
    double min = 0;
    double max = 0;
};

/// Angles between the edges, on the side the element's own area lies on: a dented quad has one above 180, a
/// triangle turned over has the angles of its mirror image. An angle at an edge without length counts as 0.
AngleRange angle_range(const ElementShape& shape);

/// Aspect ratio of Verdict: longest edge times perimeter over 4 sqrt(3) area (triangle) or 4 area (quad);
/// 1 for an equilateral triangle and a square. The largest double, as in Verdict, where the area is zero.
double aspect_ratio(const ElementShape& shape);

/// Skew metric f_skew of Knupp [2003, Finite Elements in Analysis and Design 39, 217-241].
///
/// Quad: 4 / sum over corners of 1 / sin(angle), 1 for every rectangle. Triangle, whose angles fix its shape:
/// Knupp's shape metric 4 sqrt(3) area / (sum of squared edges), 1 for the equilateral one. 0 when inverted.
double skew(const ElementShape& shape);

/// Size-skew metric f_ss = sqrt(f_size) f_skew [Knupp 2003, in the combination of de Boer, van der Schoot and
/// Bijl 2007, Computers and Structures 85, 784-795] of a deformed element.
///
/// f_size = min(t, 1/t) with t = area over reference area, 0 when either is not positive. In [0, 1].
double size_skew(const ElementShape& shape, double reference_area);

} // namespace morph
