#pragma once

#include "libmorph/core/types.h"

#include <array>
#include <vector>

namespace morph {

/// Finds the nearest of many segments in the plane: a tree of bounding boxes.
class SegmentTree {
public:
    struct Nearest {
        Index segment = 0;   ///< number in the list given; among equally near ones, any
        double distance = 0; ///< length unit of the points
    };

    /// @param points    n x 3, z is ignored
    /// @param segments  at least one pair of distinct or equal rows of @p points
    /// @throws InputError  there is no segment
    SegmentTree(const Eigen::Ref<const Points>& points, const std::vector<std::array<Index, 2>>& segments);

    /// The segment nearest to (x, y).
    /// @param hint  a segment likely to be near, such as the answer for a point nearby: it only saves time
    Nearest nearest(double x, double y, Index hint = 0) const;

private:
    struct Segment {
        double ax, ay, bx, by;
        Index number;
    };
    /// Box of segments [begin, end); a branch has its children at left and left + 1.
    struct Node {
        double min_x, min_y, max_x, max_y;
        Index begin, end;
        Index left;
    };

    void build(std::size_t node, Index begin, Index end);
    static double distance2(const Segment& s, double x, double y);
    static double distance2(const Node& n, double x, double y);

    std::vector<Segment> segments_;
    std::vector<Index> place_; ///< of segment number i in segments_
    std::vector<Node> nodes_;
};

} // namespace morph
