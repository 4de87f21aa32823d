#include "libmorph/basis/spline_axis.h"

#include "libmorph/basis/bspline.h"

#include <algorithm>
#include <utility>

namespace morph {

SplineAxis::SplineAxis(int degree, std::vector<double> knots)
    : degree_(degree), last_span_(find_span(knots, degree, 1)), knots_(std::move(knots))
{
    const auto knot = [&](int i) { return knots_[static_cast<std::size_t>(i)]; };
    for (int s = degree; s <= last_span_; ++s)
        for (int level = 1; level <= degree; ++level)
            for (int r = 0; r < level; ++r) {
                const double length = knot(s + r + 1) - knot(s + r + 1 - level);
                inverse_lengths_.push_back(length > 0 ? 1 / length : 0);
            }
    const int bins = 2 * (last_span_ - degree + 1);
    for (int bin = 0; bin < bins; ++bin) // half a bin early, whatever u * bins is rounded to
        first_span_.push_back(find_span(knots_, degree, std::max(0.0, (bin - 0.5) / bins)));
}

std::vector<int> SplineAxis::spans() const
{
    std::vector<int> spans;
    for (int s = degree_; s <= last_span_; ++s)
        if (knots_[static_cast<std::size_t>(s)] < knots_[static_cast<std::size_t>(s) + 1])
            spans.push_back(s);
    return spans;
}

double SplineAxis::greville(Index i) const
{
    double sum = 0;
    const auto knot = knots_.begin() + i;
    for (int k = 1; k <= degree_; ++k)
        sum += knot[k];
    return degree_ == 0 ? 0 : sum / degree_;
}

} // namespace morph
