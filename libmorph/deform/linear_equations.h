#pragma once

#include "libmorph/core/types.h"

#include <utility>
#include <vector>

namespace morph {

/// One equation on a vector of unknowns: the sum of coefficients times unknowns is a value.
struct LinearEquation {
    std::size_t source = 0; ///< the caller's number of what asks for it
    std::vector<std::pair<Index, double>> terms;
    double value = 0;
};

/// All solutions of linear equations, as base + directions y with orthonormal directions.
class SolutionSpace {
public:
    /// The equations may depend on each other if they agree.
    /// @param wanted     n
    /// @param tolerance  residual of an equation of length 1 up to which it counts as met
    SolutionSpace(const std::vector<LinearEquation>& equations, const Eigen::VectorXd& wanted,
                  double tolerance);

    /// Sources of the equations that contradict each other, the most involved first; empty when there are
    /// solutions. The base is then the nearest of the vectors of least squares.
    const std::vector<std::size_t>& clash() const { return clash_; }

    /// Sources of the equations that keep a linear form from changing, the most involved first.
    /// @param form  n
    std::vector<std::size_t> sources_of(const Eigen::VectorXd& form) const;

    /// The solution nearest to the requested one.
    const Eigen::VectorXd& base() const { return base_; }

    Eigen::Index dimension() const { return equations_.rows() == 0 ? base_.size() : directions_.cols(); }

    Eigen::VectorXd at(const Eigen::VectorXd& y) const;

    /// Derivatives by y from those by the unknowns, m x n to m x dimension() and n x n to its square.
    Eigen::MatrixXd restrict_rows(const Eigen::MatrixXd& rows) const;
    Eigen::MatrixXd restrict_form(const Eigen::MatrixXd& form) const;

private:
    void find_base(const Eigen::VectorXd& values, double tolerance);
    std::vector<std::size_t> by_part(const Eigen::VectorXd& parts) const;

    Eigen::MatrixXd equations_; ///< rows of length 1, or 0 where nothing can move
    std::vector<std::size_t> sources_;
    Eigen::VectorXd base_;
    Eigen::MatrixXd directions_; ///< not used when there are no equations
    std::vector<std::size_t> clash_;
};

} // namespace morph
