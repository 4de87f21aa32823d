#pragma once

#include "libmorph/core/types.h"

#include <cstddef>
#include <vector>

namespace morph {

/// Sparse symmetric n x n matrix by rows: the diagonal apart, both triangles of the rest.
struct SymmetricMatrix {
    std::vector<double> diagonal;   ///< n
    std::vector<std::size_t> start; ///< n + 1: the rest of row i is at start[i] to start[i + 1] - 1 below
    std::vector<Index> column;      ///< in any order, never the row itself
    std::vector<double> value;      ///< entries of the same row and column add up

    Index rows() const { return static_cast<Index>(diagonal.size()); }
};

} // namespace morph
