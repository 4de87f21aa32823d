#include "libmorph/deform/measured_conditions.h"

#include "libmorph/core/error.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace morph {

namespace {

using Kind = ShapeMeasure::Kind;

constexpr double kNothing =
    1e-12; ///< part of a gradient that rounding leaves where linear constraints take all

/// Where nothing is displaced, no control point is needed.
ControlledPoints at_rest(const ControlledPoints& shape)
{
    return {shape.positions, {shape.weights.rows(), 0}};
}

void require_measurable(const Requirement& requirement)
{
    if (std::isnan(requirement.undisplaced))
        throw InputError("the line of constraint '" + requirement.name + "' does not cross its boundary");
    if (requirement.measure.kind == Kind::area && !(requirement.undisplaced > 0))
        throw InputError("constraint '" + requirement.name +
                         "' keeps an area, but its boundary encloses none");
}

/// Read the bounds, now that the undisplaced measures are known.
void find_targets(const std::vector<ControlledPoints>& shapes, Eigen::Index components,
                  std::vector<Requirement>& requirements)
{
    std::vector<ControlledPoints> resting;
    resting.reserve(shapes.size());
    for (const ControlledPoints& shape : shapes)
        resting.push_back(at_rest(shape));
    const Eigen::VectorXd undisplaced =
        measures_of(requirements, std::move(resting), components).at(Matrix(0, components)).values;
    for (std::size_t j = 0; j < requirements.size(); ++j) {
        Requirement& requirement = requirements[j];
        const double value = undisplaced[static_cast<Eigen::Index>(j)];
        requirement.measure.turn = value < 0 ? -1 : 1; // extents and distances are not negative
        requirement.undisplaced = std::abs(value);
        require_measurable(requirement);
        const Bound& bound = requirement.bound;
        requirement.target = bound.relative ? bound.value * requirement.undisplaced : bound.value;
        requirement.scale = requirement.measure.kind == Kind::area
                                ? requirement.undisplaced
                                : size_of(shapes[requirement.measure.shape]);
    }
}

} // namespace

std::vector<ControlledPoints> shapes_of(const ConstraintSet& constraints)
{
    std::vector<ControlledPoints> shapes;
    shapes.reserve(constraints.boundaries.size() + constraints.distances.size());
    for (const ConstrainedBoundary& boundary : constraints.boundaries)
        shapes.push_back(boundary.nodes);
    for (const Distance& distance : constraints.distances)
        shapes.push_back(distance.ends);
    return shapes;
}

std::vector<Requirement> requirements_of(const ConstraintSet& constraints,
                                         const std::vector<ControlledPoints>& shapes, Eigen::Index components)
{
    std::vector<Requirement> all;
    const auto require = [&all](const std::string& name, const ShapeMeasure& measure, Bound bound) {
        Requirement requirement;
        requirement.name = name;
        requirement.measure = measure;
        requirement.bound = bound;
        all.push_back(requirement);
    };
    for (const AreaKept& area : constraints.areas)
        require(area.name, {Kind::area, area.boundary, {}, {}}, {Bound::Kind::equal, 1, true});
    for (const Thickness& t : constraints.thicknesses)
        require(t.name, {Kind::extent, t.boundary, t.at, t.along.normalized()}, t.bound);
    std::size_t shape = constraints.boundaries.size();
    for (const Distance& distance : constraints.distances)
        require(distance.name, {Kind::distance, shape++, {}, {}}, distance.bound);
    find_targets(shapes, components, all);
    return all;
}

double size_of(const ControlledPoints& shape)
{
    if (shape.positions.rows() == 0)
        return 0;
    return (shape.positions.colwise().maxCoeff() - shape.positions.colwise().minCoeff()).norm();
}

ShapeMeasures measures_of(const std::vector<Requirement>& requirements, std::vector<ControlledPoints> shapes,
                          Eigen::Index components)
{
    std::vector<ShapeMeasure> measures;
    measures.reserve(requirements.size());
    for (const Requirement& requirement : requirements)
        measures.push_back(requirement.measure);
    return {std::move(shapes), std::move(measures), components};
}

MeasuredConditions::MeasuredConditions(const std::vector<Requirement>& requirements,
                                       const ShapeMeasures& measures, const SolutionSpace& space,
                                       double length, Eigen::Index components)
    : measures_(measures), space_(space), length_(length), components_(components),
      equations_(std::count_if(requirements.begin(), requirements.end(),
                               [](const Requirement& r) { return r.bound.kind == Bound::Kind::equal; }))
{
    const auto count = static_cast<Eigen::Index>(requirements.size());
    targets_.resize(count);
    scales_.resize(count);
    for (Eigen::Index j = 0; j < count; ++j) {
        targets_[j] = requirements[static_cast<std::size_t>(j)].target;
        scales_[j] = requirements[static_cast<std::size_t>(j)].scale;
    }
}

Matrix MeasuredConditions::displacements(const Eigen::VectorXd& y) const
{
    const Eigen::VectorXd unknowns = space_.at(length_ * y);
    return Eigen::Map<const Matrix>(unknowns.data(), unknowns.size() / components_, components_);
}

Conditions::Values MeasuredConditions::at(const Eigen::VectorXd& y) const
{
    const ShapeMeasures::Values measured = measures_.at(displacements(y));
    Eigen::MatrixXd jacobian = space_.restrict_rows(measured.jacobian);
    for (Eigen::Index j = 0; j < jacobian.rows(); ++j)
        if (jacobian.row(j).norm() <= kNothing * measured.jacobian.row(j).norm())
            jacobian.row(j).setZero();
    return {(measured.values - targets_).cwiseQuotient(scales_),
            scales_.cwiseInverse().asDiagonal() * (length_ * jacobian)};
}

void MeasuredConditions::add_hessian(const Eigen::VectorXd& y, const Eigen::VectorXd& factors,
                                     Eigen::MatrixXd& hessian) const
{
    const Eigen::Index n = space_.base().size();
    Eigen::MatrixXd form = Eigen::MatrixXd::Zero(n, n);
    measures_.add_hessian(displacements(y), factors.cwiseQuotient(scales_), form);
    hessian += length_ * length_ * space_.restrict_form(form);
}

} // namespace morph
