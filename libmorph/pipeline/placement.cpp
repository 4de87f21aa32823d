#include "libmorph/pipeline/placement.h"

#include "libmorph/core/error.h"
#include "libmorph/core/names.h"
#include "libmorph/geometry/curve_crossing.h"
#include "libmorph/weights/harmonic_curves.h"

#include <algorithm>
#include <cmath>

namespace morph {

namespace {

double size_of(const Curve& curve)
{
    const Points2& P = curve.definition().control_points;
    return (P.colwise().maxCoeff() - P.colwise().minCoeff()).norm();
}

/// Markers named in [deform] fixed, or every one that no curve moves and that does not slide.
std::vector<std::string> fixed_markers(const Mesh& mesh, const MotionSettings& settings)
{
    std::vector<std::string> moving;
    for (const CurveMove& curve : settings.curves)
        moving.push_back(curve.marker);
    moving.insert(moving.end(), settings.deform.slide.begin(), settings.deform.slide.end());
    return settings.deform.fixed.value_or(other_markers(mesh, moving));
}

Points2 stacked_displacements(const std::vector<CurveMove>& curves, Eigen::Index columns)
{
    Points2 all = Points2::Zero(columns, 2);
    Eigen::Index row = 0;
    for (const CurveMove& curve : curves) {
        all.middleRows(row, curve.displacements.rows()) = curve.displacements;
        row += curve.curve.control_points.rows();
    }
    return all;
}

std::string place_of(const CurveCrossing& crossing)
{
    return "(" + short_number(crossing.point.x()) + ", " + short_number(crossing.point.y()) + ")";
}

CurveBoundary placed_boundary(const Mesh& mesh, const CurveMove& move)
{
    const Curve curve = make_curve(move);
    if (const auto crossing = find_self_crossing(curve))
        throw InputError(move.where + "boundary '" + move.marker + "': the curve crosses itself near " +
                         place_of(*crossing));
    try {
        return parametrize_marker(mesh, move.marker, curve);
    } catch (const InputError& error) {
        throw InputError(move.where + error.what());
    }
}

} // namespace

PlacedBoundaries parametrize_boundaries(const Mesh& mesh, const MotionSettings& settings)
{
    PlacedBoundaries placed;
    for (const CurveMove& curve : settings.curves)
        placed.boundaries.push_back(placed_boundary(mesh, curve));
    try {
        placed.conditions = boundary_conditions(mesh, placed.boundaries, fixed_markers(mesh, settings));
        placed.displacements = stacked_displacements(
            settings.curves, static_cast<Eigen::Index>(placed.conditions.columns.size()));
        require_ends_together(mesh, placed.boundaries, placed.conditions, placed.displacements);
    } catch (const InputError& error) {
        throw InputError(settings.where + error.what());
    }
    return placed;
}

Curve moved_curve(const PlacedBoundaries& placed, std::size_t b, const Matrix& displacements)
{
    const Curve& curve = placed.boundaries[b].curve;
    return curve.with_control_points(
        curve.definition().control_points +
        displacements.middleRows(placed.conditions.first_column[b], curve.control_point_count()));
}

BoundaryFit boundary_fit(const PlacedBoundaries& placed, std::size_t b, const Matrix& displacements,
                         const PositionsView& before, const PositionsView& after)
{
    const CurveBoundary& boundary = placed.boundaries[b];
    const Curve moved = moved_curve(placed, b, displacements);
    BoundaryFit fit;
    for (std::size_t i = 0; i < boundary.vertices.size(); ++i) {
        const auto& [u, distance] = boundary.parameters[i];
        fit.largest_distance = std::max(fit.largest_distance, distance);
        fit.mean_distance += distance / static_cast<double>(boundary.vertices.size());
        const Eigen::Vector2d residual =
            before.row(boundary.vertices[i]).head<2>().transpose() - boundary.curve.point(u);
        const Eigen::Vector2d landed = after.row(boundary.vertices[i]).head<2>().transpose();
        const double error = (landed - moved.point(u) - residual).norm() / size_of(boundary.curve);
        fit.landing_error = std::max(fit.landing_error, error);
    }
    return fit;
}

std::vector<std::string> placement_warnings(const PlacedBoundaries& placed)
{
    constexpr double kFarOff = 0.05; // of the curve's size: the curve is another one than the marker's
    std::vector<std::string> warnings;
    for (const CurveBoundary& boundary : placed.boundaries) {
        double farthest = 0;
        for (const CurveParameter& parameter : boundary.parameters)
            farthest = std::max(farthest, parameter.distance);
        if (farthest > kFarOff * size_of(boundary.curve))
            warnings.push_back(
                "marker '" + boundary.name + "' lies up to " + short_number(farthest) +
                " off its curve; the move still follows the control points, but is this the right "
                "curve? morph-fit makes one that fits");
    }
    if (placed.conditions.unmarked > 0)
        warnings.push_back(std::to_string(placed.conditions.unmarked) +
                           " vertices of the boundary are in no marker; they are held fixed");
    return warnings;
}

std::vector<std::string> boundary_crossings(const PlacedBoundaries& placed, const Matrix& displacements)
{
    std::vector<std::string> found;
    std::vector<Curve> moved;
    for (std::size_t b = 0; b < placed.boundaries.size(); ++b) {
        moved.push_back(moved_curve(placed, b, displacements));
        const std::string who = "the moved boundary '" + placed.boundaries[b].name + "' crosses ";
        if (const auto crossing = find_self_crossing(moved[b]))
            found.push_back(who + "itself near " + place_of(*crossing));
        for (std::size_t other = 0; other < b; ++other)
            if (const auto crossing = find_crossing(moved[other], moved[b]))
                found.push_back(who + "'" + placed.boundaries[other].name + "' near " + place_of(*crossing));
    }
    return found;
}

} // namespace morph
