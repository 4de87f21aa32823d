#pragma once

#include "libmorph/basis/bezier.h"
#include "libmorph/basis/curve.h"

#include <array>
#include <span>
#include <vector>

namespace morph {

/// Halvings of an arc after which work on it stops; reached only by numbers that overflow.
inline constexpr int kMaxHalvings = 60;

/// Part of a polynomial or rational piece; it lies in the convex hull of its control points, because
/// the weights are positive.
class Arc {
public:
    /// @param begin, end  parameters of the curve at both ends, in either order
    /// @param control     (w x, w y, w), at most kMaxDegree + 1
    Arc(double begin, double end, std::span<const Eigen::Vector3d> control);

    double begin() const { return begin_; }
    double end() const { return end_; }
    std::span<const Eigen::Vector2d> points() const { return std::span(point_).first(count_); }
    const Eigen::Vector2d& first() const { return point_[0]; }
    const Eigen::Vector2d& last() const { return point_[count_ - 1]; }
    Eigen::Vector2d chord() const { return last() - first(); }

    /// Largest distance of a control point from the chord.
    double bend() const;

    /// The control polygon, and so the arc, only advances in this direction.
    bool advances(const Eigen::Vector2d& direction) const;

    std::array<Arc, 2> halves() const;

    /// The same arc passed the other way.
    Arc reversed() const;

private:
    double begin_;
    double end_;
    std::size_t count_;
    std::array<Eigen::Vector3d, kMaxDegree + 1> homogeneous_;
    std::array<Eigen::Vector2d, kMaxDegree + 1> point_;
};

/// The arcs of a curve in order, at least four for each piece, without those that are a single point.
/// Each advances in the direction of its chord, so that none crosses itself, or its bend is below
/// @p straight.
std::vector<Arc> curve_arcs(const Curve& curve, double straight);

} // namespace morph
