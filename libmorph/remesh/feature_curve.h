#pragma once

#include "libmorph/basis/curve.h"
#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace morph {

/// A line of a mesh that stays a line of it: a part of its boundary, of a marker or of a sharp edge, between
/// two corners or closed. Its nodes may move along it.
///
/// Through the nodes of the input: with straight pieces (surfaces, whose creases are what the input says), or
/// with the cubics whose tangents at each node are those of the parabola through it and its neighbours
/// [Bessel's method; de Boor 1978, A Practical Guide to Splines, IV], so that smooth boundaries keep their
/// shape to third order of the node spacing. Or on a B-spline curve given.
class FeatureCurve {
public:
    enum class Shape { straight, smooth };

    /// @param nodes   at least 2, consecutive ones distinct; closed: the first is not repeated
    /// @param closed  the last node is followed by the first
    /// @param shape   polygon or smooth curve
    FeatureCurve(const std::vector<Eigen::Vector3d>& nodes, bool closed, Shape shape);

    /// The part of a planar curve from begin to end, begin < end; on a closed curve they may lie in the next
    /// period, and end = begin + 1 with @p closed means all of it.
    FeatureCurve(Curve curve, double begin, double end, bool closed);

    bool closed() const { return closed_; }
    double begin() const { return u_.front(); }
    double end() const { return u_.back(); }
    double period() const { return end() - begin(); }

    /// Parameter of node @p i of the input; for curves through nodes only.
    double node_parameter(std::size_t i) const { return u_[i]; }

    /// @param u  closed: any; else kept within begin and end
    Eigen::Vector3d point(double u) const;
    Eigen::Vector3d tangent(double u) const; ///< dC/du

    /// Radius of curvature; infinite where it is straight. Through nodes: by how much the polygon turns from
    /// the piece before that of @p u to the piece after it, so that a zigzag counts as straight.
    double radius(double u) const;

private:
    double inside(double u) const;
    std::size_t piece(double u) const;
    double spline_radius(double u) const;
    double polygon_radius(std::size_t piece) const;

    std::optional<Curve> spline_;
    std::vector<double> u_; ///< of the nodes, closed: the first again at the end
    std::vector<Eigen::Vector3d> nodes_;
    std::vector<Eigen::Vector3d> slopes_; ///< dC/du at the nodes; empty: straight pieces
    bool closed_ = false;
};

} // namespace morph
