#pragma once

#include "libmorph/core/predicates.h"

namespace morph {

/// Where a point is at time 0 and at time 1; between them it goes straight on at one speed.
struct MovingPoint {
    PlanePoint start;
    PlanePoint end;
};

/// A corner of an element whose three points move: itself and its neighbours counter-clockwise and clockwise.
struct MovingCorner {
    MovingPoint corner;
    MovingPoint next;
    MovingPoint previous;
};

/// Whether the corner turns left at every time from 0 to @p time: exact, for the doubles given, without the
/// rounding that positions written at that time have.
///
/// The Jacobian (next - corner) x (previous - corner) is a quadratic of the time. With Bernstein coefficients
/// b0, b1, b2 on [0, time] it is positive there exactly if b0 > 0, b2 > 0 and b1 > -sqrt(b0 b2)
/// [Farouki and Rajan 1988, Computer Aided Geometric Design 5, 1-26].
/// @param time  from 0 to 1
/// @return false also when a coordinate is not finite
bool stays_positive_until(const MovingCorner& corner, double time);

/// About the time at which the corner first stops turning left: in [0, 1], and 1 if it never does.
double turning_time(const MovingCorner& corner);

} // namespace morph
