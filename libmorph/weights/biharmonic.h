#pragma once

#include "libmorph/core/names.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <memory>

namespace morph {

/// The second condition of biharmonic displacements on the held boundary.
enum class BiharmonicCondition {
    clamped,   ///< du/dn = 0: biharmonic_extension()
    conformal, ///< the mesh turns with its boundary: conformal_biharmonic_extension()
};

template <>
inline constexpr auto kEnumNames<BiharmonicCondition> = std::to_array<EnumName<BiharmonicCondition>>({
    {BiharmonicCondition::clamped, "clamped"},
    {BiharmonicCondition::conformal, "conformal"},
});

/// Biharmonic functions: laplace(laplace u) = 0 with two conditions on the held boundary, u as given and
/// du/dn = 0 [for meshes: Helenbrook 2003, International Journal for Numerical Methods in Engineering 56(7),
/// 1007-1021]. Near a wall the mesh keeps its distances from it when the wall is shifted.
///
/// Mixed linear finite elements with a lumped mass M on the constrained Delaunay triangulation of the mesh's
/// vertices, quads cut in two: M w = K u at every vertex, held ones among them, and K w = 0 at the free ones
/// [Ciarlet & Raviart 1974, Mathematical Aspects of Finite Elements in Partial Differential Equations,
/// 125-145]. That M w = K u also at the boundary is the second condition, in the weak sense. It holds on
/// either side of an inner wall by itself, and at a boundary vertex that is not held with d(laplace u)/dn =
/// 0.
///
/// Constants are reproduced; other linear functions are not, as their du/dn is not zero. Values may leave the
/// bounds of the held ones. Copies of a split vertex are one unknown; a vertex of no element gets 0. Scaling,
/// turning or shifting the mesh changes the result by round-off only, which stretched layers of cells
/// enlarge: the condition of the system is the square of that of harmonic functions.
///
/// @throws InputError   the mesh is a surface in space; an index in @p boundary is out of range or a vertex
///                      there twice; a part of the mesh has no held vertex; an element is inverted
/// @throws SolverError  the system is singular
std::unique_ptr<BoundaryExtension> biharmonic_extension(const Mesh& mesh, const DirichletBoundary& boundary);

/// Biharmonic displacements whose second condition on the held boundary lets the mesh turn with it: du/dn is
/// du/ds turned by a right angle, n and s being the normal and the tangent. Those are the Cauchy-Riemann
/// equations: at the wall the move is conformal, so that lines of the mesh that are orthogonal to it stay so,
/// and are stretched as the wall is.
///
/// The system is that of biharmonic_extension(); the condition adds -du/dn to K u at the boundary, where the
/// integral over an edge is half the difference of its ends' displacements, turned [the gradient of the area,
/// as in Desbrun, Meyer & Alliez 2002, Computer Graphics Forum 21(3), 209-218]. Shifting, turning by any
/// angle and scaling the whole boundary does the same with the mesh.
///
/// @throws InputError, SolverError  as biharmonic_extension()
std::unique_ptr<BoundaryExtension> conformal_biharmonic_extension(const Mesh& mesh,
                                                                  const DirichletBoundary& boundary);

} // namespace morph
