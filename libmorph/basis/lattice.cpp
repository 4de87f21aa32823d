#include "libmorph/basis/lattice.h"

#include "libmorph/basis/bspline.h"
#include "libmorph/basis/knots.h"
#include "libmorph/core/error.h"
#include "libmorph/core/names.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace morph {

namespace {

// Relative to the sides of a cell, where rounding would decide on the sign of its volume.
constexpr double kFlat = 1e-12;

// Far beyond what anybody moves; more are a slip of the pen, and would not fit into memory.
constexpr double kMostControlPoints = 1e7;

const char* const kDirections[] = {"i", "j", "k"};

std::string text(const std::array<Index, 3>& at, int dimension)
{
    std::string text = "(" + std::to_string(at[0]) + ", " + std::to_string(at[1]);
    return text + (dimension == 3 ? ", " + std::to_string(at[2]) + ")" : ")");
}

/// What does not count in the plane is given one value.
void flatten(LatticeDefinition& lattice)
{
    if (lattice.dimension != 2)
        return;
    lattice.degree[2] = 0;
    lattice.points[2] = 1;
    lattice.knots[2] = {0, 1};
    lattice.control_points.col(2).setZero();
}

void require_degree(const LatticeDefinition& lattice, std::size_t d)
{
    const bool bernstein = lattice.basis == LatticeBasis::bernstein;
    const int degree = lattice.degree[d];
    const int largest = bernstein ? kMaxLatticeDegree : kMaxDegree;
    if (degree < 1 || degree > largest)
        throw InputError("degree " + std::to_string(degree) + " is not supported; expected 1 to " +
                         std::to_string(largest));
    if (lattice.points[d] <= degree || (bernstein && lattice.points[d] != degree + 1))
        throw InputError("degree " + std::to_string(degree) + " needs " + (bernstein ? "" : "at least ") +
                         std::to_string(degree + 1) + " control points" +
                         (bernstein ? " (Bernstein polynomials)" : "") + ", but there are " +
                         std::to_string(lattice.points[d]));
}

SplineAxis axis_along(const LatticeDefinition& lattice, std::size_t d)
{
    std::vector<double> knots = lattice.knots[d];
    if (knots.empty())
        return {lattice.degree[d], uniform_knots(lattice.degree[d], lattice.points[d], false)};
    if (lattice.basis == LatticeBasis::bernstein)
        throw InputError("Bernstein polynomials take no knots");
    const int expected = lattice.points[d] + lattice.degree[d] + 1;
    if (std::ssize(knots) != expected)
        throw InputError("there are " + std::to_string(knots.size()) + " knots; degree " +
                         std::to_string(lattice.degree[d]) + " with " + std::to_string(lattice.points[d]) +
                         " control points has " + std::to_string(expected));
    require_increasing(knots);
    require_clamped(knots, lattice.degree[d]);
    map_to_unit(knots);
    require_multiplicity(knots, lattice.degree[d]);
    return {lattice.degree[d], std::move(knots)};
}

/// Do something for each direction that counts; its errors name the direction.
template <typename Work>
void along_each(const LatticeDefinition& lattice, const Work& work)
{
    for (std::size_t d = 0; d < static_cast<std::size_t>(lattice.dimension); ++d) {
        try {
            work(d);
        } catch (const InputError& error) {
            throw InputError(std::string("lattice along ") + kDirections[d] + ": " + error.what());
        }
    }
}

std::array<SplineAxis, 3> checked_axes(const LatticeDefinition& lattice)
{
    if (lattice.dimension != 2 && lattice.dimension != 3)
        throw InputError("a lattice has dimension 2 or 3, not " + std::to_string(lattice.dimension));
    double count = 1;
    along_each(lattice, [&](std::size_t d) {
        require_degree(lattice, d);
        count *= lattice.points[d];
    });
    if (count > kMostControlPoints)
        throw InputError("a lattice of " + number_text(count) +
                         " control points is too large; expected at most " + number_text(kMostControlPoints));
    std::array<SplineAxis, 3> axes;
    along_each(lattice, [&](std::size_t d) { axes[d] = axis_along(lattice, d); });
    return axes;
}

void require_numbers(const Lattice& lattice)
{
    const LatticeDefinition& given = lattice.definition();
    const Index count = given.points[0] * given.points[1] * given.points[2];
    if (lattice.control_point_count() != count)
        throw InputError("there are " + std::to_string(lattice.control_point_count()) +
                         " control points for a lattice of " + std::to_string(count));
    if (lattice.rational() && std::ssize(given.weights) != count)
        throw InputError("there are " + std::to_string(given.weights.size()) + " weights for a lattice of " +
                         std::to_string(count) + " control points; expected one for each");
    for (Index row = 0; row < count; ++row) {
        const auto name = [&] { return text(lattice.indices_of(row), given.dimension); };
        if (!given.control_points.row(row).allFinite())
            throw InputError("control point " + name() + " of the lattice is not finite");
        if (!lattice.rational())
            continue;
        const double weight = given.weights[static_cast<std::size_t>(row)];
        if (!(weight > 0) || !std::isfinite(weight))
            throw InputError("the weight of control point " + name() + " of the lattice is " +
                             number_text(weight) + "; weights are positive numbers");
    }
}

/// Whether the lattice has volume around the point in the middle of some spans.
bool has_volume_at(const Lattice& lattice, const Eigen::Vector3d& u)
{
    const Eigen::Matrix3d J = lattice.jacobian(u);
    const Eigen::Vector3d sides = J.colwise().norm();
    return sides.minCoeff() > kFlat * kFlat * lattice.size() &&
           std::abs(J.determinant()) > kFlat * sides.prod();
}

double middle(const SplineAxis& axis, int span)
{
    const auto knot = axis.knots().begin() + span;
    return 0.5 * (knot[0] + knot[1]);
}

void require_volume(const Lattice& lattice)
{
    for (const int k : lattice.axis(2).spans())
        for (const int j : lattice.axis(1).spans())
            for (const int i : lattice.axis(0).spans())
                if (has_volume_at(lattice, {middle(lattice.axis(0), i), middle(lattice.axis(1), j),
                                            middle(lattice.axis(2), k)}))
                    return;
    throw InputError(std::string("the control points of the lattice enclose no ") +
                     (lattice.dimension() == 3 ? "volume" : "area"));
}

/// The functions of one direction at a parameter.
struct At {
    int first = 0; ///< the first control point they belong to
    int count = 0;
    AxisValues value;
    AxisValues slope;

    At(const SplineAxis& axis, double u) : count(axis.degree() + 1)
    {
        u = std::clamp(u, 0.0, 1.0);
        const int span = axis.span(u);
        first = span - axis.degree();
        axis.evaluate<SplineAxis::kAnyDegree, true>(span, u, value.data(), slope.data());
    }
};

/// Call visit(row, a, b, c) for the control points of three At; a, b, c count the functions of each.
template <typename Visit>
void for_each(const Lattice& lattice, const std::array<At, 3>& at, const Visit& visit)
{
    for (int c = 0; c < at[2].count; ++c)
        for (int b = 0; b < at[1].count; ++b)
            for (int a = 0; a < at[0].count; ++a)
                visit(lattice.row_of(at[0].first + a, at[1].first + b, at[2].first + c),
                      static_cast<std::size_t>(a), static_cast<std::size_t>(b), static_cast<std::size_t>(c));
}

std::array<At, 3> functions_at(const Lattice& lattice, const Eigen::Vector3d& u)
{
    return {At(lattice.axis(0), u[0]), At(lattice.axis(1), u[1]), At(lattice.axis(2), u[2])};
}

} // namespace

Lattice::Lattice(LatticeDefinition definition)
    : definition_(std::move(definition)), axes_(checked_axes(definition_))
{
    flatten(definition_);
    require_numbers(*this);
    const Points& P = definition_.control_points;
    size_ = (P.colwise().maxCoeff() - P.colwise().minCoeff()).norm();
    require_volume(*this);
}

std::array<Index, 3> Lattice::indices_of(Index row) const
{
    const Index line = row / definition_.points[0];
    return {row % definition_.points[0], line % definition_.points[1], line / definition_.points[1]};
}

LatticeRow Lattice::basis(const Eigen::Vector3d& u) const
{
    const std::array<At, 3> at = functions_at(*this, u);
    LatticeRow row;
    double sum = 0;
    for_each(*this, at, [&](Index control, std::size_t a, std::size_t b, std::size_t c) {
        const double weight = rational() ? definition_.weights[static_cast<std::size_t>(control)] : 1;
        row.control.push_back(control);
        row.value.push_back(weight * at[0].value[a] * at[1].value[b] * at[2].value[c]);
        sum += row.value.back();
    });
    if (rational())
        for (double& value : row.value)
            value /= sum;
    return row;
}

Eigen::Vector3d Lattice::point(const Eigen::Vector3d& u) const
{
    const LatticeRow row = basis(u);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t n = 0; n < row.control.size(); ++n)
        sum += row.value[n] * definition_.control_points.row(row.control[n]).transpose();
    return sum;
}

Eigen::Matrix3d Lattice::jacobian(const Eigen::Vector3d& u) const
{
    const std::array<At, 3> at = functions_at(*this, u);
    // (w x, w y, w z, w) and its derivatives along u, v, w.
    Eigen::Vector4d A = Eigen::Vector4d::Zero();
    Eigen::Matrix<double, 4, 3> slopes = Eigen::Matrix<double, 4, 3>::Zero();
    for_each(*this, at, [&](Index control, std::size_t a, std::size_t b, std::size_t c) {
        const double weight = rational() ? definition_.weights[static_cast<std::size_t>(control)] : 1;
        Eigen::Vector4d P;
        P << weight * definition_.control_points.row(control).transpose(), weight;
        A += at[0].value[a] * at[1].value[b] * at[2].value[c] * P;
        slopes.col(0) += at[0].slope[a] * at[1].value[b] * at[2].value[c] * P;
        slopes.col(1) += at[0].value[a] * at[1].slope[b] * at[2].value[c] * P;
        slopes.col(2) += at[0].value[a] * at[1].value[b] * at[2].slope[c] * P;
    });
    const Eigen::Vector3d S = A.head<3>() / A[3];
    Eigen::Matrix3d J = (slopes.topRows<3>() - S * slopes.row(3)) / A[3];
    if (dimension() == 2)
        J.col(2) = Eigen::Vector3d::UnitZ();
    return J;
}

Lattice Lattice::with_control_points(const Points& control_points) const
{
    LatticeDefinition other = definition_;
    other.control_points = control_points;
    return Lattice(std::move(other));
}

Lattice Lattice::with_weights(const std::vector<double>& weights) const
{
    LatticeDefinition other = definition_;
    other.weights = weights;
    return Lattice(std::move(other));
}

Lattice lattice_in_box(const Eigen::Vector3d& low, const Eigen::Vector3d& high, LatticeDefinition shape)
{
    return lattice_on_axes(low, (high - low).asDiagonal(), std::move(shape));
}

Lattice lattice_on_axes(const Eigen::Vector3d& origin, const Eigen::Matrix3d& axes, LatticeDefinition shape)
{
    const std::array<SplineAxis, 3> along = checked_axes(shape);
    flatten(shape);
    Points& P = shape.control_points;
    const Index count = shape.points[0] * shape.points[1] * shape.points[2];
    P.resize(count, 3);
    Index row = 0;
    for (Index k = 0; k < shape.points[2]; ++k)
        for (Index j = 0; j < shape.points[1]; ++j)
            for (Index i = 0; i < shape.points[0]; ++i, ++row)
                P.row(row) = (origin + axes * Eigen::Vector3d(along[0].greville(i), along[1].greville(j),
                                                              along[2].greville(k)))
                                 .transpose();
    return Lattice(std::move(shape));
}

} // namespace morph
