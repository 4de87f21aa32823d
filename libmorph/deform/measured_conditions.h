#pragma once

#include "libmorph/deform/constraints.h"
#include "libmorph/deform/linear_equations.h"
#include "libmorph/deform/nearest_point.h"
#include "libmorph/deform/shape_measures.h"

#include <string>
#include <vector>

namespace morph {

/// An area or a length and what it has to be.
struct Requirement {
    std::string name;
    ShapeMeasure measure;
    Bound bound;            ///< as asked for
    double undisplaced = 0; ///< the measure without displacements
    double target = 0;      ///< the bound in the unit of the measure
    double scale = 1;       ///< difference that counts as 1: the area itself, or the size of the shape
};

/// Areas, thicknesses and distances, in the order of the set.
/// @param shapes       shapes_of(constraints)
/// @throws InputError  a line does not cross its boundary, or a boundary encloses no area; names it
std::vector<Requirement> requirements_of(const ConstraintSet& constraints,
                                         const std::vector<ControlledPoints>& shapes,
                                         Eigen::Index components);

/// Shapes that are measured: the boundaries, then the ends of the distances.
std::vector<ControlledPoints> shapes_of(const ConstraintSet& constraints);

/// Diagonal of the box around the points of a shape before any displacement.
double size_of(const ControlledPoints& shape);

ShapeMeasures measures_of(const std::vector<Requirement>& requirements, std::vector<ControlledPoints> shapes,
                          Eigen::Index components);

/// Requirements as conditions on coordinates y in the space that linear constraints leave.
class MeasuredConditions : public Conditions {
public:
    /// @param requirements  equations first
    /// @param measures      measures_of(requirements); outlives this, as do the others
    /// @param length        unit of y
    /// @param components    c, 2 or 3
    MeasuredConditions(const std::vector<Requirement>& requirements, const ShapeMeasures& measures,
                       const SolutionSpace& space, double length, Eigen::Index components);

    /// F x c
    Matrix displacements(const Eigen::VectorXd& y) const;

    Eigen::Index equations() const override { return equations_; }
    Values at(const Eigen::VectorXd& y) const override;
    void add_hessian(const Eigen::VectorXd& y, const Eigen::VectorXd& factors,
                     Eigen::MatrixXd& hessian) const override;

private:
    const ShapeMeasures& measures_;
    const SolutionSpace& space_;
    double length_;
    Eigen::Index components_;
    Eigen::Index equations_;
    Eigen::VectorXd targets_;
    Eigen::VectorXd scales_;
};

} // namespace morph
