#include "libmorph/basis/bspline.h"

#include <algorithm>

namespace morph {

std::vector<double> uniform_knots(int degree, Index control_points, bool closed)
{
    std::vector<double> knots;
    const int spans = closed ? control_points : control_points - degree;
    const int repeats = closed ? 0 : degree;
    knots.insert(knots.end(), static_cast<std::size_t>(repeats), 0.0);
    for (int j = 0; j <= spans; ++j)
        knots.push_back(static_cast<double>(j) / spans);
    knots.insert(knots.end(), static_cast<std::size_t>(repeats), 1.0);
    return knots;
}

std::vector<double> extended_knots(int degree, bool closed, const std::vector<double>& knots)
{
    if (!closed)
        return knots;
    const auto period = static_cast<Index>(knots.size()) - 1;
    std::vector<double> extended;
    extended.reserve(knots.size() + 2 * static_cast<std::size_t>(degree));
    for (Index j = -degree; j <= period + degree; ++j) {
        const int shift = j < 0 ? -1 : j > period ? 1 : 0;
        extended.push_back(knots[static_cast<std::size_t>(j - shift * period)] + shift);
    }
    return extended;
}

int find_span(const std::vector<double>& knots, int degree, double u)
{
    const auto first = knots.begin() + degree;
    const auto last = knots.end() - 1 - degree;
    auto after = std::upper_bound(first, last, u);
    if (after == last)
        after = std::lower_bound(first, last, *last);
    return static_cast<int>(after - knots.begin()) - 1;
}

SpanValues basis_functions(const std::vector<double>& knots, int span, int degree, double u)
{
    const auto knot = [&](int i) { return knots[static_cast<std::size_t>(i)]; };
    SpanValues values{1.0};
    for (int p = 1; p <= degree; ++p) {
        double carried = 0;
        for (int r = 0; r < p; ++r) {
            const double right = knot(span + r + 1) - u;
            const double left = u - knot(span + 1 - p + r);
            const double share = values[static_cast<std::size_t>(r)] / (right + left);
            values[static_cast<std::size_t>(r)] = carried + right * share;
            carried = left * share;
        }
        values[static_cast<std::size_t>(p)] = carried;
    }
    return values;
}

} // namespace morph
