#pragma once

#include "libmorph/deform/controlled_points.h"

#include <array>
#include <string>
#include <vector>

namespace morph {

/// What a length has to be.
struct Bound {
    enum class Kind { equal, at_least };

    Kind kind = Kind::at_least;
    double value = 1;
    bool relative = true; ///< the value is a part of the undisplaced length; else it is in the length unit
};

/// A closed boundary that constraints speak of.
struct ConstrainedBoundary {
    std::string name;
    ControlledPoints nodes; ///< in order along it, the last joined to the first
};

/// The area inside a boundary stays what it is without displacements [Leloudas, Strofylas & Nikolos 2018,
/// Aircraft Engineering and Aerospace Technology 90(6), 914-926, for lattices].
struct AreaKept {
    std::string name;
    std::size_t boundary = 0; ///< which of ConstraintSet::boundaries
};

/// Points with a prescribed displacement: zero, when no displacements are given.
struct FixedPoints {
    std::string name;
    ControlledPoints points; ///< m
    Matrix displacements;    ///< m x c, or empty
};

/// The extent of a boundary along a line that stays in place: an airfoil's thickness at x = 0.3 c.
struct Thickness {
    std::string name;
    std::size_t boundary = 0;                         ///< which of ConstraintSet::boundaries
    Eigen::Vector2d at = Eigen::Vector2d::Zero();     ///< a point of the line
    Eigen::Vector2d along = Eigen::Vector2d::UnitY(); ///< its direction, of any length
    Bound bound;
};

/// The distance of two points that the shape carries along: a spar's height.
struct Distance {
    std::string name;
    ControlledPoints ends; ///< 2
    Bound bound;
};

/// Control points that get the same displacement.
struct Tie {
    std::string name;
    std::vector<Index> control_points;
};

/// Control points whose displacements mirror each other in a line of the plane, or a plane in space.
struct Symmetry {
    std::string name;
    std::vector<std::array<Index, 2>> pairs;           ///< twice the same: that point stays on the mirror
    Eigen::Vector3d normal = Eigen::Vector3d::UnitY(); ///< of the mirror, of any length; z = 0 in the plane
};

/// Constraints on displacements of K control points in c = 2 or 3 dimensions. Areas and thicknesses are of
/// the plane. Names are for messages.
struct ConstraintSet {
    std::vector<ConstrainedBoundary> boundaries;
    std::vector<AreaKept> areas;
    std::vector<Thickness> thicknesses;
    std::vector<Distance> distances;
    std::vector<FixedPoints> fixed;
    std::vector<Tie> ties;
    std::vector<Symmetry> symmetries;
    std::vector<Index> held; ///< control points that keep their requested displacement
};

/// What became of an area, a thickness or a distance.
struct MeasuredConstraint {
    std::string name;
    double undisplaced = 0; ///< without any displacement
    double wanted = 0;      ///< with the requested displacements
    double bound = 0;
    double reached = 0;
    bool active = true; ///< it changed the displacements
};

/// What satisfy_constraints() found.
struct ConstrainedMove {
    Matrix displacements; ///< K x c
    double change = 0;    ///< Frobenius norm of what was added to the requested displacements
    int iterations = 0;
    std::vector<MeasuredConstraint> measured; ///< areas, thicknesses, distances, in the order of the set
};

/// The displacements nearest to the requested ones that satisfy all constraints, by least squares over the
/// control points.
///
/// Written on the rows of weights alone, so for every linear method. Fixed points, ties and symmetries are
/// linear and are eliminated; areas and lengths follow by nearest_point(). The error of a step is squared for
/// areas and distances; for thicknesses, whose derivatives are smoothed (extent_along()), it falls by about
/// the angle between neighbouring sides. Areas are met to 1e-12 of themselves, lengths to 1e-12 of the size
/// of their boundary, linear constraints to 1e-11 of the size of the displacements or shapes. Control points
/// that no constraint concerns keep their requested displacements.
///
/// The search is local and starts from the requested displacements: moves much larger than the shape can end
/// elsewhere than nearest, or get stuck.
///
/// @param constraints  what the displacements must keep
/// @param wanted       K x c, length unit of the mesh
/// @throws InputError   the sizes do not fit, a number is not finite, something does not exist; or linear
///                      constraints contradict each other: names the two most involved
/// @throws SolverError  the constraints cannot be met together: names the two most involved, as far as the
///                      nearest displacements found show; or the search got stuck, which it says
ConstrainedMove satisfy_constraints(const ConstraintSet& constraints, const Matrix& wanted);

} // namespace morph
