#pragma once

namespace morph {

/// Point of the plane.
struct PlanePoint {
    double x = 0;
    double y = 0;
};

/// Exact sign of the signed area of triangle a b c: 1 counter-clockwise, 0 collinear, -1 clockwise.
int orientation(PlanePoint a, PlanePoint b, PlanePoint c);

/// Exact sign of (b - a) x (d - c): 1 when the second vector points to the left of the first, -1 to the
/// right, 0 when they are parallel or one is zero.
int cross_sign(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d);

/// Exact place of d relative to the circle through the counter-clockwise triangle a b c:
/// 1 inside, 0 on it, -1 outside.
int in_circle(PlanePoint a, PlanePoint b, PlanePoint c, PlanePoint d);

} // namespace morph
