#pragma once

#include "libmorph/weights/boundary.h"
#include "tools/case/case_file.h"

#include <string>
#include <vector>

namespace morph::tools {

/// A case brought onto its mesh: every boundary node has its parameter, every control point its displacement.
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

/// @throws InputError  "case.toml:12: …" for a boundary that does not go with the mesh
PlacedBoundaries parametrize_boundaries(const Mesh& mesh, const CaseFile& file);

/// The curve of boundary @p b with its control points displaced.
Curve moved_curve(const PlacedBoundaries& placed, std::size_t b);

/// @param before, after  n x 3 positions of the mesh's vertices
BoundaryFit boundary_fit(const PlacedBoundaries& placed, std::size_t b,
                         const Eigen::Ref<const Points>& before, const Eigen::Ref<const Points>& after);

/// What a person should know before trusting the result: a marker far off its curve, vertices that no
/// marker names.
std::vector<std::string> placement_warnings(const PlacedBoundaries& placed);

/// Where moved boundaries cross themselves or each other, one sentence each. No valid mesh exists then:
/// its elements may all be positive and still lie on top of each other.
std::vector<std::string> boundary_crossings(const PlacedBoundaries& placed);

} // namespace morph::tools
