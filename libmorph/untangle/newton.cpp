#include "libmorph/untangle/newton.h"

#include "libmorph/core/error.h"
#include "libmorph/numerics/conjugate_gradients.h"
#include "libmorph/numerics/sparse_cholesky.h"
#include "libmorph/untangle/patch_energy.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace morph {

namespace {

constexpr double kLeastEps = 1e-9;   // corners of at least so much of their target's area feel no eps
constexpr double kLeastFall = 0.3;   // by which eps falls when the energy does not
constexpr double kStalledEps = 1e-5; // eps at which a corner that is not positive yet will hardly become it
constexpr double kStuck = 0.2; // part of the worst determinant that eps shrinks to where a patch is too small
constexpr double kLeastStep = 1e-9;    // part of a Newton step
constexpr double kArmijo = 1e-4;       // part of the promised fall that a step must bring
constexpr double kSettled = 1e-4;      // relative fall of the energy below which a step is the last
constexpr Index kMaxFactored = 20'000; // vertices; a factor of a larger patch takes too much memory
constexpr double kFirstShift = 1e-9;   // on the diagonal: a patch that nothing holds may turn

Points2 places_of_unknowns(const Patch& patch, const PlanePositions& x)
{
    const Eigen::Index free = patch.free;
    Points2 where(2 * free, 2);
    for (Eigen::Index v = 0; v < free; ++v) {
        const std::complex<double> p = x[static_cast<std::size_t>(v)];
        where.row(2 * v) << p.real(), p.imag();
        where.row(2 * v + 1) = where.row(2 * v);
    }
    return where;
}

Matrix descent(const PlanePositions& gradient)
{
    const auto n = static_cast<Eigen::Index>(gradient.size());
    Matrix right(2 * n, 1);
    for (Eigen::Index v = 0; v < n; ++v) {
        right(2 * v, 0) = -gradient[static_cast<std::size_t>(v)].real();
        right(2 * v + 1, 0) = -gradient[static_cast<std::size_t>(v)].imag();
    }
    return right;
}

/// Where to move the free vertices, and how fast the energy falls along that.
struct Direction {
    Direction(const PlanePositions& gradient, const Matrix& solution) : d(gradient.size())
    {
        for (std::size_t v = 0; v < d.size(); ++v) {
            const auto row = 2 * static_cast<Eigen::Index>(v);
            d[v] = {solution(row, 0), solution(row + 1, 0)};
            slope += std::real(std::conj(gradient[v]) * d[v]);
        }
    }

    PlanePositions d;
    double slope = 0;
};

/// Solves for Newton steps: directly, or by iteration where a patch is large.
class StepSolver {
public:
    explicit StepSolver(const Patch& patch) : patch_(patch) {}

    /// Corners of very different energies can leave a matrix that is indefinite by rounding: more on the
    /// diagonal repairs it. Nothing where even that does not help.
    std::optional<Direction> direction(PatchEnergy::Model& model, const PlanePositions& x)
    {
        for (double shift = kFirstShift; shift < 1; shift *= 100) {
            for (double& entry : model.second.diagonal)
                entry *= 1 + shift;
            try {
                Matrix solution = descent(model.gradient);
                solve(model.second, x, solution);
                return Direction(model.gradient, solution);
            } catch (const SolverError&) {
                continue;
            }
        }
        return std::nullopt;
    }

private:
    void solve(const SymmetricMatrix& A, const PlanePositions& x, Matrix& solution)
    {
        if (patch_.free > kMaxFactored) {
            conjugate_gradients(A, places_of_unknowns(patch_, x), {}, solution);
            return;
        }
        if (dissection_.order.empty())
            dissection_ = nested_dissection(A, places_of_unknowns(patch_, x));
        SparseCholesky(A, dissection_).solve(solution);
    }

    const Patch& patch_;
    Dissection dissection_; // the same for all steps
};

/// The paper's rule: eps shrinks as fast as the energy has fallen, or faster where a large part of a Newton
/// step could be taken; it is gone once no corner needs it.
double next_eps(double eps, double least, double fall, double step)
{
    const double sigma = std::max(kLeastFall * step, fall);
    const double mu = (1 - sigma) * regularized(least, eps);
    return least < mu ? std::max(kLeastEps, 2 * std::sqrt(mu * (mu - least))) : kLeastEps;
}

class Minimizer {
public:
    Minimizer(const Patch& patch, const EnergyWeights& weights, PlanePositions& x)
        : energy_(patch, weights), solver_(patch), x_(x), trial_(x)
    {
        least_ = energy_.value(x, 1).min_determinant;
        positive_ = least_ > 0;
        eps_ = std::max(kLeastEps, -least_);
    }

    bool positive() const { return positive_; }

    /// One Newton step; false when it was the last that is worth while.
    bool step()
    {
        PatchEnergy::Model model = energy_.model(x_, eps_);
        const std::optional<Direction> direction = solver_.direction(model, x_);
        if (!direction)
            return false;
        const double fall = search(*direction);
        positive_ = positive_ || least_ > 0;
        if (eps_ == kLeastEps && fall < kSettled)
            return false;
        if (least_ < 0 && (eps_ < kStuck * -least_ || eps_ < kStalledEps))
            return false;
        eps_ = next_eps(eps_, least_, fall, taken_);
        return true;
    }

private:
    /// Go along a direction until the energy falls as it should; returns the part of it that is gone.
    double search(const Direction& direction)
    {
        const double before = energy_.value(x_, eps_).energy;
        for (double step = 1; step > kLeastStep; step *= 0.5) {
            for (std::size_t v = 0; v < direction.d.size(); ++v)
                trial_[v] = x_[v] + step * direction.d[v];
            const PatchEnergy::Value there = energy_.value(trial_, eps_);
            const bool falls = there.energy <= before + kArmijo * step * direction.slope; // false for NaN
            if (!falls || (positive_ && there.min_determinant <= 0))
                continue;
            x_.swap(trial_);
            taken_ = step;
            least_ = there.min_determinant;
            return 1 - there.energy / before;
        }
        taken_ = 0;
        return 0;
    }

    PatchEnergy energy_;
    StepSolver solver_;
    PlanePositions& x_;
    PlanePositions trial_;
    double eps_ = 0;
    double taken_ = 0; // part of the last Newton step
    double least_ = 0; // determinant of all corners, as in PatchEnergy::Value
    bool positive_ = false;
};

} // namespace

PatchResult minimize(const Patch& patch, const EnergyWeights& weights, int max_iterations, PlanePositions& x)
{
    Minimizer minimizer(patch, weights, x);
    PatchResult result;
    while (result.iterations < max_iterations) {
        ++result.iterations;
        if (!minimizer.step())
            break;
    }
    result.positive = minimizer.positive();
    return result;
}

} // namespace morph
