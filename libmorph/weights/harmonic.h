#pragma once

#include "libmorph/core/names.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/boundary_extension.h"
#include "libmorph/weights/dirichlet_boundary.h"

#include <memory>

namespace morph {

/// The g in div(g grad h) = 0: where it is large the mesh moves more like a rigid body.
enum class Diffusivity {
    uniform,          ///< g = 1: Laplace's equation
    inverse_distance, ///< g = 1 / distance to the nearest moving edge
    inverse_area      ///< g = 1 / mean area of the elements around
};

template <>
inline constexpr auto kEnumNames<Diffusivity> = std::to_array<EnumName<Diffusivity>>({
    {Diffusivity::uniform, "uniform"},
    {Diffusivity::inverse_distance, "inverse-distance"},
    {Diffusivity::inverse_area, "inverse-area"},
});

/// Harmonic functions: the held values at the held vertices and div(g grad h) = 0 in between, one column for
/// each right-hand side [Joshi et al. 2007, ACM Transactions on Graphics 26(3), 71; Tavla 2021,
/// section 3.5; for the diffusivities: Jasak & Tukovic 2006, Transactions of FAMENA 30(2), 1-20].
///
/// Linear finite elements on the constrained Delaunay triangulation of the mesh's vertices, quads cut in
/// two. No edge weight is negative there, so that every column keeps the bounds of its held values on
/// every mesh: 0 <= h <= 1 when those are in [0, 1]. To keep that, g is a coefficient of the *edges*,
/// taken at their midpoints (finite volumes on the Voronoi cells); one for each triangle would bring
/// negative weights back. There it is 1 / the mean over the edge's two ends of the distance, or of the
/// mean area of the mesh's elements around the end.
///
/// Copies of a split vertex are one unknown. A vertex of no element gets 0. Scaling or shifting the mesh
/// changes the result by round-off only, and the number of threads not at all.
///
/// The system is factored here; extend() solves. Later changes to @p mesh do not matter.
///
/// @throws InputError   the mesh is a surface in space; an index in @p boundary is out of range or a vertex
///                      there twice; a part of the mesh has no held vertex; inverse_distance without moving
///                      edges
/// @throws SolverError  the system is singular
std::unique_ptr<BoundaryExtension> harmonic_extension(const Mesh& mesh, const DirichletBoundary& boundary,
                                                      Diffusivity diffusivity);

} // namespace morph
