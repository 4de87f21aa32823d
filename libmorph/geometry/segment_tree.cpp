#include "libmorph/geometry/segment_tree.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

constexpr Index kLeaf = 4;        // segments in a leaf
constexpr std::size_t kDeep = 64; // the tree halves its segments: 32 levels at most

double square(double x)
{
    return x * x;
}

} // namespace

SegmentTree::SegmentTree(const Eigen::Ref<const Points>& points,
                         const std::vector<std::array<Index, 2>>& segments)
    : place_(segments.size())
{
    if (segments.empty())
        throw InputError("the distance to moving edges is asked for, but there are no moving edges");
    for (const auto& [a, b] : segments)
        segments_.push_back(
            {points(a, 0), points(a, 1), points(b, 0), points(b, 1), static_cast<Index>(segments_.size())});
    nodes_.resize(1);
    build(0, 0, static_cast<Index>(segments_.size()));
    for (std::size_t i = 0; i < segments_.size(); ++i)
        place_[static_cast<std::size_t>(segments_[i].number)] = static_cast<Index>(i);
}

void SegmentTree::build(std::size_t node, Index begin, Index end)
{
    Node box{HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL, begin, end, -1};
    for (Index i = begin; i < end; ++i) {
        const Segment& s = segments_[static_cast<std::size_t>(i)];
        box.min_x = std::min({box.min_x, s.ax, s.bx});
        box.min_y = std::min({box.min_y, s.ay, s.by});
        box.max_x = std::max({box.max_x, s.ax, s.bx});
        box.max_y = std::max({box.max_y, s.ay, s.by});
    }
    if (end - begin > kLeaf) {
        const bool along_x = box.max_x - box.min_x >= box.max_y - box.min_y;
        const Index middle = begin + (end - begin) / 2;
        std::nth_element(segments_.begin() + begin, segments_.begin() + middle, segments_.begin() + end,
                         [along_x](const Segment& s, const Segment& t) {
                             return along_x ? s.ax + s.bx < t.ax + t.bx : s.ay + s.by < t.ay + t.by;
                         });
        box.left = static_cast<Index>(nodes_.size());
        nodes_.resize(nodes_.size() + 2);
        const auto left = static_cast<std::size_t>(box.left);
        build(left, begin, middle);
        build(left + 1, middle, end);
    }
    nodes_[node] = box;
}

double SegmentTree::distance2(const Segment& s, double x, double y)
{
    const double dx = s.bx - s.ax, dy = s.by - s.ay;
    const double length2 = dx * dx + dy * dy;
    const double along = (x - s.ax) * dx + (y - s.ay) * dy;
    if (along <= 0 || length2 == 0)
        return square(x - s.ax) + square(y - s.ay);
    if (along >= length2)
        return square(x - s.bx) + square(y - s.by);
    return square((x - s.ax) * dy - (y - s.ay) * dx) / length2;
}

double SegmentTree::distance2(const Node& n, double x, double y)
{
    const double dx = std::max({n.min_x - x, x - n.max_x, 0.0});
    const double dy = std::max({n.min_y - y, y - n.max_y, 0.0});
    return dx * dx + dy * dy;
}

SegmentTree::Nearest SegmentTree::nearest(double x, double y, Index hint) const
{
    const Segment* best = &segments_[static_cast<std::size_t>(place_[static_cast<std::size_t>(hint)])];
    double best2 = distance2(*best, x, y);
    std::array<Index, kDeep> waiting{};
    std::size_t count = 1;
    while (count > 0) {
        const Node& node = nodes_[static_cast<std::size_t>(waiting[--count])];
        if (distance2(node, x, y) >= best2)
            continue;
        if (node.left < 0) {
            for (Index i = node.begin; i < node.end; ++i)
                if (const double d2 = distance2(segments_[static_cast<std::size_t>(i)], x, y); d2 < best2) {
                    best2 = d2;
                    best = &segments_[static_cast<std::size_t>(i)];
                }
            continue;
        }
        const auto left = static_cast<std::size_t>(node.left);
        const bool left_first = distance2(nodes_[left], x, y) <= distance2(nodes_[left + 1], x, y);
        waiting[count++] = node.left + (left_first ? 1 : 0);
        waiting[count++] = node.left + (left_first ? 0 : 1);
    }
    return {best->number, std::sqrt(best2)};
}

} // namespace morph
