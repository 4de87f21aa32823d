#pragma once

#include "libmorph/remap/locate.h"

#include <vector>

namespace morph {

/// Areas of two planar meshes, and of what they have in common; length unit squared. Every element counts as
/// positive, whichever way round it runs.
struct CommonArea {
    double common = 0;
    double source = 0;
    double target = 0;
};

/// Values carried so that their integral over the common region of two meshes is kept.
struct ConservedValues {
    Matrix values;                ///< rows of elements or vertices of the target; 0 where nothing covers
    std::vector<Index> uncovered; ///< those rows, ascending: fill them from elsewhere
    CommonArea area;
    Eigen::RowVectorXd source_integral; ///< over the common region
    Eigen::RowVectorXd target_integral; ///< over the common region
};

/// Carry element values conservatively, to first order: each target element gets the mean over what the
/// source covers of it, from the exact areas that elements have in common.
///
/// Both integrals are equal to rounding. Equal bytes for any thread count.
/// @param values  one row for each element of the source, any number of columns
/// @throws InputError  see for_each_overlap()
ConservedValues conserve_element_values(const Locator& source, const Mesh& target, const Matrix& values);

/// Carry nodal values conservatively, to second order: of the functions that are linear in the triangles of
/// the target (quads are cut along the diagonal 1-3), the one nearest to the source's in the mean square over
/// the common region [Farrell, Piggott, Pain, Gorman & Wilson 2009, Computer Methods in Applied Mechanics and
/// Engineering 198, 2632-2642: Galerkin projection on the supermesh].
///
/// The mass matrix is the consistent one, not lumped: lumping would lose the second order. Both sides of
/// the projection are integrated exactly over what elements have in common, and the system is solved by
/// conjugate gradients to a residual that leaves both integrals equal to 1e-13 of the field's size times the
/// area. Linear functions are carried exactly. Where the source jumps, values may overshoot. Equal bytes for
/// any thread count.
/// @param values  one row for each vertex of the source, any number of columns
/// @throws InputError   see for_each_overlap()
/// @throws SolverError  conjugate gradients did not converge
ConservedValues conserve_nodal_values(const Locator& source, const Mesh& target, const Matrix& values);

} // namespace morph
