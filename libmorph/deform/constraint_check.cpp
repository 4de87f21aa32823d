#include "libmorph/deform/constraint_check.h"

#include "libmorph/core/error.h"

namespace morph {

namespace {

/// Checks that know the number of control points and the dimension.
class Check {
public:
    explicit Check(const Matrix& wanted) : control_points_(wanted.rows()), components_(wanted.cols())
    {
        if (components_ != 2 && components_ != 3)
            throw InputError("the displacements have " + std::to_string(components_) +
                             " columns, but there are 2 or 3 dimensions");
        if (!wanted.allFinite())
            throw InputError("the requested displacements are not all finite");
    }

    void boundary(const ConstrainedBoundary& boundary) const
    {
        points("boundary '" + boundary.name + "'", boundary.nodes);
        if (boundary.nodes.positions.rows() < 3)
            throw InputError("boundary '" + boundary.name + "' has " +
                             std::to_string(boundary.nodes.positions.rows()) +
                             " nodes, but encloses an area");
    }

    void of_boundary(const std::string& name, std::size_t boundary, std::size_t boundaries) const
    {
        if (boundary >= boundaries)
            throw InputError("constraint '" + name + "' names boundary " + std::to_string(boundary) +
                             ", but there are " + std::to_string(boundaries));
        if (components_ != 2)
            throw InputError("constraint '" + name +
                             "' is of the plane, but the displacements have 3 "
                             "components");
    }

    void bound(const std::string& name, const Bound& bound) const
    {
        if (!(bound.value >= 0) || bound.value > kLargestBound)
            throw InputError("constraint '" + name + "' asks for a length of " + std::to_string(bound.value) +
                             ", but it must be finite and not negative");
    }

    void line(const Thickness& thickness) const
    {
        if (!(thickness.along.norm() > 0) || !thickness.along.allFinite() || !thickness.at.allFinite())
            throw InputError("the line of constraint '" + thickness.name + "' has no direction");
    }

    void distance(const Distance& distance) const
    {
        points("constraint '" + distance.name + "'", distance.ends);
        if (distance.ends.positions.rows() != 2)
            throw InputError("constraint '" + distance.name + "' is the distance of 2 points, but has " +
                             std::to_string(distance.ends.positions.rows()));
    }

    void fixed(const FixedPoints& fixed) const
    {
        points("constraint '" + fixed.name + "'", fixed.points);
        if (fixed.displacements.size() == 0)
            return;
        if (fixed.displacements.rows() != fixed.points.positions.rows() ||
            fixed.displacements.cols() != components_)
            throw InputError("constraint '" + fixed.name + "' has displacements of " +
                             std::to_string(fixed.displacements.rows()) + " x " +
                             std::to_string(fixed.displacements.cols()) + " for " +
                             std::to_string(fixed.points.positions.rows()) + " points in " +
                             std::to_string(components_) + " dimensions");
        if (!fixed.displacements.allFinite())
            throw InputError("the displacements of constraint '" + fixed.name + "' are not all finite");
    }

    void control_point(const std::string& what, Index k) const
    {
        if (k < 0 || k >= control_points_)
            throw InputError(what + " names control point " + std::to_string(k) + ", but there are " +
                             std::to_string(control_points_));
    }

    void symmetry(const Symmetry& symmetry) const
    {
        if (!(symmetry.normal.head(components_).norm() > 0) || !symmetry.normal.allFinite())
            throw InputError("the normal of constraint '" + symmetry.name + "' has no direction");
        for (const auto& pair : symmetry.pairs)
            for (const Index k : pair)
                control_point("constraint '" + symmetry.name + "'", k);
    }

private:
    static constexpr double kLargestBound = 1e300;

    void points(const std::string& what, const ControlledPoints& points) const
    {
        if (points.weights.cols() != control_points_ || points.weights.rows() != points.positions.rows())
            throw InputError("the points of " + what + " have weights of " +
                             std::to_string(points.weights.rows()) + " x " +
                             std::to_string(points.weights.cols()) + ", but there are " +
                             std::to_string(points.positions.rows()) + " points and " +
                             std::to_string(control_points_) + " control points");
        if (!points.positions.allFinite())
            throw InputError("the points of " + what + " are not all finite");
    }

    Eigen::Index control_points_;
    Eigen::Index components_;
};

} // namespace

void require_valid(const ConstraintSet& constraints, const Matrix& wanted)
{
    const Check check(wanted);
    for (const ConstrainedBoundary& boundary : constraints.boundaries)
        check.boundary(boundary);
    for (const AreaKept& area : constraints.areas)
        check.of_boundary(area.name, area.boundary, constraints.boundaries.size());
    for (const Thickness& thickness : constraints.thicknesses) {
        check.of_boundary(thickness.name, thickness.boundary, constraints.boundaries.size());
        check.line(thickness);
        check.bound(thickness.name, thickness.bound);
    }
    for (const Distance& distance : constraints.distances) {
        check.distance(distance);
        check.bound(distance.name, distance.bound);
    }
    for (const FixedPoints& fixed : constraints.fixed)
        check.fixed(fixed);
    for (const Tie& tie : constraints.ties)
        for (const Index k : tie.control_points)
            check.control_point("constraint '" + tie.name + "'", k);
    for (const Symmetry& symmetry : constraints.symmetries)
        check.symmetry(symmetry);
    for (const Index k : constraints.held)
        check.control_point("the list of held control points", k);
}

} // namespace morph
