#pragma once

#include "libmorph/deform/constraints.h"
#include "libmorph/deform/linear_equations.h"

#include <vector>

namespace morph {

/// The control points that constraints can change: those that some constraint concerns and that are not held.
/// The others keep their requested displacements, and what they move moves along. The unknowns are the
/// displacements of the free ones, row by row.
class FreeControlPoints {
public:
    /// @param constraints  valid, as is @p wanted, K x c; both outlive this
    FreeControlPoints(const ConstraintSet& constraints, const Matrix& wanted);

    const std::vector<Index>& numbers() const { return numbers_; } ///< F, ascending

    /// Their requested displacements, F x c.
    Matrix wanted() const { return wanted_(numbers_, Eigen::all); }

    /// Points as they follow the free ones alone.
    ControlledPoints restricted(const ControlledPoints& points) const;

    /// Equations of fixed points, ties and symmetries, in the order of the set.
    /// @param source  of the first of these constraints; those of the others follow
    std::vector<LinearEquation> equations(std::size_t source) const;

private:
    void concern(const ControlledPoints& points);
    void add_term(Index control_point, Index component, double coefficient, LinearEquation& equation) const;
    std::vector<LinearEquation> of_fixed(const FixedPoints& fixed) const;
    std::vector<LinearEquation> of_tie(const Tie& tie) const;
    std::vector<LinearEquation> of_symmetry(const Symmetry& symmetry) const;

    const ConstraintSet& constraints_;
    const Matrix& wanted_;
    std::vector<Index> place_; ///< K: in numbers_, or -1
    std::vector<Index> numbers_;
};

} // namespace morph
