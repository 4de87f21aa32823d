#pragma once

#include "libmorph/deform/controlled_points.h"

#include <vector>

namespace morph {

/// What pull_points() found.
struct Pulled {
    Matrix displacements; ///< K x 2 or K x 3
    Matrix residual;      ///< m x 2 or m x 3: requested minus reached displacement of each point
    Index rank = 0;       ///< how many of the points the control points can move independently
};

/// Move points to their targets by the smallest change of the control points: direct manipulation
/// [Bai & Chen 2013, Applied Mechanics and Materials 390, 121-128, for lattices], for every linear method.
///
/// Of all changes of the given displacements that bring the points nearest to their targets, in the
/// sense of least squares, the one of least norm: W^+ (wanted - W given), with the pseudo-inverse from a
/// complete orthogonal decomposition. Control points that move none of the points keep what is given.
/// Directions of the points that the control points move 1e12 times less than others count as out of reach.
///
/// @param points  m
/// @param wanted  m x 2 or m x 3, displacements from where the points lie undisplaced, given ones included
/// @param given   K x as many, where the change starts
/// @param held    control points that keep their given displacement
/// @throws InputError  the sizes do not fit, a number is not finite, or a held control point does not exist
Pulled pull_points(const ControlledPoints& points, const Matrix& wanted, const Matrix& given,
                   const std::vector<Index>& held = {});

} // namespace morph
