#include "libmorph/geometry/size_field.h"

namespace morph {

namespace {

constexpr Index kLeafSize = 8;

std::vector<BoxTree::Box> boxes_around(const std::vector<SizeSample>& samples)
{
    std::vector<BoxTree::Box> boxes;
    boxes.reserve(samples.size());
    for (const SizeSample& sample : samples)
        boxes.emplace_back(Eigen::Vector3d(sample.point.x(), sample.point.y(), sample.size));
    return boxes;
}

} // namespace

SizeField::SizeField(const std::vector<SizeSample>& samples, double growth, double largest)
    : tree_(boxes_around(samples), kLeafSize, 2), growth_(growth), largest_(largest)
{
    samples_.reserve(samples.size());
    for (const Index i : tree_.order())
        samples_.push_back(samples[static_cast<std::size_t>(i)]);
}

double SizeField::operator()(const Eigen::Vector2d& x) const
{
    const auto least_in_box = [&](const BoxTree::Box& box) {
        const Eigen::Vector2d low = box.min().head<2>(), high = box.max().head<2>();
        return box.min().z() + growth_ * (low - x).cwiseMax(x - high).cwiseMax(0.0).norm();
    };
    const auto from_sample = [&](Index rank) {
        const SizeSample& sample = samples_[static_cast<std::size_t>(rank)];
        return sample.size + growth_ * (sample.point - x).norm();
    };
    return tree_.least(least_in_box, from_sample, {-1, largest_}).value;
}

} // namespace morph
