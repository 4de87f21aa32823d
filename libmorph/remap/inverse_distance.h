#pragma once

#include "libmorph/core/types.h"

#include <span>
#include <vector>

namespace morph {

/// How values are weighted by inverse distance; the defaults are the thesis's.
struct InverseDistance {
    int neighbors = 100; ///< at least 1
    double power = 5;    ///< positive
};

/// Fill rows of matrices from other rows by inverse distance weighting [thesis, 4.3, equation (4.6); Shepard
/// 1968, Proceedings of the 23rd ACM National Conference, 517-524]: with the nearest known points k at
/// distances r_k, the value is sum_k f_k r_k^-c / sum_k r_k^-c.
///
/// At a known point it is that point's value (of several, that of the lowest row), exactly; where all
/// neighbours have one value, it is that value, exactly; it is never outside of their range. O(u log n) for u
/// unknown points, in bounded memory, equal bytes for any thread count.
///
/// @param positions  n x 3, finite
/// @param known      rows whose values are given, at least one
/// @param unknown    rows to fill, none of them known
/// @param settings   number of neighbours and power
/// @param values     matrices of n rows each, any number of columns
/// @throws InputError  no known point; neighbors, power or a row out of range; a matrix without n rows; see
///                     NearestPoints
void fill_by_inverse_distance(const Eigen::Ref<const Points>& positions, const std::vector<Index>& known,
                              const std::vector<Index>& unknown, const InverseDistance& settings,
                              std::span<Matrix> values);

} // namespace morph
