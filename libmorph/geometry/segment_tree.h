#pragma once

#include "libmorph/core/types.h"

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
        Index number;
    };
    /// Box of segments [begin, end); a branch has its children at left and left + 1.
    struct Node {
        Eigen::Vector3d low, high;
        Index begin, end;
        Index left;
    };

    void build(std::size_t node, Index begin, Index end);
    static double distance2(const Segment& s, const Eigen::Vector3d& p);
    static double distance2(const Node& n, const Eigen::Vector3d& p);

    std::vector<Segment> segments_;
    std::vector<Index> place_; ///< of segment number i in segments_
    std::vector<Node> nodes_;
};

} // namespace morph
