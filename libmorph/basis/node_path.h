#pragma once

#include "libmorph/basis/curve.h"

#include <vector>

namespace morph {

/// Nodes to be fitted, cut into segments by pins: corners, ends, or the seam of a closed curve without
/// corners. A closed path repeats its first node at the end.
struct NodePath {
    Points2 points;          ///< n x 2
    std::vector<double> t;   ///< n increasing parameters from 0 to 1; those of pins stay
    std::vector<Index> pins; ///< rows of points, the first 0 and the last n - 1
    bool closed = false;
    bool smooth_seam = false; ///< closed without corners: the pin is no corner
};

/// The path of nodes with these corners (rows of @p nodes), parameters by chord length.
///
/// Segments between corners too short to determine a polynomial of the degree (a blunt trailing edge of
/// one edge) get additional points on their edges.
NodePath make_path(const Points2& nodes, bool closed, const std::vector<Index>& corners, int degree);

/// How much work the curve has to do up to each point of a path: n increasing values. Knots at equal
/// steps of it share the work.
using Effort = std::vector<double>;

/// Half chord length, half turning; a first guess before there is a curve.
Effort polygon_effort(const NodePath& path);

/// The integral of |C^(p+1)|^(1/(p+1)), from the jumps of the p-th derivative between the pieces of the
/// curve, over a base of chord length that keeps every span busy.
Effort curve_effort(const NodePath& path, const Curve& curve);

/// Knots (as in CurveDefinition) for this many control points: each pin but a smooth seam has full
/// multiplicity, and each span holds at least one point that is no pin.
/// @throws InputError  the segments need more control points, or their points allow fewer
std::vector<double> place_knots(const NodePath& path, const Effort& effort, int degree, Index control_points);

} // namespace morph
