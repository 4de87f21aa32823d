#pragma once

#include "libmorph/geometry/delaunay.h"
#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/unique_dirichlet_vertices.h"

namespace morph {

/// The constrained Delaunay triangulation of the mesh's vertices, quads cut in two. Walls are constraints:
/// the moving and the fixed edges with prescribed values at both ends.
Triangulation walled_triangulation(const Mesh& mesh, const DirichletBoundary& boundary,
                                   const UniqueDirichletVertices& vertices);

} // namespace morph
