#include "libmorph/basis/curve.h"

#include "libmorph/basis/knots.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace morph {

namespace {

void require_degree(int degree)
{
    if (degree < 1 || degree > kMaxDegree)
        throw InputError("degree " + std::to_string(degree) + " is not supported; expected 1 to " +
                         std::to_string(kMaxDegree));
}

void require_points(const CurveDefinition& curve)
{
    const auto count = curve.control_points.rows();
    const int needed = curve.closed ? std::max(3, curve.degree + 1) : curve.degree + 1;
    if (count < needed)
        throw InputError("a" + std::string(curve.closed ? " closed" : "n open") + " curve of degree " +
                         std::to_string(curve.degree) + " needs at least " + std::to_string(needed) +
                         " control points, but there are " + std::to_string(count));
    for (Eigen::Index i = 0; i < count; ++i)
        if (!curve.control_points.row(i).allFinite())
            throw InputError("control point " + std::to_string(i + 1) + " is not finite");
}

void require_weights(const CurveDefinition& curve)
{
    if (curve.weights.empty())
        return;
    const auto count = static_cast<std::size_t>(curve.control_points.rows());
    if (curve.weights.size() != count)
        throw InputError("there are " + std::to_string(curve.weights.size()) + " weights for " +
                         std::to_string(count) + " control points; expected one for each");
    for (std::size_t i = 0; i < count; ++i)
        if (!(curve.weights[i] > 0) || !std::isfinite(curve.weights[i]))
            throw InputError("weight " + std::to_string(i + 1) + " is " + number_text(curve.weights[i]) +
                             "; weights are positive numbers");
}

void require_knot_count(const CurveDefinition& curve)
{
    const auto count = static_cast<std::size_t>(curve.control_points.rows());
    const std::size_t expected =
        curve.closed ? count + 1 : count + static_cast<std::size_t>(curve.degree) + 1;
    if (curve.knots.size() != expected)
        throw InputError(
            "there are " + std::to_string(curve.knots.size()) + " knots; " +
            (curve.closed
                 ? "a closed curve has one more than its " + std::to_string(count) + " control points"
                 : "an open curve of degree " + std::to_string(curve.degree) + " with " +
                       std::to_string(count) + " control points has " + std::to_string(expected)));
}

/// The ends of the knot vector are what the kind of curve asks for.
void require_ends(const CurveDefinition& curve)
{
    const std::vector<double>& knots = curve.knots;
    if (curve.closed && (knots.front() != 0 || knots.back() != 1))
        throw InputError("the knots of a closed curve run from 0 to 1 over one period, but these from " +
                         number_text(knots.front()) + " to " + number_text(knots.back()));
    if (!curve.closed)
        require_clamped(knots, curve.degree);
}

/// C^(k) from the derivatives A^(k) of (w x, w y, w) by the quotient rule
/// [Piegl & Tiller, The NURBS Book, algorithm A4.2].
std::array<Eigen::Vector2d, 4> project(const std::array<Eigen::Vector3d, 4>& A, int order)
{
    constexpr double kBinomial[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    std::array<Eigen::Vector2d, 4> C;
    C.fill(Eigen::Vector2d::Zero());
    for (int k = 0; k <= order; ++k) {
        Eigen::Vector2d sum = A[static_cast<std::size_t>(k)].head<2>();
        for (int i = 1; i <= k; ++i)
            sum -= kBinomial[k][i] * A[static_cast<std::size_t>(i)].z() * C[static_cast<std::size_t>(k - i)];
        C[static_cast<std::size_t>(k)] = sum / A[0].z();
    }
    return C;
}

} // namespace

Curve::Curve(CurveDefinition definition) : definition_(std::move(definition))
{
    require_degree(degree());
    require_points(definition_);
    require_weights(definition_);
    if (definition_.knots.empty()) {
        knots_ = extended_knots(degree(), closed(), uniform_knots(degree(), control_point_count(), closed()));
        return;
    }
    require_knot_count(definition_);
    require_increasing(definition_.knots);
    require_ends(definition_);
    knots_ = definition_.knots;
    map_to_unit(knots_);
    knots_ = extended_knots(degree(), closed(), knots_);
    require_multiplicity(knots_, degree());
}

double Curve::into_range(double u) const
{
    if (!closed())
        return std::clamp(u, 0.0, 1.0);
    const double wrapped = u - std::floor(u);
    return wrapped < 1 ? wrapped : 0; // -1e-20 is wrapped to 1
}

Eigen::Vector3d Curve::homogeneous(int i) const
{
    const Index k = i % control_point_count();
    const double w = definition_.weights.empty() ? 1.0 : definition_.weights[static_cast<std::size_t>(k)];
    return {w * definition_.control_points(k, 0), w * definition_.control_points(k, 1), w};
}

BasisRow Curve::basis(double u) const
{
    u = into_range(u);
    const int span = find_span(knots_, degree(), u);
    const SpanValues values = basis_functions(knots_, span, degree(), u);
    BasisRow row;
    row.count = degree() + 1;
    row.value = values;
    for (int k = 0; k < row.count; ++k)
        row.control[static_cast<std::size_t>(k)] = (span - degree() + k) % control_point_count();
    if (definition_.weights.empty())
        return row;
    double sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
        sum += row.value[k] *= definition_.weights[static_cast<std::size_t>(row.control[k])];
    for (double& value : row.value)
        value /= sum;
    return row;
}

Eigen::Vector2d Curve::point(double u) const
{
    const BasisRow row = basis(u);
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
        sum += row.value[k] * definition_.control_points.row(row.control[k]).transpose();
    return sum;
}

std::array<Eigen::Vector2d, 4> Curve::derivatives(double u, int order) const
{
    assert(order >= 0 && order <= 3);
    u = into_range(u);
    const int span = find_span(knots_, degree(), u);
    // The derivative is a curve over the differences of neighbouring control points, one degree lower.
    std::array<Eigen::Vector3d, kMaxDegree + 1> local;
    for (int k = 0; k <= degree(); ++k)
        local[static_cast<std::size_t>(k)] = homogeneous(span - degree() + k);
    std::array<Eigen::Vector3d, 4> A;
    A.fill(Eigen::Vector3d::Zero());
    for (int d = 0; d <= std::min(order, degree()); ++d) {
        const int p = degree() - d;
        const SpanValues N = basis_functions(knots_, span, p, u);
        for (std::size_t k = 0; k <= static_cast<std::size_t>(p); ++k)
            A[static_cast<std::size_t>(d)] += N[k] * local[k];
        const auto after = knots_.begin() + span + 1;
        for (int k = 0; k < p; ++k) {
            const auto at = static_cast<std::size_t>(k);
            local[at] = p * (local[at + 1] - local[at]) / (after[k] - after[k - p]);
        }
    }
    return project(A, order);
}

std::vector<double> Curve::breakpoints() const
{
    std::vector<double> breaks(knots_.begin() + degree(), knots_.end() - degree());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
}

std::vector<double> Curve::corners() const
{
    std::vector<double> corners;
    for (const double u : breakpoints()) {
        const bool inside = closed() ? u < 1 : u > 0 && u < 1;
        if (inside && std::count(knots_.begin(), knots_.end(), u) >= degree())
            corners.push_back(u);
    }
    return corners;
}

Curve Curve::with_control_points(const Points2& control_points) const
{
    if (control_points.rows() != definition_.control_points.rows())
        throw InputError("there are " + std::to_string(control_points.rows()) +
                         " control points for a curve of " + std::to_string(control_point_count()));
    CurveDefinition moved = definition_;
    moved.control_points = control_points;
    return Curve(std::move(moved));
}

} // namespace morph
