#pragma once

#include "libmorph/basis/bspline.h"
#include "libmorph/core/types.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace morph {

/// What a B-spline or NURBS curve in the plane is made from, as a case file gives it.
struct CurveDefinition {
    int degree = 3;      ///< 1 to 7
    bool closed = false; ///< true: periodic · false: clamped, it starts and ends at its end control points
    Points2 control_points = {}; ///< K x 2, length unit of the mesh

    /// Empty: uniform. Closed: one period, K + 1 values from 0 to 1, repeated periodically; the span
    /// between knots[j] and knots[j + 1] is shaped by the rows j ... j + degree (mod K) of
    /// control_points, all counted from 0. Open: the full clamped vector, K + degree + 1 values.
    std::vector<double> knots = {};
    std::vector<double> weights = {}; ///< K positive values (NURBS); empty: all 1
};

/// The degree + 1 basis functions that are not zero at a parameter.
struct BasisRow {
    int count = 0;                               ///< degree + 1
    std::array<Index, kMaxDegree + 1> control{}; ///< distinct control points, each in [0, K)
    std::array<double, kMaxDegree + 1> value{};  ///< in [0, 1], sum 1
};

/// A planar B-spline curve C(u) = sum_i R_i(u) P_i, rational when it has weights, u in [0, 1].
///
/// Closed curves take any u modulo 1; open ones clamp it to [0, 1]. An open knot vector over another
/// interval is mapped to [0, 1]. Where the curve is not smooth, derivatives are those from the right
/// (at the end of an open curve: from the left).
class Curve {
public:
    /// @throws InputError  degree not in 1 ... 7; fewer than degree + 1 control points (closed: and
    ///                     fewer than 3); knots of the wrong number, that decrease, do not run from 0 to 1
    ///                     (closed) or are not clamped (open), lie closer than 1e-9 of their range without
    ///                     being equal, or are repeated more often than the degree (inside); weights of
    ///                     the wrong number or not positive; a number that is not finite
    explicit Curve(CurveDefinition definition);

    const CurveDefinition& definition() const { return definition_; }
    int degree() const { return definition_.degree; }
    bool closed() const { return definition_.closed; }
    Index control_point_count() const { return static_cast<Index>(definition_.control_points.rows()); }

    /// Basis functions at @p u, rational when the curve has weights [Piegl & Tiller, The NURBS Book, 4.1].
    BasisRow basis(double u) const;

    /// C(u).
    Eigen::Vector2d point(double u) const;

    /// C and its first @p order derivatives with respect to u, order at most 3; the rest are zero.
    std::array<Eigen::Vector2d, 4> derivatives(double u, int order) const;

    /// Distinct parameters in [0, 1] where one polynomial piece ends and the next begins, 0 and 1 included.
    std::vector<double> breakpoints() const;

    /// Parameters in [0, 1) (open: the inside of it) where the tangent may jump: knots of full multiplicity.
    std::vector<double> corners() const;

    /// The same curve over other control points.
    /// @throws InputError  another number of points, a number that is not finite
    Curve with_control_points(const Points2& control_points) const;

    /// The knots over [0, 1] in the form of extended_knots().
    const std::vector<double>& knots() const { return knots_; }

    /// (w x, w y, w) of the control point that function @p i of extended_knots() belongs to.
    Eigen::Vector3d homogeneous(int i) const;

private:
    double into_range(double u) const;

    CurveDefinition definition_;
    std::vector<double> knots_; ///< extended over the neighbouring periods, normalised to [0, 1]
};

} // namespace morph
