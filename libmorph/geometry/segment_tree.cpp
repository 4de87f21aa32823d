#include "libmorph/geometry/segment_tree.h"

#include "libmorph/core/error.h"

#include <Eigen/Geometry>

#include <cmath>

namespace morph {

namespace {

constexpr Index kLeafSize = 4;

std::vector<BoxTree::Box> boxes_around(const Eigen::Ref<const Points>& points,
                                       const std::vector<std::array<Index, 2>>& segments)
{
    std::vector<BoxTree::Box> boxes;
    boxes.reserve(segments.size());
    for (const auto& [a, b] : segments)
        boxes.emplace_back(points.row(a).transpose()).extend(points.row(b).transpose());
    return boxes;
}

} // namespace

SegmentTree::SegmentTree(const Eigen::Ref<const Points>& points,
                         const std::vector<std::array<Index, 2>>& segments)
    : rank_(segments.size()), tree_(boxes_around(points, segments), kLeafSize, 3)
{
    if (segments.empty())
        throw InputError("the distance to moving edges is asked for, but there are no moving edges");
    for (const Index number : tree_.order()) {
        const auto& [a, b] = segments[static_cast<std::size_t>(number)];
        rank_[static_cast<std::size_t>(number)] = static_cast<Index>(segments_.size());
        segments_.push_back({points.row(a), points.row(b)});
    }
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

SegmentTree::Nearest SegmentTree::nearest(const Eigen::Vector3d& point, Index hint) const
{
    const auto to_box2 = [&](const BoxTree::Box& box) {
        return (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0.0).squaredNorm();
    };
    const auto to_segment2 = [&](Index rank) {
        return distance2(segments_[static_cast<std::size_t>(rank)], point);
    };
    const Index start = rank_[static_cast<std::size_t>(hint)];
    const BoxTree::Candidate best = tree_.least(to_box2, to_segment2, {start, to_segment2(start)});
    return {tree_.order()[static_cast<std::size_t>(best.rank)], std::sqrt(best.value)};
}

} // namespace morph
