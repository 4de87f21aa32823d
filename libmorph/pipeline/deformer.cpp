#include "libmorph/pipeline/deformer.h"

#include "libmorph/core/error.h"
#include "libmorph/core/stopwatch.h"
#include "libmorph/deform/apply.h"
#include "libmorph/deform/gradient.h"
#include "libmorph/deform/move_lattice.h"
#include "libmorph/pipeline/detail/check_and_repair.h"
#include "libmorph/pipeline/detail/constraint_setup.h"
#include "libmorph/pipeline/detail/lattice_fit.h"
#include "libmorph/pipeline/detail/prepared_motion.h"
#include "libmorph/pipeline/detail/pull_setup.h"

namespace morph {

namespace {

/// With other weights of the control points the map is not linear in them.
void move_reweighted(const LatticeSettings& settings, const PlacedLattice& placed,
                     const Matrix& displacements, const Eigen::Map<Points>& positions)
{
    const Lattice& before = placed.lattice;
    Points control_points = before.definition().control_points;
    control_points.leftCols(displacements.cols()) += displacements;
    const Lattice after = before.with_weights(settings.moved_weights).with_control_points(control_points);
    move_by_lattice(before, after, placed.embedding, positions);
}

std::vector<std::string> warnings_of(const PreparedMotion& motion)
{
    std::vector<std::string> warnings = placement_warnings(motion.curves);
    if (motion.lattice)
        warnings.insert(warnings.end(), motion.lattice->warnings.begin(), motion.lattice->warnings.end());
    return warnings;
}

} // namespace

struct Deformer::Parts {
    const Mesh* mesh;
    MotionSettings settings;
    PreparedMotion motion;
    std::vector<std::string> warnings;

    /// Where a lattice holds the mesh, the curves are what it is fitted to.
    bool curves_are_targets() const { return settings.deform.method == Method::ffd; }

    void require_shape(const Matrix& displacements) const
    {
        const Matrix& given = motion.displacements;
        if (displacements.rows() != given.rows() || displacements.cols() != given.cols())
            throw InputError("displacements is " + std::to_string(displacements.rows()) + " x " +
                             std::to_string(displacements.cols()) + ", expected " +
                             std::to_string(given.rows()) + " x " + std::to_string(given.cols()));
        if (!displacements.allFinite())
            throw InputError("displacements must be finite numbers");
    }

    void require_ends_that_meet(const Matrix& displacements) const
    {
        if (!curves_are_targets() && !motion.curves.boundaries.empty())
            require_ends_together(*mesh, motion.curves.boundaries, motion.curves.conditions, displacements);
    }
};

Deformer::Deformer(const Mesh& mesh, MotionSettings settings, std::optional<Weights> weights)
{
    check(settings);
    PreparedMotion motion = prepare_motion(mesh, settings, std::move(weights));
    std::vector<std::string> warnings = warnings_of(motion);
    parts_ = std::make_unique<const Parts>(
        Parts{&mesh, std::move(settings), std::move(motion), std::move(warnings)});
}

Deformer::~Deformer() = default;
Deformer::Deformer(Deformer&&) noexcept = default;
Deformer& Deformer::operator=(Deformer&&) noexcept = default;

const Mesh& Deformer::mesh() const
{
    return *parts_->mesh;
}

const MotionSettings& Deformer::settings() const
{
    return parts_->settings;
}

const std::vector<CurveBoundary>& Deformer::boundaries() const
{
    return parts_->motion.curves.boundaries;
}

const PlacedLattice* Deformer::lattice() const
{
    return parts_->motion.lattice ? &*parts_->motion.lattice : nullptr;
}

const std::vector<ControlPoint>& Deformer::control_points() const
{
    return parts_->motion.columns();
}

const Matrix& Deformer::displacements() const
{
    return parts_->motion.displacements;
}

std::vector<Index> Deformer::held() const
{
    return parts_->motion.held();
}

const std::vector<std::string>& Deformer::warnings() const
{
    return parts_->warnings;
}

bool Deformer::is_linear() const
{
    return morph::is_linear(parts_->settings);
}

std::optional<WeightsView> Deformer::weights() const
{
    return is_linear() ? std::optional(parts_->motion.rows()) : std::nullopt;
}

WeightsCheck Deformer::weights_check() const
{
    return check_weights(parts_->motion);
}

std::size_t Deformer::weights_bytes() const
{
    return parts_->motion.rows().bytes();
}

Matrix Deformer::gradient(const Matrix& dJdX) const
{
    require_linear(parts_->settings);
    return control_point_gradient(parts_->motion.rows(), dJdX);
}

ControlOutcome Deformer::satisfy(Matrix& displacements) const
{
    const MotionSettings& settings = parts_->settings;
    const PreparedMotion& motion = parts_->motion;
    parts_->require_shape(displacements);
    ControlOutcome outcome;
    if (parts_->curves_are_targets() && !motion.curves.boundaries.empty())
        outcome.curve_misfit = fit_lattice(mesh(), motion, displacements);
    if (!settings.pulls.empty())
        outcome.pull = pull(mesh(), settings.pulls, motion, displacements);
    if (settings.constraints)
        outcome.constrained = constrain(mesh(), settings, outcome.pull, motion, displacements);
    return outcome;
}

MoveResult Deformer::move() const
{
    Matrix displacements = parts_->motion.displacements;
    ControlOutcome control = satisfy(displacements);
    MoveResult result = move(displacements);
    result.control = std::move(control);
    return result;
}

MoveResult Deformer::move(const Matrix& displacements) const
{
    const PlacedBoundaries& curves = parts_->motion.curves;
    const auto before = points(mesh());
    Stopwatch watch;
    MoveResult result;
    result.displacements = displacements;
    result.positions = before;
    result.steps = move_points(displacements, {result.positions.data(), result.positions.rows(), 3});
    result.seconds.apply = watch.lap();
    const Matrix& curve_displacements = parts_->curves_are_targets() ? curves.displacements : displacements;
    for (std::size_t b = 0; b < curves.boundaries.size(); ++b)
        result.fits.push_back(boundary_fit(curves, b, curve_displacements, before, result.positions));
    if (mesh().dimension == 2 && is_linear())
        result.safe_step = safe_step(mesh(), before, result.positions);
    check_and_repair(mesh(), curves, curve_displacements, settings().deform.guard, result);
    result.seconds.guard = watch.lap();
    return result;
}

int Deformer::move_points(const Matrix& displacements, Eigen::Map<Points> positions) const
{
    const PreparedMotion& motion = parts_->motion;
    parts_->require_shape(displacements);
    parts_->require_ends_that_meet(displacements);
    if (motion.nonlinear)
        return move_nonlinear(mesh(), *motion.nonlinear, displacements, positions);
    if (moves_lattice_weights(settings()))
        move_reweighted(*settings().lattice, *motion.lattice, displacements, positions);
    else
        std::visit([&](const auto& filled) { apply_weights(filled, displacements, positions); },
                   motion.weights);
    return 1;
}

} // namespace morph
