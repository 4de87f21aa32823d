#pragma once

#include "libmorph/core/types.h"

#include <vector>

namespace morph {

/// Smooth conditions on a vector: the first equations() of them must be 0, the others at least 0. Scaled so
/// that 1 is a large violation and 1e-13 none.
class Conditions {
public:
    struct Values {
        Eigen::VectorXd values;   ///< m, NaN where a condition has no value
        Eigen::MatrixXd jacobian; ///< m x n
    };

    virtual ~Conditions() = default;
    virtual Eigen::Index equations() const = 0;
    virtual Values at(const Eigen::VectorXd& y) const = 0;

    /// Add factor_j times the second derivative of condition j, for all j.
    virtual void add_hessian(const Eigen::VectorXd& y, const Eigen::VectorXd& factors,
                             Eigen::MatrixXd& hessian) const = 0;
};

/// The answer of nearest_point().
struct NearestPoint {
    Eigen::VectorXd y;           ///< n
    Eigen::VectorXd multipliers; ///< m, y = J^T multipliers; 0 for inequalities that do not hold it back
    Conditions::Values reached;
    int iterations = 0;
    std::vector<Eigen::Index>
        missed;                 ///< conditions that are not met, those most in the way of each other first
    bool contradiction = false; ///< the missed ones contradict each other here; else the search got stuck
};

/// A point nearest to the origin that satisfies all conditions.
///
/// Sequential quadratic programming with the exact second derivative of the Lagrangian, so that the
/// error is squared in every step near the end; each quadratic program is a least_distance(). Where the
/// second derivative is not positive definite along what the conditions leave free, 1 takes its place
/// [Nocedal & Wright 2006, Numerical Optimization, chapter 18, with its line search and second-order
/// correction]. Where the linearised conditions contradict each other, a step of Gauss and Newton reduces
/// what is violated.
///
/// Derivatives that are slightly off, because a condition has kinks, slow it down but do not stop it: where
/// no step comes nearer any more, it ends as soon as the conditions are met.
///
/// Local: with strongly curved conditions another point may be nearer still.
///
/// @param n  number of unknowns
/// @throws SolverError  a condition has no value at the origin, or the search has not settled after 100 steps
NearestPoint nearest_point(const Conditions& conditions, Eigen::Index n);

} // namespace morph
