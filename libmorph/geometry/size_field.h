#pragma once

#include "libmorph/geometry/box_tree.h"

#include <Eigen/Core>

#include <vector>

namespace morph {

/// Target edge length at a place.
struct SizeSample {
    Eigen::Vector2d point;
    double size = 0;
};

/// The target edge length anywhere in the plane: min(largest, min_i size_i + growth |x - x_i|).
///
/// It is the largest function below the samples whose slope is at most growth, so lengths of
/// neighbouring edges differ little [Persson 2006, Mesh size functions for implicit geometries].
class SizeField {
public:
    SizeField(const std::vector<SizeSample>& samples, double growth, double largest);

    /// Cost: logarithmic in the number of samples, none far from them.
    double operator()(const Eigen::Vector2d& x) const;

private:
    std::vector<SizeSample> samples_; ///< in the order of the tree
    BoxTree tree_;                    ///< of (x, y, size): the least z of a box is the smallest size in it
    double growth_;
    double largest_;
};

} // namespace morph
