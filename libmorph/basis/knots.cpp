#include "libmorph/basis/knots.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

// Relative to the range of the knots. Shorter spans would only magnify rounding; knots this close
// are equal ones printed with too few digits.
constexpr double kShortestSpan = 1e-9;

} // namespace

void require_increasing(const std::vector<double>& knots)
{
    for (std::size_t j = 0; j < knots.size(); ++j)
        if (!std::isfinite(knots[j]))
            throw InputError("knot " + std::to_string(j + 1) + " is not finite");
    const double range = knots.back() - knots.front();
    if (!(range > 0) || !std::isfinite(range))
        throw InputError("the knots run from " + number_text(knots.front()) + " to " +
                         number_text(knots.back()) + "; they must increase");
    for (std::size_t j = 1; j < knots.size(); ++j) {
        const double step = knots[j] - knots[j - 1];
        if (step < 0)
            throw InputError("knot " + std::to_string(j + 1) + " (" + number_text(knots[j]) +
                             ") is less than the one before it (" + number_text(knots[j - 1]) + ")");
        if (step > 0 && step < kShortestSpan * range)
            throw InputError("knots " + std::to_string(j) + " and " + std::to_string(j + 1) +
                             " nearly coincide at " + number_text(knots[j]) +
                             "; make them equal or part them");
    }
}

void require_clamped(const std::vector<double>& knots, int degree)
{
    const auto p = static_cast<std::size_t>(degree);
    if (knots[p] != knots.front() || knots[knots.size() - 1 - p] != knots.back())
        throw InputError("clamped knots of degree " + std::to_string(p) +
                         " repeat the first and the last value " + std::to_string(p + 1) + " times each");
}

void require_multiplicity(const std::vector<double>& knots, int degree)
{
    const auto inside = [](double u) { return u >= 0 && u <= 1; };
    for (std::size_t j = 0; j < knots.size();) {
        const auto next = std::upper_bound(knots.begin(), knots.end(), knots[j]) - knots.begin();
        const auto repeats = next - static_cast<std::ptrdiff_t>(j);
        const bool clamped_end = repeats == degree + 1 && (j == 0 || next == std::ssize(knots));
        if (inside(knots[j]) && repeats > degree && !clamped_end)
            throw InputError("the knot " + number_text(knots[j]) + " is repeated " + std::to_string(repeats) +
                             " times; degree " + std::to_string(degree) + " allows at most " +
                             std::to_string(degree));
        j = static_cast<std::size_t>(next);
    }
}

void map_to_unit(std::vector<double>& knots)
{
    const double first = knots.front();
    const double range = knots.back() - first;
    for (double& knot : knots)
        knot = (knot - first) / range;
}

} // namespace morph
