#include "libmorph/geometry/segment_tree.h"

#include "libmorph/core/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

constexpr Index kLeaf = 4;        // segments in a leaf
constexpr std::size_t kDeep = 64; // the tree halves its segments: 32 levels at most

} // namespace

SegmentTree::SegmentTree(const Eigen::Ref<const Points>& points,
                         const std::vector<std::array<Index, 2>>& segments)
    : place_(segments.size())
{
    if (segments.empty())
        throw InputError("the distance to moving edges is asked for, but there are no moving edges");
    for (const auto& [a, b] : segments)
        segments_.push_back({points.row(a), points.row(b), static_cast<Index>(segments_.size())});
    nodes_.resize(1);
    build(0, 0, static_cast<Index>(segments_.size()));
    for (std::size_t i = 0; i < segments_.size(); ++i)
        place_[static_cast<std::size_t>(segments_[i].number)] = static_cast<Index>(i);
}

void SegmentTree::build(std::size_t node, Index begin, Index end)
{
    Node box{Eigen::Vector3d::Constant(HUGE_VAL), Eigen::Vector3d::Constant(-HUGE_VAL), begin, end, -1};
    for (Index i = begin; i < end; ++i) {
        const Segment& s = segments_[static_cast<std::size_t>(i)];
        box.low = box.low.cwiseMin(s.a).cwiseMin(s.b);
        box.high = box.high.cwiseMax(s.a).cwiseMax(s.b);
    }
    if (end - begin > kLeaf) {
        Eigen::Index axis = 0;
        (box.high - box.low).maxCoeff(&axis);
        const Index middle = begin + (end - begin) / 2;
        std::nth_element(segments_.begin() + begin, segments_.begin() + middle, segments_.begin() + end,
                         [axis](const Segment& s, const Segment& t) {
                             return s.a[axis] + s.b[axis] < t.a[axis] + t.b[axis];
                         });
        box.left = static_cast<Index>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        const auto left = static_cast<std::size_t>(box.left);
        build(left, begin, middle);
        build(left + 1, middle, end);
    }
    nodes_[node] = box;
}

double SegmentTree::distance2(const Segment& s, const Eigen::Vector3d& p)
{
    const Eigen::Vector3d side = s.b - s.a, away = p - s.a;
    const double length2 = side.squaredNorm(), along = away.dot(side);
    if (along <= 0 || length2 == 0)
        return away.squaredNorm();
    if (along >= length2)
        return (p - s.b).squaredNorm();
    return away.cross(side).squaredNorm() / length2;
}

double SegmentTree::distance2(const Node& n, const Eigen::Vector3d& p)
{
    return (n.low - p).cwiseMax(p - n.high).cwiseMax(0.0).squaredNorm();
}

SegmentTree::Nearest SegmentTree::nearest(const Eigen::Vector3d& point, Index hint) const
{
    const Segment* best = &segments_[static_cast<std::size_t>(place_[static_cast<std::size_t>(hint)])];
    double best2 = distance2(*best, point);
    std::array<Index, kDeep> waiting{};
    std::size_t count = 1;
    while (count > 0) {
        const Node& node = nodes_[static_cast<std::size_t>(waiting[--count])];
        if (distance2(node, point) >= best2)
            continue;
        if (node.left < 0) {
            for (Index i = node.begin; i < node.end; ++i)
                if (const double d2 = distance2(segments_[static_cast<std::size_t>(i)], point); d2 < best2) {
                    best2 = d2;
                    best = &segments_[static_cast<std::size_t>(i)];
                }
            continue;
        }
        const auto left = static_cast<std::size_t>(node.left);
        const bool left_first = distance2(nodes_[left], point) <= distance2(nodes_[left + 1], point);
        waiting[count++] = node.left + (left_first ? 1 : 0);
        waiting[count++] = node.left + (left_first ? 0 : 1);
    }
    return {best->number, std::sqrt(best2)};
}

} // namespace morph
