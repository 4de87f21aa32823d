#pragma once

#include "libmorph/core/types.h"

#include <vector>

namespace morph {

/// Values transferred conservatively to a target, and how much of it the source covers.
struct Transfer {
    Matrix values; ///< one row for each element or vertex of the target; 0 where nothing covers it
    std::vector<double> covered; ///< of each of them: of an element the area that the source covers, of a
                                 ///  vertex the integral of its basis function over that area; 0: nothing
    double covered_area = 0;     ///< of the region common to both meshes; areas in length unit squared
    double target_area = 0;      ///< of all elements of the target
    double source_area = 0;      ///< of all elements of the source
    Eigen::RowVectorXd source_integral; ///< of the source's values over the common region
};

} // namespace morph
