#include "libmorph/deform/constraints.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/constraint_check.h"
#include "libmorph/deform/free_control_points.h"
#include "libmorph/deform/measured_conditions.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace morph {

namespace {

constexpr double kLinearTolerance = 1e-11; ///< of the size of displacements and shapes
constexpr double kNoPull = 1e-12;          ///< multiplier of a constraint that changes nothing

/// Length against which differences of displacements are small.
double size_of(const ConstraintSet& constraints, const std::vector<ControlledPoints>& shapes,
               const Matrix& wanted)
{
    double size = wanted.size() == 0 ? 0 : wanted.cwiseAbs().maxCoeff();
    for (const ControlledPoints& shape : shapes)
        size = std::max(size, size_of(shape));
    for (const FixedPoints& fixed : constraints.fixed)
        if (fixed.displacements.size() > 0)
            size = std::max(size, fixed.displacements.cwiseAbs().maxCoeff());
    return size > 0 ? size : 1;
}

std::vector<ControlledPoints> restricted(const FreeControlPoints& free,
                                         const std::vector<ControlledPoints>& shapes)
{
    std::vector<ControlledPoints> result;
    result.reserve(shapes.size());
    for (const ControlledPoints& shape : shapes)
        result.push_back(free.restricted(shape));
    return result;
}

Eigen::VectorXd row_by_row(const Matrix& matrix)
{
    return Eigen::Map<const Eigen::VectorXd>(matrix.data(), matrix.size());
}

/// Numbers of the requirements with the equations first.
std::vector<std::size_t> equations_first(const std::vector<Requirement>& requirements)
{
    std::vector<std::size_t> order(requirements.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_partition(order.begin(), order.end(),
                          [&](std::size_t j) { return requirements[j].bound.kind == Bound::Kind::equal; });
    return order;
}

std::string in_quotes(const std::string& name)
{
    return "'" + name + "'";
}

/// "'thickness at 0.3' is 0.11 instead of at least 0.12"
std::string miss(const Requirement& requirement, double reached)
{
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << in_quotes(requirement.name) << " is " << reached << " instead of "
         << (requirement.bound.kind == Bound::Kind::equal ? "" : "at least ") << requirement.target;
    return text.str();
}

/// Names of the linear constraints, in the order of FreeControlPoints::equations().
std::vector<std::string> linear_names(const ConstraintSet& constraints)
{
    std::vector<std::string> names;
    for (const FixedPoints& fixed : constraints.fixed)
        names.push_back(fixed.name);
    for (const Tie& tie : constraints.ties)
        names.push_back(tie.name);
    for (const Symmetry& symmetry : constraints.symmetries)
        names.push_back(symmetry.name);
    return names;
}

class ConstraintSolver {
public:
    ConstraintSolver(const ConstraintSet& constraints, const Matrix& wanted)
        : constraints_(constraints), wanted_(wanted), free_(constraints, wanted),
          shapes_(shapes_of(constraints)),
          requirements_(requirements_of(constraints, shapes_, wanted.cols())),
          order_(equations_first(requirements_)), size_(size_of(constraints, shapes_, wanted)),
          space_(free_.equations(0), row_by_row(free_.wanted()), kLinearTolerance * size_), sorted_(sorted()),
          measures_(measures_of(sorted_, restricted(free_, shapes_), wanted.cols()))
    {
    }

    ConstrainedMove solve() const
    {
        require_linear_ones_agree();
        require_lines_cross();
        const MeasuredConditions conditions(sorted_, measures_, space_, size_, wanted_.cols());
        const NearestPoint nearest = nearest_point(conditions, space_.dimension());
        const Matrix found = conditions.displacements(nearest.y);
        if (!nearest.missed.empty())
            throw SolverError(failure(nearest, found));
        return result(nearest, found);
    }

private:
    std::vector<Requirement> sorted() const
    {
        std::vector<Requirement> result;
        result.reserve(order_.size());
        for (const std::size_t j : order_)
            result.push_back(requirements_[j]);
        return result;
    }

    void require_linear_ones_agree() const
    {
        const std::vector<std::size_t>& clash = space_.clash();
        if (clash.empty())
            return;
        const std::vector<std::string> names = linear_names(constraints_);
        const std::string first = in_quotes(names[clash[0]]);
        if (clash.size() == 1)
            throw InputError("constraint " + first +
                             " asks for what no move of the free control points does");
        throw InputError("constraints " + first + " and " + in_quotes(names[clash[1]]) +
                         " contradict each other: no move of the free control points satisfies both");
    }

    void require_lines_cross() const
    {
        const Eigen::VectorXd& base = space_.base();
        const Matrix start =
            Eigen::Map<const Matrix>(base.data(), base.size() / wanted_.cols(), wanted_.cols());
        const Eigen::VectorXd values = measures_.at(start).values;
        for (std::size_t j = 0; j < sorted_.size(); ++j)
            if (std::isnan(values[static_cast<Eigen::Index>(j)]))
                throw SolverError(
                    "the requested displacements move the boundary off the line of constraint " +
                    in_quotes(sorted_[j].name));
    }

    std::string failure(const NearestPoint& nearest, const Matrix& found) const
    {
        const ShapeMeasures::Values reached = measures_.at(found);
        const Eigen::Index first = nearest.missed[0];
        const auto missed = [&](Eigen::Index j) {
            return miss(sorted_[static_cast<std::size_t>(j)], reached.values[j]);
        };
        if (!nearest.contradiction)
            return "the search for displacements that meet the constraints got stuck where " + missed(first) +
                   "; it is local, so start it from smaller displacements";
        const std::string name = in_quotes(sorted_[static_cast<std::size_t>(first)].name);
        if (nearest.missed.size() > 1) {
            const Eigen::Index second = nearest.missed[1];
            return "constraints " + name + " and " +
                   in_quotes(sorted_[static_cast<std::size_t>(second)].name) +
                   " contradict each other: at the nearest displacements " + missed(first) + " and " +
                   missed(second);
        }
        const std::vector<std::size_t> others = space_.sources_of(reached.jacobian.row(first));
        if (others.empty())
            return "constraint " + name + " cannot be met: at the nearest displacements " + missed(first);
        return "constraints " + name + " and " + in_quotes(linear_names(constraints_)[others[0]]) +
               " contradict each other: at the nearest displacements " + missed(first);
    }

    ConstrainedMove result(const NearestPoint& nearest, const Matrix& found) const
    {
        ConstrainedMove move;
        move.displacements = wanted_;
        move.displacements(free_.numbers(), Eigen::all) = found;
        move.change = (move.displacements - wanted_).norm();
        move.iterations = nearest.iterations;
        move.measured.resize(sorted_.size());
        const Eigen::VectorXd wanted = measures_.at(free_.wanted()).values;
        const Eigen::VectorXd reached = measures_.at(found).values;
        for (std::size_t i = 0; i < sorted_.size(); ++i) {
            const auto j = static_cast<Eigen::Index>(i);
            const Requirement& requirement = sorted_[i];
            move.measured[order_[i]] = {requirement.name, requirement.undisplaced,
                                        wanted[j],        requirement.target,
                                        reached[j],       std::abs(nearest.multipliers[j]) > kNoPull};
        }
        return move;
    }

    const ConstraintSet& constraints_;
    const Matrix& wanted_;
    FreeControlPoints free_;
    std::vector<ControlledPoints> shapes_;
    std::vector<Requirement> requirements_;
    std::vector<std::size_t> order_;
    double size_;
    SolutionSpace space_;
    std::vector<Requirement> sorted_;
    ShapeMeasures measures_;
};

} // namespace

ConstrainedMove satisfy_constraints(const ConstraintSet& constraints, const Matrix& wanted)
{
    require_valid(constraints, wanted);
    return ConstraintSolver(constraints, wanted).solve();
}

} // namespace morph
