#pragma once

#include "libmorph/basis/fit.h"
#include "libmorph/geometry/curve_crossing.h"
#include "libmorph/mesh/chain.h"

#include <string>
#include <vector>

namespace morph {

/// A marker and the curve fitted to its nodes.
struct FittedMarker {
    std::string name;
    Chain chain; ///< the nodes in order
    CurveFit fit;
    std::vector<Index> corner_ids; ///< file numbers of the nodes at corners of the curve
};

/// Fit a curve to the nodes of a marker of a planar mesh, as a start for moving it: see fit_curve().
///
/// @throws InputError  no such marker (names the nearest), or it is not one chain: as marker_chain(); the mesh
///                     is a surface in space; as fit_curve(), the marker named
FittedMarker fit_marker(const Mesh& mesh, const std::string& name, const FitSettings& settings = {});

/// Two fitted curves that cross, or one that crosses itself.
struct FittedCrossing {
    Index first = 0;  ///< of the fitted markers
    Index second = 0; ///< the same where the curve crosses itself
    CurveCrossing crossing;
};

/// A crossing of each fitted curve with itself and of each two with each other, as far as there is one: a
/// curve of too few control points may have some, and no valid mesh can follow it.
std::vector<FittedCrossing> fitted_crossings(const std::vector<FittedMarker>& markers);

} // namespace morph
