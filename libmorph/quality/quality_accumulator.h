#pragma once

#include "libmorph/quality/quality.h"

#include <array>
#include <vector>

namespace morph {

/// Sums, extremes and counts over some elements: what a report is made of, block by block.
struct QualityAccumulator {
    Index triangles = 0;
    Index negative_area = 0;
    std::vector<Index> inverted; ///< in the numbering of the mesh
    double min_scaled_jacobian = 1;
    double sum_scaled_jacobian = 0;
    double min_angle = 360;
    double max_angle = 0;
    double max_aspect_ratio = 0;
    double min_size_skew = 1;
    double sum_size_skew = 0;
    std::array<Index, 10> scaled_jacobian_counts{};
    std::array<Index, 9> min_angle_counts{};
    std::vector<WorstElement> worst; ///< worst first, at most kWorstElements

    /// Add one element with 3 or 4 corners.
    void add(const WorstElement& element, int corners);

    /// Add the elements of a later block.
    void add(const QualityAccumulator& other);

private:
    void rank(const WorstElement& element);
};

} // namespace morph
