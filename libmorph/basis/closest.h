#pragma once

#include "libmorph/basis/curve.h"

#include <vector>

namespace morph {

/// Where a node lies on a curve.
struct CurveParameter {
    double u = 0;        ///< in [0, 1)
    double distance = 0; ///< from the node to C(u), length unit of the mesh
};

/// Parameter of the point of the curve closest to one point, found globally.
CurveParameter closest_parameter(const Curve& curve, const Eigen::Vector2d& point);

/// Parameters of nodes that follow each other along the curve.
///
/// Each is the closest point of the curve, found globally, except that neighbours get neighbouring
/// parameters: where the curve nearly touches itself, the branch that continues the sequence is taken.
/// Open curves: a node that coincides with an end of the curve gets 0 or 1 exactly.
///
/// @param nodes   m x 2, in order along the marker, in either direction
/// @param closed  the last node is followed by the first
/// @return m parameters with their distances
/// @throws InputError  a closed chain of nodes on an open curve whose ends do not meet, …
std::vector<CurveParameter> node_parameters(const Curve& curve, const Points2& nodes, bool closed);

} // namespace morph
