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

/// Bernstein coefficient @p lasts of the piece of a spline between two parameters of one span: its polar form
/// with that many arguments @p end and the others @p begin.
/// @param knots  in the form of extended_knots()
/// @param local  the degree + 1 coefficients of the span; overwritten
template <class Value>
Value bernstein_coefficient(const std::vector<double>& knots, int span, double begin, double end, int lasts,
                            std::span<Value> local)
{
    const auto p = static_cast<int>(local.size()) - 1;
    const auto knot = knots.begin() + span;
    for (int level = 1; level <= p; ++level) {
        const double u = level <= lasts ? end : begin;
        for (int k = p; k >= level; --k) {
            const double low = knot[k - p];
            const double share = (u - low) / (knot[k + 1 - level] - low);
            const auto at = static_cast<std::size_t>(k);
            local[at] = (1 - share) * local[at - 1] + share * local[at];
        }
    }
    return local.back();
}

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
