#pragma once

#include "libmorph/deform/controlled_points.h"
#include "libmorph/deform/local_measure.h"

#include <vector>

namespace morph {

/// A number that measures a shape.
struct ShapeMeasure {
    enum class Kind {
        area,    ///< area inside a closed polygon in the x, y plane
        extent,  ///< extent of a closed polygon along a line, extent_along()
        distance ///< distance of two points
    };

    Kind kind = Kind::area;
    std::size_t shape = 0;                           ///< which of the shapes
    Eigen::Vector2d at = Eigen::Vector2d::Zero();    ///< extent: a point of the line
    Eigen::Vector2d along = Eigen::Vector2d::Zero(); ///< extent: its direction, of length 1
    double turn =
        1; ///< area: 1 counts it positive inside a polygon that runs counter-clockwise, -1 clockwise
};

/// Measures of shapes as functions of the displacements D of the control points, with their first and second
/// derivatives. A derivative by D counts its K c entries row by row.
class ShapeMeasures {
public:
    struct Values {
        Eigen::VectorXd values;   ///< m
        Eigen::MatrixXd jacobian; ///< m x K c
    };

    /// @param shapes      all of the same K; polygons in order, the last node joined to the first
    /// @param components  c, 2 or 3; areas and extents need 2
    ShapeMeasures(std::vector<ControlledPoints> shapes, std::vector<ShapeMeasure> measures,
                  Eigen::Index components);

    /// @param D  K x c
    Values at(const Matrix& D) const;

    /// Add factor_j times the second derivative of measure j by D, for all j.
    /// @param hessian  K c x K c
    void add_hessian(const Matrix& D, const Eigen::VectorXd& factors, Eigen::MatrixXd& hessian) const;

private:
    std::vector<Points> moved_shapes(const Matrix& D) const;
    LocalMeasure local_measure(const ShapeMeasure& measure, const std::vector<Points>& moved) const;

    std::vector<ControlledPoints> shapes_;
    std::vector<ShapeMeasure> measures_;
    std::vector<Eigen::MatrixXd> mixed_; ///< of each measure that is an area: d2 A / dx dy, K x K
    Eigen::Index components_;
};

} // namespace morph
