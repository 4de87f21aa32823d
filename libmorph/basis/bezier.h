#pragma once

#include "libmorph/basis/curve.h"

#include <cstddef>
#include <span>
#include <vector>

namespace morph {

/// One polynomial (or rational) piece of a curve in Bernstein form.
struct BezierPiece {
    double begin = 0; ///< parameters of the curve where the piece begins and ends
    double end = 0;
    std::vector<Eigen::Vector3d> control; ///< degree + 1 points (w x, w y, w)
};

/// The pieces of a curve between its breakpoints, in order; together they are the curve.
/// Each comes from the polar form of the piece [Ramshaw 1989, Computer Aided Geometric Design 6, 323-358].
std::vector<BezierPiece> bezier_pieces(const Curve& curve);

/// Split a polynomial in Bernstein form over [0, 1] at 1/2 (de Casteljau).
/// @param whole  its coefficients; on return those of the right half
/// @param left   as many, receives the left half
template <class Value>
void split_in_half(std::span<Value> whole, std::span<Value> left)
{
    for (std::size_t level = 0; level < whole.size(); ++level) {
        left[level] = whole[0];
        for (std::size_t i = 0; i + level + 1 < whole.size(); ++i)
            whole[i] = 0.5 * (whole[i] + whole[i + 1]);
    }
}

} // namespace morph
