#include "libmorph/deform/least_distance.h"

#include <Eigen/QR>

#include <limits>
#include <vector>

namespace morph {

namespace {

constexpr double kDependent = 1e-10; ///< part of a unit row outside of the active ones that is taken for 0
constexpr double kTolerance = 1e-13; ///< of the size of the numbers in a row
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The dual active set, on rows of length 1.
class ActiveSet {
public:
    ActiveSet(const Eigen::VectorXd& target, const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
              Eigen::Index equations)
        : A_(A), b_(b), equations_(equations), x_(target), multipliers_(Eigen::VectorXd::Zero(b.size()))
    {
    }

    bool solve()
    {
        for (Eigen::Index p = 0; p < equations_; ++p)
            if (!activate(p))
                return false;
        const Eigen::Index most_steps = 50 * (b_.size() + 1); // rounding could make it go round in circles
        for (Eigen::Index step = 0; step < most_steps; ++step) {
            const Eigen::Index p = worst_inequality();
            if (p < 0)
                return true;
            if (!activate(p))
                return false;
        }
        return false;
    }

    const Eigen::VectorXd& point() const { return x_; }
    const Eigen::VectorXd& multipliers() const { return multipliers_; }

private:
    double missing(Eigen::Index p) const { return b_[p] - A_.row(p).dot(x_); }
    double tolerance(Eigen::Index p) const { return kTolerance * (1 + std::abs(b_[p]) + x_.norm()); }

    Eigen::Index worst_inequality() const
    {
        Eigen::Index worst = -1;
        double most = 0;
        for (Eigen::Index p = equations_; p < b_.size(); ++p)
            if (const double miss = missing(p); miss > tolerance(p) && miss > most) {
                worst = p;
                most = miss;
            }
        return worst;
    }

    /// Rows of the active conditions as columns.
    Eigen::MatrixXd normals() const { return A_(active_, Eigen::all).transpose(); }

    /// Place in active_ of the inequality whose multiplier is the first to reach 0, and the step to there.
    std::pair<double, std::size_t> first_to_leave(const Eigen::VectorXd& r) const
    {
        std::pair<double, std::size_t> first{kInfinity, 0};
        for (std::size_t i = 0; i < active_.size(); ++i) {
            const double fall = r[static_cast<Eigen::Index>(i)];
            if (active_[i] >= equations_ && fall > kDependent &&
                multipliers_[active_[i]] / fall < first.first)
                first = {multipliers_[active_[i]] / fall, i};
        }
        return first;
    }

    /// Move the point until condition @p p is met, letting go of inequalities that stand in the way.
    bool activate(Eigen::Index p)
    {
        const double sign = missing(p) < 0 ? -1 : 1;
        const Eigen::VectorXd normal = sign * A_.row(p).transpose();
        for (;;) {
            Eigen::VectorXd r(0); // the part of the normal along the active ones
            Eigen::VectorXd z = normal;
            if (!active_.empty()) {
                const Eigen::MatrixXd N = normals();
                r = N.householderQr().solve(normal);
                z -= N * r;
            }
            const bool dependent = z.norm() <= kDependent;
            const auto [leave_step, leaver] = first_to_leave(r);
            if (dependent && leave_step == kInfinity)
                return std::abs(missing(p)) <= tolerance(p);
            const double full_step = dependent ? kInfinity : sign * missing(p) / z.squaredNorm();
            const double step = std::min(full_step, leave_step);
            if (!dependent)
                x_ += step * z;
            multipliers_(active_) -= step * r;
            multipliers_[p] += sign * step;
            if (full_step <= leave_step) {
                active_.push_back(p);
                return true;
            }
            multipliers_[active_[leaver]] = 0;
            active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(leaver));
        }
    }

    const Eigen::MatrixXd& A_;
    const Eigen::VectorXd& b_;
    Eigen::Index equations_;
    Eigen::VectorXd x_;
    Eigen::VectorXd multipliers_;
    std::vector<Eigen::Index> active_;
};

} // namespace

LeastDistance least_distance(const Eigen::VectorXd& target, const Eigen::MatrixXd& A,
                             const Eigen::VectorXd& b, Eigen::Index equations)
{
    Eigen::VectorXd length = A.rowwise().norm();
    length = (length.array() > 0).select(length, 1);
    const Eigen::MatrixXd unit_rows = length.cwiseInverse().asDiagonal() * A;
    const Eigen::VectorXd unit_b = b.cwiseQuotient(length);
    ActiveSet active(target, unit_rows, unit_b, equations);
    LeastDistance result;
    result.feasible = active.solve();
    result.point = active.point();
    result.multipliers = active.multipliers().cwiseQuotient(length);
    return result;
}

} // namespace morph
