#include "libmorph/geometry/size_field.h"

#include <algorithm>

namespace morph {

namespace {

constexpr Index kLeafSize = 8;

} // namespace

SizeField::SizeField(std::vector<SizeSample> samples, double growth, double largest)
    : samples_(std::move(samples)), growth_(growth), largest_(largest)
{
    if (!samples_.empty())
        build(0, 0, static_cast<Index>(samples_.size()));
}

void SizeField::build(std::size_t node, Index begin, Index end)
{
    if (node >= nodes_.size())
        nodes_.resize(node + 1);
    Node made{samples_[begin].point, samples_[begin].point, samples_[begin].size, begin, end, true};
    for (Index i = begin; i < end; ++i) {
        made.low = made.low.cwiseMin(samples_[i].point);
        made.high = made.high.cwiseMax(samples_[i].point);
        made.smallest = std::min(made.smallest, samples_[i].size);
    }
    made.leaf = end - begin <= kLeafSize;
    nodes_[node] = made;
    if (made.leaf)
        return;
    const Eigen::Vector2d extent = made.high - made.low;
    const int axis = extent.x() >= extent.y() ? 0 : 1;
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(
        samples_.begin() + begin, samples_.begin() + middle, samples_.begin() + end,
        [axis](const SizeSample& a, const SizeSample& b) { return a.point[axis] < b.point[axis]; });
    build(2 * node + 1, begin, middle);
    build(2 * node + 2, middle, end);
}

double SizeField::lower_bound(std::size_t node, const Eigen::Vector2d& x) const
{
    const Node& box = nodes_[node];
    const Eigen::Vector2d outside = (box.low - x).cwiseMax(x - box.high).cwiseMax(0.0);
    return box.smallest + growth_ * outside.norm();
}

void SizeField::search(std::size_t node, const Eigen::Vector2d& x, double& best) const
{
    const Node& here = nodes_[node];
    if (here.leaf) {
        for (Index i = here.begin; i < here.end; ++i)
            best = std::min(best, samples_[i].size + growth_ * (samples_[i].point - x).norm());
        return;
    }
    std::size_t near = 2 * node + 1;
    std::size_t far = 2 * node + 2;
    double near_bound = lower_bound(near, x);
    double far_bound = lower_bound(far, x);
    if (far_bound < near_bound) {
        std::swap(near, far);
        std::swap(near_bound, far_bound);
    }
    if (near_bound < best)
        search(near, x, best);
    if (far_bound < best)
        search(far, x, best);
}

double SizeField::operator()(const Eigen::Vector2d& x) const
{
    double best = largest_;
    if (!nodes_.empty() && lower_bound(0, x) < best)
        search(0, x, best);
    return best;
}

} // namespace morph
