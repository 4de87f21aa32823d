#include "libmorph/quality/quality_accumulator.h"

#include <algorithm>
#include <tuple>

namespace morph {

namespace {

bool is_worse(const WorstElement& a, const WorstElement& b)
{
    return std::tie(a.quality.scaled_jacobian, a.element) < std::tie(b.quality.scaled_jacobian, b.element);
}

/// Count a value in the one of equal bins from 0 to @p end that it lies in, values beyond in the outermost.
template <std::size_t bins>
void count(std::array<Index, bins>& counts, double value, double end)
{
    const double bin = std::clamp(value / end * bins, 0.0, bins - 1.0);
    ++counts[static_cast<std::size_t>(bin)];
}

template <std::size_t bins>
void add_counts(std::array<Index, bins>& counts, const std::array<Index, bins>& other)
{
    for (std::size_t i = 0; i < bins; ++i)
        counts[i] += other[i];
}

} // namespace

void QualityAccumulator::rank(const WorstElement& element)
{
    if (worst.size() == kWorstElements && !is_worse(element, worst.back()))
        return;
    worst.insert(std::upper_bound(worst.begin(), worst.end(), element, is_worse), element);
    worst.resize(std::min(worst.size(), kWorstElements));
}

void QualityAccumulator::add(const WorstElement& element, int corners)
{
    const ElementQuality& q = element.quality;
    triangles += corners == 3 ? 1 : 0;
    negative_area += q.area < 0 ? 1 : 0;
    min_scaled_jacobian = std::min(min_scaled_jacobian, q.scaled_jacobian);
    sum_scaled_jacobian += q.scaled_jacobian;
    min_angle = std::min(min_angle, q.min_angle);
    max_angle = std::max(max_angle, q.max_angle);
    max_aspect_ratio = std::max(max_aspect_ratio, q.aspect_ratio);
    min_size_skew = std::min(min_size_skew, q.size_skew);
    sum_size_skew += q.size_skew;
    if (q.inverted) {
        inverted.push_back(element.face);
    } else {
        count(scaled_jacobian_counts, q.scaled_jacobian, 1);
        count(min_angle_counts, q.min_angle, 90);
    }
    rank(element);
}

void QualityAccumulator::add(const QualityAccumulator& other)
{
    triangles += other.triangles;
    negative_area += other.negative_area;
    inverted.insert(inverted.end(), other.inverted.begin(), other.inverted.end());
    min_scaled_jacobian = std::min(min_scaled_jacobian, other.min_scaled_jacobian);
    sum_scaled_jacobian += other.sum_scaled_jacobian;
    min_angle = std::min(min_angle, other.min_angle);
    max_angle = std::max(max_angle, other.max_angle);
    max_aspect_ratio = std::max(max_aspect_ratio, other.max_aspect_ratio);
    min_size_skew = std::min(min_size_skew, other.min_size_skew);
    sum_size_skew += other.sum_size_skew;
    add_counts(scaled_jacobian_counts, other.scaled_jacobian_counts);
    add_counts(min_angle_counts, other.min_angle_counts);
    for (const WorstElement& element : other.worst)
        rank(element);
}

} // namespace morph
