#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <cstddef>
#include <vector>

namespace morph {

inline constexpr int kMaxLatticeDegree = 31;

/// Values of the degree + 1 functions of an axis that are not zero on one span.
using AxisValues = std::array<double, kMaxLatticeDegree + 1>;

/// One direction of a lattice: clamped B-splines over [0, 1]; with a single span they are the Bernstein
/// polynomials. Made for millions of evaluations: what depends on the span alone is computed once.
class SplineAxis {
public:
    static constexpr int kAnyDegree = -1;

    /// The constant 1, one control point: the third direction of a planar lattice.
    SplineAxis() : SplineAxis(0, {0, 1}) {}

    /// @param degree  0 to kMaxLatticeDegree
    /// @param knots   clamped, from 0 to 1, at least one span that is not empty
    SplineAxis(int degree, std::vector<double> knots);

    int degree() const { return degree_; }
    Index point_count() const { return static_cast<Index>(knots_.size()) - degree_ - 1; }
    const std::vector<double>& knots() const { return knots_; }

    /// The spans that are not empty, ascending; span s carries the functions s - degree ... s.
    std::vector<int> spans() const;

    /// The span with knot s <= u < knot s + 1; the last one for u = 1.
    /// @param u  in [0, 1]
    int span(double u) const
    {
        const auto bin = static_cast<std::size_t>(u * static_cast<double>(first_span_.size()));
        int s = first_span_[bin < first_span_.size() ? bin : first_span_.size() - 1];
        while (s < last_span_ && u >= knots_[static_cast<std::size_t>(s) + 1])
            ++s;
        return s;
    }

    /// The functions of a span at @p u and, with @p slopes, their derivatives, by the recursion of Cox and de
    /// Boor [Piegl & Tiller, The NURBS Book, 2.2 and 2.3].
    ///
    /// @param span         from find_span()
    /// @param u            also outside the span, where its polynomials go on
    /// @param values       degree + 1 numbers
    /// @param derivatives  degree + 1 numbers; not touched without @p slopes
    /// @tparam fixed_degree  degree(), where the caller knows it when it is compiled: several times faster
    /// @tparam Number        double, or a Pack of them
    template <int fixed_degree = kAnyDegree, bool slopes = false, typename Number = double>
    [[gnu::always_inline]] void evaluate(int span, const Number& u, Number* values,
                                         Number* derivatives = nullptr) const
    {
        const int p = fixed_degree == kAnyDegree ? degree_ : fixed_degree;
        const double* knot = knots_.data() + span;
        const std::ptrdiff_t intervals = std::ptrdiff_t{p} * (p + 1) / 2;
        const double* inverse = inverse_lengths_.data() + (span - p) * intervals;
        values[0] = Number{} + 1.0;
        Number before{};
        for (int level = 1; level <= p; ++level) {
            Number carried{};
            for (int r = 0; r < level; ++r) {
                const Number share = values[r] * *inverse++;
                values[r] = carried + (knot[r + 1] - u) * share;
                carried = (u - knot[r + 1 - level]) * share;
                if (slopes && level == p) {
                    derivatives[r] = p * (before - share);
                    before = share;
                }
            }
            values[level] = carried;
        }
        if (slopes)
            derivatives[p] = p * before;
    }

    /// Where a control point has to be for the axis to be affine in u: the mean of its inner knots
    /// (Greville).
    double greville(Index i) const;

private:
    int degree_;
    int last_span_;
    std::vector<double> knots_;
    std::vector<double> inverse_lengths_; ///< per span, of the knot intervals in the order of the recursion
    std::vector<int> first_span_;         ///< for each of equal parts of [0, 1], a span at or before it
};

} // namespace morph
