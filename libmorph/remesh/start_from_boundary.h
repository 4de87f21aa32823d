#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/remesh_state.h"

#include <vector>

namespace morph {

/// A mesh without the vertices inside what is to be remade.
struct Outline {
    Mesh mesh;
    std::vector<bool> kept;
    std::vector<Index> vertex; ///< of each of its vertices, the number in the file of the mesh
};

/// Start remaking from the outline of what is not kept: the net becomes its constrained Delaunay
/// triangulation, without features yet. Sizes and places stay those of the mesh.
/// @param made  of the mesh; its features are found, so that sizes near them are limited
/// @param kept  m: the element stays as it is
/// @throws InputError  as retriangulate()
Outline start_from_outline(RemeshState& made, const Mesh& mesh, const std::vector<bool>& kept);

} // namespace morph
