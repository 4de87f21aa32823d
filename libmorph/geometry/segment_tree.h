#pragma once

#include "libmorph/core/types.h"
#include "libmorph/geometry/box_tree.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace morph {

/// Finds the nearest of many segments in the plane or in space: a tree of bounding boxes.
class SegmentTree {
public:
    struct Nearest {
        Index segment = 0;   ///< number in the list given; among equally near ones, any
        double distance = 0; ///< length unit of the points
    };

    /// @param points    n x 3
    /// @param segments  at least one pair of distinct or equal rows of @p points
    /// @throws InputError  there is no segment
    SegmentTree(const Eigen::Ref<const Points>& points, const std::vector<std::array<Index, 2>>& segments);

    /// The segment nearest to a point.
    /// @param hint  a segment likely to be near, such as the answer for a point nearby: it only saves time
    Nearest nearest(const Eigen::Vector3d& point, Index hint = 0) const;

    /// The segment nearest to (x, y, 0).
    Nearest nearest(double x, double y, Index hint = 0) const { return nearest({x, y, 0}, hint); }

private:
    struct Segment {
        Eigen::Vector3d a, b;
    };

    static double distance2(const Segment& s, const Eigen::Vector3d& p);

    std::vector<Segment> segments_; ///< in the order of the tree
    std::vector<Index> rank_;       ///< of segment number i in it
    BoxTree tree_;
};

} // namespace morph
