#pragma once

#include "libmorph/core/types.h"

namespace morph {

/// The answer of least_distance().
struct LeastDistance {
    bool feasible = true;        ///< false: the conditions contradict each other
    Eigen::VectorXd point;       ///< n
    Eigen::VectorXd multipliers; ///< m, point = target + A^T multipliers; of inequalities never negative
};

/// The point nearest to a target among those that satisfy linear equations and inequalities.
///
/// Minimises |x - target| subject to a_j x = b_j for the first @p equations rows and a_j x >= b_j for the
/// others, with a dual active set: from the target itself, conditions that are not met become active one
/// after the other, the worst first [Goldfarb & Idnani 1983, Mathematical Programming 27, 1-33]. It ends
/// after finitely many steps and recognises contradictions. Equations may depend on each other if they agree.
///
/// For few conditions: each step takes a dense QR decomposition of the active ones.
///
/// @param target  n
/// @param A       m x n
/// @param b       m
LeastDistance least_distance(const Eigen::VectorXd& target, const Eigen::MatrixXd& A,
                             const Eigen::VectorXd& b, Eigen::Index equations);

} // namespace morph
