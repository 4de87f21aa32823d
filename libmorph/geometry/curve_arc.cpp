#include "libmorph/geometry/curve_arc.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

void append_arcs(const Arc& arc, double straight, int depth, std::vector<Arc>& arcs)
{
    if (depth < 2 || (depth < kMaxHalvings && !arc.advances(arc.chord()) && arc.bend() > straight)) {
        for (const Arc& half : arc.halves())
            append_arcs(half, straight, depth + 1, arcs);
        return;
    }
    const auto at_first = [&](const Eigen::Vector2d& point) { return point == arc.first(); };
    if (!std::all_of(arc.points().begin(), arc.points().end(), at_first))
        arcs.push_back(arc);
}

} // namespace

Arc::Arc(double begin, double end, std::span<const Eigen::Vector3d> control)
    : begin_(begin), end_(end), count_(control.size())
{
    std::copy(control.begin(), control.end(), homogeneous_.begin());
    for (std::size_t i = 0; i < count_; ++i)
        point_[i] = control[i].head<2>() / control[i].z();
}

double Arc::bend() const
{
    const double length = chord().norm();
    double largest = 0;
    for (const Eigen::Vector2d& point : points()) {
        const Eigen::Vector2d offset = point - first();
        const double along = offset.dot(chord());
        const bool beside = length > 0 && along >= 0 && along <= length * length;
        const double across = std::abs(chord().x() * offset.y() - chord().y() * offset.x());
        const double distance = beside ? across / length : std::min(offset.norm(), (point - last()).norm());
        largest = std::max(largest, distance);
    }
    return largest;
}

bool Arc::advances(const Eigen::Vector2d& direction) const
{
    for (std::size_t i = 0; i + 1 < count_; ++i)
        if (!((point_[i + 1] - point_[i]).dot(direction) > 0) && point_[i + 1] != point_[i])
            return false;
    return true;
}

std::array<Arc, 2> Arc::halves() const
{
    std::array<Eigen::Vector3d, kMaxDegree + 1> right = homogeneous_;
    std::array<Eigen::Vector3d, kMaxDegree + 1> left;
    const auto left_part = std::span(left).first(count_);
    const auto right_part = std::span(right).first(count_);
    split_in_half(right_part, left_part);
    const double middle = 0.5 * (begin_ + end_);
    return {Arc(begin_, middle, left_part), Arc(middle, end_, right_part)};
}

Arc Arc::reversed() const
{
    std::array<Eigen::Vector3d, kMaxDegree + 1> control = homogeneous_;
    std::reverse(control.begin(), control.begin() + static_cast<std::ptrdiff_t>(count_));
    return {end_, begin_, std::span(control).first(count_)};
}

std::vector<Arc> curve_arcs(const Curve& curve, double straight)
{
    std::vector<Arc> arcs;
    for (const BezierPiece& piece : bezier_pieces(curve))
        append_arcs(Arc(piece.begin, piece.end, piece.control), straight, 0, arcs);
    return arcs;
}

} // namespace morph
