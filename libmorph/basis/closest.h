#pragma once

#include "libmorph/basis/curve.h"

#include <vector>

namespace morph {

/// Where a node lies on a curve.
struct CurveParameter {
    double u = 0;        ///< closed: in [0, 1) · open: in [0, 1]
    double distance = 0; ///< from the node to C(u), length unit of the mesh
};

/// Parameter of the point of the curve closest to one point, found globally: no bend or near touch of
/// the curve misleads it (see DistanceMinima, which serves many points at once).
/// @throws InputError  @p point is not finite
CurveParameter closest_parameter(const Curve& curve, const Eigen::Vector2d& point);

/// Parameters of nodes that follow each other along the curve.
///
/// Each is a local minimum of the distance to the curve, mostly the global one, except that neighbours
/// get neighbouring parameters: where the curve nearly touches itself, the branch that continues the
/// sequence is taken. Among the nearest few minima of each node, dynamic programming picks the sequence
/// with the least sum of (distance beyond the nearest) x (node spacing) / (curve size) plus (arc length
/// passed over without nodes, or passed backwards), over both directions of passage.
///
/// A node that coincides with a corner of the curve, or with an end of an open one, to 1e-12 of the
/// curve's size gets its exact parameter.
///
/// @param curve   near the nodes
/// @param nodes   m x 2, in order along the marker, in either direction
/// @param closed  the last node is followed by the first; an open sequence may lie on a closed curve
/// @return m parameters with their distances
/// @throws InputError  no nodes, a node that is not finite, a closed sequence on an open curve whose
///                     ends do not meet
std::vector<CurveParameter> node_parameters(const Curve& curve, const Points2& nodes, bool closed);

} // namespace morph
