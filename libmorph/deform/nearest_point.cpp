#include "libmorph/deform/nearest_point.h"

#include "libmorph/core/error.h"
#include "libmorph/deform/least_distance.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <string>

namespace morph {

namespace {

constexpr int kMostIterations = 100;
constexpr double kMet = 1e-13;       ///< violation that counts as none
constexpr double kRounding = 1e-12;  ///< violation that rounding may leave
constexpr double kSmallStep = 1e-9;  ///< part of the size of y; a step of Newton leaves the square of it
constexpr double kShortest = 1e-6;   ///< part of a step that a line search still tries
constexpr double kArmijo = 1e-4;     ///< part of the predicted decrease that it asks for
constexpr double kCorrection = 0.5;  ///< of a step, at most
constexpr double kNoise = 1e-14;     ///< of a merit, from rounding
constexpr double kInvolved = 1e-6;   ///< part that a condition has in a contradiction, of the largest part
constexpr double kDependent = 1e-10; ///< of the largest pivot: rows that depend on others
constexpr double kDefinite = 1e-3;   ///< smallest pivot of a second derivative that is used

class Search {
public:
    Search(const Conditions& conditions, Eigen::Index n)
        : conditions_(conditions), y_(Eigen::VectorXd::Zero(n)), now_(conditions.at(y_)),
          multipliers_(Eigen::VectorXd::Zero(now_.values.size())), penalties_(multipliers_)
    {
        if (!now_.values.allFinite())
            throw SolverError("a condition has no value where the search starts");
    }

    NearestPoint run()
    {
        if (now_.jacobian.size() == 0) // no conditions, or nothing that could change them
            return result(0, {Step::Kind::contradiction, 0});
        for (int iteration = 1; iteration <= kMostIterations; ++iteration) {
            const Step step = improve();
            if (is_last(step))
                return result(iteration, step);
        }
        throw SolverError("the search for the nearest point has not settled after " +
                          std::to_string(kMostIterations) + " steps");
    }

private:
    struct Step {
        enum class Kind {
            newton,       ///< towards the nearest point
            blocked,      ///< only towards fewer violations, because the one of Newton improves nothing
            contradiction ///< the same, because the linearised conditions contradict each other
        };

        Kind kind = Kind::newton;
        double length = 0;
    };

    bool is_last(const Step& step) const
    {
        const double length = step.length / (1 + y_.norm());
        const double violation = worst_violation();
        if (step.kind == Step::Kind::contradiction && violation > kSmallStep)
            return length <= kSmallStep;
        return length <= kNoise || (length <= kSmallStep && violation <= kMet);
    }

    NearestPoint result(int iterations, const Step& last) const
    {
        const bool met = worst_violation() <= kRounding;
        return {y_,
                multipliers_,
                now_,
                iterations,
                met ? std::vector<Eigen::Index>{} : involved(),
                !met && last.kind == Step::Kind::contradiction};
    }

    bool is_equation(Eigen::Index j) const { return j < conditions_.equations(); }

    Eigen::VectorXd violations(const Eigen::VectorXd& values) const
    {
        const Eigen::Index equations = conditions_.equations();
        Eigen::VectorXd violation = (-values).cwiseMax(0);
        violation.head(equations) = values.head(equations).cwiseAbs();
        return violation;
    }

    double worst_violation() const
    {
        return now_.values.size() == 0 ? 0 : violations(now_.values).maxCoeff();
    }

    std::vector<Eigen::Index> equations_and(const Eigen::VectorXd& chosen) const
    {
        std::vector<Eigen::Index> rows;
        for (Eigen::Index j = 0; j < chosen.size(); ++j)
            if (is_equation(j) || chosen[j] > 0)
                rows.push_back(j);
        return rows;
    }

    /// Shortest step that brings the linearised conditions @p rows as near as possible to 0 from @p values.
    Eigen::VectorXd step_onto(const std::vector<Eigen::Index>& rows, const Eigen::VectorXd& values) const
    {
        if (rows.empty())
            return Eigen::VectorXd::Zero(y_.size());
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> onto;
        onto.setThreshold(kDependent);
        onto.compute(now_.jacobian(rows, Eigen::all));
        return onto.solve(-values(rows));
    }

    /// Where the second derivative of the Lagrangian is not definite, add to it along the gradients of the
    /// conditions that hold: these alone decide the step there, so that it stays one of Newton.
    Eigen::LLT<Eigen::MatrixXd> factored_hessian() const
    {
        const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(y_.size(), y_.size());
        Eigen::MatrixXd H = one;
        conditions_.add_hessian(y_, -multipliers_, H);
        const auto rows = equations_and(multipliers_);
        const Eigen::MatrixXd normals = now_.jacobian(rows, Eigen::all).rowwise().normalized();
        for (const double weight : {0.0, 10.0, 1000.0}) {
            Eigen::LLT<Eigen::MatrixXd> factor(H + weight * H.norm() * normals.transpose() * normals);
            const bool definite = factor.info() == Eigen::Success &&
                                  Eigen::VectorXd(factor.matrixLLT().diagonal()).minCoeff() > kDefinite;
            if (definite)
                return factor;
        }
        return Eigen::LLT<Eigen::MatrixXd>(one);
    }

    /// Minimum of the quadratic model under the linearised conditions, as a least distance in coordinates
    /// L^T s, where L L^T is the second derivative. Its point is the step s.
    LeastDistance quadratic_program() const
    {
        const Eigen::LLT<Eigen::MatrixXd> factor = factored_hessian();
        const auto L = factor.matrixL();
        const Eigen::MatrixXd rows = L.solve(now_.jacobian.transpose()).transpose();
        LeastDistance program = least_distance(-L.solve(y_), rows, -now_.values, conditions_.equations());
        program.point = factor.matrixU().solve(program.point);
        return program;
    }

    Step improve()
    {
        const LeastDistance program = quadratic_program();
        if (!program.feasible) {
            multipliers_.setZero();
            return {Step::Kind::contradiction, step_of_gauss()};
        }
        multipliers_ = program.multipliers;
        const double length = step_of_newton(program);
        if (length >= 0)
            return {Step::Kind::newton, length};
        return {Step::Kind::blocked, step_of_gauss()};
    }

    double merit(const Eigen::VectorXd& y, const Eigen::VectorXd& values) const
    {
        return y.squaredNorm() / 2 + penalties_.dot(violations(values));
    }

    /// Take @p y if merit_of(y, values) is at most @p bound, which it is not where a condition has no value.
    template <typename Merit>
    bool take_if(const Eigen::VectorXd& y, double bound, const Merit& merit_of)
    {
        Conditions::Values values = conditions_.at(y);
        if (!(merit_of(y, values.values) <= bound))
            return false;
        y_ = y;
        now_ = std::move(values);
        return true;
    }

    /// @return the length of the step taken, or -1 when none improves the merit
    double step_of_newton(const LeastDistance& program)
    {
        for (Eigen::Index j = 0; j < penalties_.size(); ++j)
            if (const double size = std::abs(program.multipliers[j]); penalties_[j] < 1.5 * size)
                penalties_[j] = 2 * size;
        const Eigen::VectorXd& s = program.point;
        const Eigen::VectorXd start = y_;
        const double before = merit(y_, now_.values);
        const double slope = y_.dot(s) - penalties_.dot(violations(now_.values));
        const auto merit_of = [this](const auto& y, const auto& values) { return merit(y, values); };
        const auto bound = [&](double part) { return before + kArmijo * part * slope + kNoise * before; };
        multipliers_ = program.multipliers;
        if (take_if(start + s, bound(1), merit_of) || take_if(start + corrected(s), bound(1), merit_of))
            return s.norm();
        for (double part = 0.5; part > kShortest; part /= 2)
            if (take_if(start + part * s, bound(part), merit_of))
                return part * s.norm();
        return -1;
    }

    /// The step bent back onto the conditions that hold, which are curved; as it is, where that takes more
    /// than a correction.
    Eigen::VectorXd corrected(const Eigen::VectorXd& s) const
    {
        const Eigen::VectorXd bend = step_onto(equations_and(multipliers_), conditions_.at(y_ + s).values);
        return bend.norm() <= kCorrection * s.norm() ? Eigen::VectorXd(s + bend) : s;
    }

    /// @return the length of the step taken, 0 when none reduces the violations
    double step_of_gauss()
    {
        const Eigen::VectorXd violation = violations(now_.values);
        const auto rows = equations_and(violation);
        const Eigen::VectorXd s = step_onto(rows, now_.values);
        const Eigen::VectorXd start = y_;
        const double before = violation.squaredNorm();
        const double slope = 2 * now_.values(rows).dot(now_.jacobian(rows, Eigen::all) * s);
        const auto merit_of = [this](const auto&, const auto& values) {
            return violations(values).squaredNorm();
        };
        for (double part = 1; part > kShortest; part /= 2)
            if (take_if(start + part * s, before + kArmijo * part * slope, merit_of))
                return part * s.norm();
        return 0;
    }

    /// Where the violations r cannot be reduced any more, J^T r = 0: a combination of the gradients that is 0
    /// though that of the violations is not. A condition is involved by its part in it.
    std::vector<Eigen::Index> involved() const
    {
        const Eigen::VectorXd violation = violations(now_.values);
        Eigen::VectorXd part = violation.cwiseProduct(now_.jacobian.rowwise().norm());
        if (part.maxCoeff() <= kRounding * violation.maxCoeff())
            part = violation; // nothing moves them at all
        std::vector<Eigen::Index> result;
        for (Eigen::Index j = 0; j < part.size(); ++j)
            if (part[j] >= kInvolved * part.maxCoeff())
                result.push_back(j);
        std::stable_sort(result.begin(), result.end(),
                         [&](Eigen::Index a, Eigen::Index b) { return part[a] > part[b]; });
        return result;
    }

    const Conditions& conditions_;
    Eigen::VectorXd y_;
    Conditions::Values now_;
    Eigen::VectorXd multipliers_;
    Eigen::VectorXd penalties_;
};

} // namespace

NearestPoint nearest_point(const Conditions& conditions, Eigen::Index n)
{
    return Search(conditions, n).run();
}

} // namespace morph
