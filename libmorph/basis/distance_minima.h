#pragma once

#include "libmorph/basis/bezier.h"
#include "libmorph/basis/curve.h"

#include <array>
#include <vector>

namespace morph {

/// A place where the distance from a point to a curve is least among its neighbours.
struct DistanceMinimum {
    double u = 0;        ///< closed: in [0, 1), open: in [0, 1]
    double distance = 0; ///< length unit of the curve
};

/// Finds every local minimum of the distance to one curve.
///
/// On each piece (C(u) - q) . C'(u) is a polynomial in Bernstein form (rational curves: its numerator),
/// linear in q. Its roots are isolated by Descartes' rule of signs with halving, then refined by Newton's
/// method kept inside the bracket, so that no minimum is missed, however the curve bends
/// [Sederberg & Nishita 1990, Computer-Aided Design 22(9), 538-549, of the same idea].
class DistanceMinima {
public:
    explicit DistanceMinima(const Curve& curve);

    /// The @p most nearest local minima, nearest first, at least one; those at breakpoints and at the
    /// ends of an open curve included.
    ///
    /// A point that coincides with a corner or an end to 1e-12 of the curve's size has this one only,
    /// at its exact parameter (both ends of an open curve if they meet there).
    /// @throws InputError  @p point is not finite
    std::vector<DistanceMinimum> find(const Eigen::Vector2d& point, std::size_t most) const;

    /// Diagonal of the box around the control points.
    double size() const { return size_; }

private:
    static constexpr std::size_t kMaxCoefficients = std::size_t{3} * kMaxDegree;
    using Coefficients = std::array<double, kMaxCoefficients>;

    /// Coefficient i of (C - q) . C' on one piece is constant[i] - q . slope[i].
    struct ConvexPart {
        double begin = 0;
        double end = 0;
        std::size_t count = 0;
        Coefficients constant{};
        std::array<Coefficients, 2> slope{};
        double constant_size = 0; ///< largest absolute coefficient, for the size of rounding errors
        double slope_size = 0;
    };
    struct SpecialPoint {
        double u = 0;
        Eigen::Vector2d point;
    };

    ConvexPart make_piece(const BezierPiece& bezier) const;
    std::vector<DistanceMinimum> at_special_points(const Eigen::Vector2d& point) const;
    std::vector<double> stationary_parameters(const Eigen::Vector2d& q) const;

    Curve curve_;
    Eigen::Vector2d origin_; ///< centre of the box: coordinates far from zero lose no digits
    double size_ = 0;
    std::vector<ConvexPart> pieces_;
    std::vector<SpecialPoint> special_; ///< corners, and ends of an open curve
};

} // namespace morph
