#pragma once

#include "libmorph/pipeline/settings.h"
#include "libmorph/quality/quality.h"
#include "libmorph/weights/boundary.h"

#include <string>
#include <vector>

namespace morph {

/// The curves of a move on their markers: every boundary node has its parameter, every control point its
/// displacement.
struct PlacedBoundaries {
    std::vector<CurveBoundary> boundaries;
    BoundaryConditions conditions;
    Matrix displacements; ///< K x 2 (of a lattice on a surface K x 3), rows as conditions.columns
};

/// How a boundary sits on its curve, and how it arrived on the moved one. Lengths in the unit of the mesh.
struct BoundaryFit {
    double largest_distance = 0; ///< node to curve, before the move
    double mean_distance = 0;
    double landing_error = 0; ///< largest distance of a moved node to moved curve + its distance before,
                              ///< relative to the size of the curve
};

/// Give every node of every curve's marker its parameter.
/// @throws InputError  names the boundary that does not go with the mesh, or whose curve crosses itself; ends
///                     that meet are moved apart
PlacedBoundaries parametrize_boundaries(const Mesh& mesh, const MotionSettings& settings);

/// The curve of boundary @p b with its control points displaced.
/// @param placed         the curves on their markers
/// @param b              number of the boundary
/// @param displacements  K x 2, rows as placed.conditions.columns
Curve moved_curve(const PlacedBoundaries& placed, std::size_t b, const Matrix& displacements);

/// @param placed         the curves on their markers
/// @param b              number of the boundary
/// @param displacements  K x 2, rows as placed.conditions.columns
/// @param before,        after  n x 3 positions of the mesh's vertices
BoundaryFit boundary_fit(const PlacedBoundaries& placed, std::size_t b, const Matrix& displacements,
                         const PositionsView& before, const PositionsView& after);

/// What a person should know before trusting the result: a marker far off its curve, vertices that no
/// marker names.
std::vector<std::string> placement_warnings(const PlacedBoundaries& placed);

/// Where moved boundaries cross themselves or each other, one sentence each. No valid mesh exists then:
/// its elements may all be positive and still lie on top of each other.
/// @param placed         the curves on their markers
/// @param displacements  K x 2, rows as placed.conditions.columns
std::vector<std::string> boundary_crossings(const PlacedBoundaries& placed, const Matrix& displacements);

} // namespace morph
