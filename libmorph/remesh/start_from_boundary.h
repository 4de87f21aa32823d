#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/remesh_state.h"

#include <vector>

namespace morph {

/// A mesh without the vertices inside what is to be remeshed.
struct Outline {
    Mesh mesh;
    std::vector<bool> kept;
    std::vector<Index> vertex; ///< of each of its vertices, the number in the file of the mesh
};

/// Start remeshing from the boundary of what is not kept: the corner table becomes its constrained Delaunay
/// triangulation, without features yet. Sizes and places stay those of the mesh.
/// @param state  of the mesh; its features are found, so that sizes near them are limited
/// @param kept   m: the element stays as it is
/// @throws InputError  as retriangulate()
Outline start_from_boundary(RemeshState& state, const Mesh& mesh, const std::vector<bool>& kept);

} // namespace morph
