#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// The elements sorted into surfaces, each of elements that are in the same groups.
///
/// Markers have the physical tags 1, 2, …, groups those that follow. Where there are any, elements of no
/// group are in one of their own: Gmsh drops what is in none when it saves the mesh, and meshio refuses it.
struct GmshSurfaces {
    std::vector<std::vector<Index>> tags; ///< of the physical groups of each surface, ascending
    std::vector<Index> of_element;        ///< surface of each element
    Index no_group = 0;                   ///< tag for the elements of no group; 0: not needed
};

/// Surfaces are numbered in the order of their first elements.
GmshSurfaces gmsh_surfaces(const MeshData& mesh);

} // namespace morph
