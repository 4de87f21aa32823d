#include "libmorph/pipeline/settings.h"

#include "libmorph/core/error.h"

#include <algorithm>

namespace morph {

namespace {

/// Displacements of @p count points, or none at all.
void require_rows(const std::string& what, const Matrix& displacements, Eigen::Index count,
                  const std::string& points)
{
    if (displacements.rows() != 0 && displacements.rows() != count)
        throw InputError(what + " displacements has " + std::to_string(displacements.rows()) +
                         " rows, but there are " + std::to_string(count) + " " + points);
    if (displacements.rows() != 0 && displacements.cols() != 2 && displacements.cols() != 3)
        throw InputError(what + " displacements has " + std::to_string(displacements.cols()) +
                         " columns, but x and y or x, y and z are needed");
    if (!displacements.allFinite())
        throw InputError(what + " displacements must be finite numbers");
}

void check_curves(const std::vector<CurveMove>& curves)
{
    for (auto curve = curves.begin(); curve != curves.end(); ++curve) {
        const std::string what = curve->where + "boundary '" + curve->marker + "'";
        if (std::any_of(curves.begin(), curve, [&](const CurveMove& c) { return c.marker == curve->marker; }))
            throw InputError(what + " is given twice");
        require_rows(what + ":", curve->displacements, curve->curve.control_points.rows(), "control points");
    }
}

void check_pull(const PullSettings& pull)
{
    const std::string what = pull.where + "[[pull]]";
    if (pull.points.rows() > 0 && pull.points.cols() != 3)
        throw InputError(what + " points must have three columns, x, y and z");
    const auto count = pull.points.rows() + static_cast<Eigen::Index>(pull.vertices.size());
    require_rows(what, pull.displacements, count, "points");
    if (pull.displacements.rows() == 0 && count > 0)
        throw InputError(what + " needs displacements");
}

void check_constraints(const ConstraintSettings& constraints)
{
    if (constraints.fixed_points.rows() > 0 && constraints.fixed_points.cols() != 3)
        throw InputError(constraints.where +
                         "[constraints] fixed_points must have three columns, x, y and z");
    for (const ThicknessSettings& thickness : constraints.thicknesses)
        if (!(thickness.value > 0))
            throw InputError(thickness.where + "[constraints] thickness of '" + thickness.boundary +
                             "' must be above 0");
}

void check_deform(const DeformSettings& deform)
{
    for (const RigidMarker& rigid : deform.rigid)
        if (!(rigid.distance >= 0))
            throw InputError(deform.where + "[deform] rigid distance of '" + rigid.marker +
                             "' must not be below 0");
}

} // namespace

Curve make_curve(const CurveMove& move)
{
    try {
        return Curve(move.curve);
    } catch (const InputError& error) {
        throw InputError(move.where + "boundary '" + move.marker + "': " + error.what());
    }
}

bool uses_lattice(const MotionSettings& settings)
{
    return settings.deform.method == Method::ffd || settings.curves.empty();
}

bool moves_lattice_weights(const MotionSettings& settings)
{
    return settings.lattice && !settings.lattice->moved_weights.empty();
}

bool is_linear(const MotionSettings& settings)
{
    return !moves_lattice_weights(settings) && !needs_nonlinear_motion(settings.deform);
}

void require_linear(const MotionSettings& settings)
{
    if (!is_linear(settings))
        throw InputError(settings.where +
                         "the move is not linear in the control points, so it has no weights "
                         "to save and no gradient");
}

std::vector<ControlPoint> control_points(const MotionSettings& settings)
{
    std::vector<ControlPoint> all;
    const auto add = [&](const std::string& name, Eigen::Index count) {
        for (Index i = 0; i < count; ++i)
            all.push_back({name, i});
    };
    if (!uses_lattice(settings))
        for (const CurveMove& curve : settings.curves)
            add(curve.marker, curve.curve.control_points.rows());
    else if (settings.lattice)
        add(kLatticeName, make_lattice(*settings.lattice).control_point_count());
    return all;
}

void check(const MotionSettings& settings)
{
    if (settings.curves.empty() && !settings.lattice)
        throw InputError(settings.where + "there is no curve and no lattice, so there is nothing to move");
    if (settings.deform.method == Method::ffd && !settings.lattice)
        throw InputError(settings.where + "method = \"ffd\" needs a [lattice]");
    check_curves(settings.curves);
    for (const PullSettings& pull : settings.pulls)
        check_pull(pull);
    if (settings.constraints)
        check_constraints(*settings.constraints);
    check_deform(settings.deform);
    if (moves_lattice_weights(settings) &&
        (settings.deform.method != Method::ffd || !settings.pulls.empty() || settings.constraints))
        throw InputError(settings.lattice->where +
                         "[lattice] moved_weights goes with method = \"ffd\" alone, without pulls and "
                         "constraints: the move is not linear in them");
}

} // namespace morph
