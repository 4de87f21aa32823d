#pragma once

#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <vector>

namespace morph {

/// Wanted edge length at a place.
struct SizeSample {
    Eigen::Vector2d point;
    double size = 0;
};

/// The edge length wanted anywhere in the plane: min(largest, min_i size_i + growth |x - x_i|).
///
/// It is the largest function below the samples whose slope is at most growth, so lengths of
/// neighbouring edges differ little [Persson 2006, Mesh size functions for implicit geometries].
class SizeField {
public:
    SizeField(std::vector<SizeSample> samples, double growth, double largest);

    /// Cost: logarithmic in the number of samples, none far from them.
    double operator()(const Eigen::Vector2d& x) const;

private:
    /// A range of samples with its bounding box; the children of node k are 2k + 1 and 2k + 2.
    struct Node {
        Eigen::Vector2d low, high;
        double smallest = 0;
        Index begin = 0, end = 0;
        bool leaf = true;
    };

    void build(std::size_t node, Index begin, Index end);
    double lower_bound(std::size_t node, const Eigen::Vector2d& x) const;
    void search(std::size_t node, const Eigen::Vector2d& x, double& best) const;

    std::vector<SizeSample> samples_;
    std::vector<Node> nodes_;
    double growth_;
    double largest_;
};

} // namespace morph
