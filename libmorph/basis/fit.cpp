#include "libmorph/basis/fit.h"

#include "libmorph/basis/closest.h"
#include "libmorph/basis/least_squares.h"
#include "libmorph/basis/node_path.h"
#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace morph {

namespace {

constexpr int kKnotRounds = 12;      // knots placed again from the last fit
constexpr int kCorrections = 5;      // of the parameters, in each round
constexpr int kLastCorrections = 20; // with the best knots
// Share of the distance along the tangent in a step. Less converges sooner and swings more; 1 needs
// hundreds of steps.
constexpr double kTangential = 0.01;
constexpr double kSamePlace = 1e-12; // of the box around the nodes: nodes this close coincide

void require_nodes(const Points2& nodes, bool closed)
{
    const Eigen::Index count = nodes.rows();
    const Eigen::Index needed = closed ? 3 : 2;
    if (count < needed)
        throw InputError("a curve through " + std::string(closed ? "a closed" : "an open") +
                         " marker needs at least " + std::to_string(needed) + " nodes, but there are " +
                         std::to_string(count));
    for (Eigen::Index i = 0; i < count; ++i)
        if (!nodes.row(i).allFinite())
            throw InputError("node " + std::to_string(i + 1) + " of the sequence is not finite");
    const double size = (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).norm();
    for (Eigen::Index i = closed ? 0 : 1; i < count; ++i) {
        const Eigen::Index last = (i + count - 1) % count;
        if ((nodes.row(i) - nodes.row(last)).norm() <= kSamePlace * size)
            throw InputError("nodes " + std::to_string(last + 1) + " and " + std::to_string(i + 1) +
                             " of the sequence coincide");
    }
}

void require_settings(const FitSettings& settings)
{
    if (settings.degree < 1 || settings.degree > kMaxDegree)
        throw InputError("degree " + std::to_string(settings.degree) + " is not supported; expected 1 to " +
                         std::to_string(kMaxDegree));
    if (!(settings.corner_angle > 0) || settings.corner_angle > 180)
        throw InputError("a corner angle lies above 0 and at most at 180 degrees");
}

/// The control points are enough for the degree and the corners, and not more than the nodes determine.
void require_point_count(Index points, Index nodes, Index corners, bool closed, int degree)
{
    const Index segments = closed ? std::max<Index>(corners, 1) : corners + 1;
    const Index least = closed ? std::max<Index>({segments * degree, degree + 1, 3}) : segments * degree + 1;
    const std::string what = std::to_string(points) + " control points";
    if (points < least)
        throw InputError(what + " are too few: degree " + std::to_string(degree) + " with " +
                         std::to_string(corners) + " corner(s) needs at least " + std::to_string(least));
    if (points > nodes)
        throw InputError(what + " are too many: the marker has " + std::to_string(nodes) +
                         " nodes, and each control point needs one");
}

/// Moves each parameter towards the foot of its point on the curve, one Gauss-Newton step, at most
/// half way to its neighbours so that their order stays. Pins stay.
void correct_parameters(NodePath& path, const Curve& curve)
{
    const std::vector<double> old = path.t;
    for (std::size_t s = 0; s + 1 < path.pins.size(); ++s)
        for (Index i = path.pins[s] + 1; i < path.pins[s + 1]; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const auto d = curve.derivatives(old[at], 1);
            const double speed = d[1].squaredNorm();
            if (!(speed > 0))
                continue;
            const double step = (path.points.row(i).transpose() - d[0]).dot(d[1]) / speed;
            path.t[at] += std::clamp(step, -0.49 * (old[at] - old[at - 1]), 0.49 * (old[at + 1] - old[at]));
        }
}

double largest_distance(const NodePath& path, const Curve& curve)
{
    double largest = 0;
    for (Eigen::Index i = 0; i < path.points.rows(); ++i)
        largest = std::max(
            largest,
            (curve.point(path.t[static_cast<std::size_t>(i)]) - path.points.row(i).transpose()).norm());
    return largest;
}

/// Fits control points to a path, knots given, and corrects its parameters in between.
class KnotFit {
public:
    KnotFit(const NodePath& path, int degree, Index control_points, const std::vector<double>& knots)
        : path_(path),
          curve_(CurveDefinition{degree, path.closed, path.points.topRows(control_points), knots, {}})
    {
        if (!path.smooth_seam)
            interpolated_.assign(path.pins.begin(), path.closed ? path.pins.end() - 1 : path.pins.end());
        curve_ =
            curve_.with_control_points(least_squares_points(curve_, points(), parameters(), interpolated_));
    }

    void improve(int corrections)
    {
        for (int i = 0; i < corrections; ++i) {
            correct_parameters(path_, curve_);
            curve_ = curve_.with_control_points(
                fitting_step(curve_, points(), parameters(), interpolated_, kTangential));
        }
        correct_parameters(path_, curve_);
    }

    const NodePath& path() const { return path_; }
    const Curve& curve() const { return curve_; }

private:
    // A closed path repeats its first point, which must not count twice.
    Eigen::Index count() const { return path_.points.rows() - (path_.closed ? 1 : 0); }
    Points2 points() const { return path_.points.topRows(count()); }
    std::vector<double> parameters() const { return {path_.t.begin(), path_.t.begin() + count()}; }

    NodePath path_;
    Curve curve_;
    std::vector<Index> interpolated_;
};

Curve fit_path(const NodePath& chord_path, const FitSettings& settings)
{
    const int degree = settings.degree;
    const Index K = settings.control_points;
    Effort effort = polygon_effort(chord_path);
    KnotFit current(chord_path, degree, K, place_knots(chord_path, effort, degree, K));
    current.improve(kCorrections);
    KnotFit best = current;
    double least = largest_distance(best.path(), best.curve());
    for (int round = 0; round < kKnotRounds; ++round) {
        const Effort wanted = curve_effort(current.path(), current.curve());
        for (std::size_t i = 0; i < effort.size(); ++i) // half of the way: the estimate swings
            effort[i] = 0.5 * (effort[i] + wanted[i]);
        current = KnotFit(current.path(), degree, K, place_knots(current.path(), effort, degree, K));
        current.improve(kCorrections);
        const double distance = largest_distance(current.path(), current.curve());
        if (distance < least) {
            least = distance;
            best = current;
        }
    }
    best.improve(kLastCorrections);
    return best.curve();
}

/// Angle by which a polygon turns left at a node.
double turn_at(const Points2& nodes, Eigen::Index i)
{
    const Eigen::Index count = nodes.rows();
    const Eigen::RowVector2d before = nodes.row(i) - nodes.row((i + count - 1) % count);
    const Eigen::RowVector2d after = nodes.row((i + 1) % count) - nodes.row(i);
    return std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
}

} // namespace

std::vector<Index> find_corners(const Points2& nodes, bool closed, double angle)
{
    const auto count = static_cast<Index>(nodes.rows());
    std::vector<double> turn(static_cast<std::size_t>(count), 0.0);
    for (Index i = closed ? 0 : 1; i < (closed ? count : count - 1); ++i)
        turn[static_cast<std::size_t>(i)] = turn_at(nodes, i);
    std::vector<Index> corners;
    for (Index i = 0; i < count; ++i) {
        const double sense = turn[static_cast<std::size_t>(i)] < 0 ? -1 : 1;
        const double before = std::max(0.0, sense * turn[static_cast<std::size_t>((i + count - 1) % count)]);
        const double after = std::max(0.0, sense * turn[static_cast<std::size_t>((i + 1) % count)]);
        const double excess = sense * turn[static_cast<std::size_t>(i)] - 0.5 * (before + after);
        if (excess * 180 / std::numbers::pi > angle)
            corners.push_back(i);
    }
    return corners;
}

CurveFit fit_curve(const Points2& nodes, bool closed, const FitSettings& settings)
{
    require_settings(settings);
    require_nodes(nodes, closed);
    CurveFit fit;
    fit.corners = find_corners(nodes, closed, settings.corner_angle);
    require_point_count(settings.control_points, static_cast<Index>(nodes.rows()),
                        static_cast<Index>(fit.corners.size()), closed, settings.degree);
    const Curve curve = fit_path(make_path(nodes, closed, fit.corners, settings.degree), settings);
    fit.curve = curve.definition();
    for (const CurveParameter& place : node_parameters(curve, nodes, closed)) {
        fit.max_distance = std::max(fit.max_distance, place.distance);
        fit.mean_distance += place.distance / static_cast<double>(nodes.rows());
    }
    return fit;
}

} // namespace morph
