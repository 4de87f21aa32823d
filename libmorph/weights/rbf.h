#pragma once

#include "libmorph/mesh/domain_view.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"
#include "libmorph/weights/radial.h"

#include <memory>
#include <vector>

namespace morph {

/// How rbf_extension() interpolates.
struct RbfOptions {
    RadialFunction function = RadialFunction::wendland_c2;
    double support = 0; ///< support radius, length unit of the mesh; 0: default_support()
    bool linear = true; ///< with linear terms: affine moves of the whole boundary are reproduced exactly
};

/// Support radius of RbfOptions unless one is given: kSupportFactor times the diagonal of the box around all
/// that moves, or the diagonal of the whole mesh when that is smaller or nothing moves.
///
/// The farther the functions reach, the farther out a move is felt and the fewer elements it inverts, but
/// the worse conditioned the system is, by (reach / spacing)^3 for Wendland's C2. With this one airfoils in
/// tests/data turn by 120 degrees in one step without an inverted element; with half of it they do not.
double default_support(const DomainView& domain, const DirichletBoundary& boundary);
inline constexpr double kSupportFactor = 10;

/// Radial basis functions with their centres at held vertices [de Boer, van der Schoot and Bijl 2007,
/// Computers and Structures 85, 784-795; Wendland 2004, Scattered Data Approximation].
///
/// The matrix is dense: m^2 numbers and m^3 / 3 multiplications for m centres, which are kMostCentres at
/// most; extend() costs n m evaluations, in blocks on every core. The fixed boundary counts, too. With more
/// held vertices than that, or fewer centres for speed, take those of greedy_centres() in rbf_greedy.h.
///
/// Held vertices that are no centres keep an error, and so do centres whose system is nearly singular. It is
/// taken away where it is: at distance d from the nearest point of the boundary the error there, times
/// Wendland's C2 function of d / r, is subtracted. r is twice the distance from there to the second nearest
/// centre, the length on which the error changes along the boundary, so that it fades inwards no steeper than
/// that. So the result is exact on the boundary, smooth, and linear in the values.
///
/// @param domain    n vertices
/// @param boundary  k vertices whose values are prescribed
/// @param options   radial function, support, linear terms
/// @param centres   vertices, each a held one; empty: all of them
/// @throws InputError   as UniqueDirichletVertices; a centre is not held or given twice, two lie at the same
///                      place, or there are more than kMostCentres; with linear terms all on a line;
///                      thin_plate without linear terms; a support radius that is negative or not finite; a
///                      mesh without extent
/// @throws SolverError  the system is singular even with a multiple of the identity added; extend() throws it
///                      when a smooth function that reaches over many centres misses values that jump
std::unique_ptr<BoundaryExtension> rbf_extension(const DomainView& domain, const DirichletBoundary& boundary,
                                                 const RbfOptions& options = {},
                                                 const std::vector<Index>& centres = {});
inline constexpr Index kMostCentres = 6000; // 288 MB, twice while it is factored

} // namespace morph
