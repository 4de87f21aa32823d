#pragma once

#include "libmorph/basis/curve.h"

#include <vector>

namespace morph {

struct FitSettings {
    int degree = 3;            ///< 1 to 7
    Index control_points = 12; ///< of the whole curve
    double corner_angle =
        30; ///< degrees; a node that turns by this much more than its neighbours is a corner
};

struct CurveFit {
    CurveDefinition curve;
    std::vector<Index> corners; ///< rows of the nodes at corners of the curve, ends not included
    double max_distance = 0;    ///< from a node to the curve, length unit of the nodes
    double mean_distance = 0;
};

/// Nodes where a polygon has a corner rather than a resolved bend.
///
/// The turn at the node exceeds the mean turn (in the same sense) of its two neighbours by more than
/// @p angle. A strongly curved leading edge turns at several nodes in a row; a trailing edge at one.
/// @param nodes   m x 2, in order, no two consecutive ones coincide
/// @param closed  the last node is followed by the first
/// @param angle   degrees
/// @return rows, increasing; the ends of an open polygon are none
std::vector<Index> find_corners(const Points2& nodes, bool closed, double angle);

/// Fit a closed periodic or a clamped B-spline to nodes in order, by least squares.
///
/// Corners (find_corners) and the ends of an open sequence are interpolated exactly; a corner is a knot
/// of multiplicity `degree`, and a closed curve with corners starts at the first one. Parameters
/// start as chord lengths and are corrected by projection [Hoschek 1988, Computer Aided Geometric Design 5,
/// 27-31]; knots equidistribute the (degree + 1)-th root of the next derivative, estimated from the last
/// fit [de Boor 1978, A Practical Guide to Splines, XII, NEWKNOT], each span holding a node. The best
/// of the rounds, by the largest distance, is returned.
///
/// @param nodes     m x 2, in order along the marker
/// @param closed    the last node is followed by the first
/// @param settings  degree, number of control points, corners
/// @throws InputError  degree not in 1 ... 7; control points fewer than the degree and the corners need or
/// more
///                     than nodes; a node that is not finite or coincides with the one before it; a
///                     corner angle not in (0, 180]
CurveFit fit_curve(const Points2& nodes, bool closed, const FitSettings& settings);

} // namespace morph
