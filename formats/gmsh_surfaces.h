#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <vector>

namespace morph {

/// The elements sorted into surfaces, each of elements that are in the same groups.
struct GmshSurfaces {
    std::vector<std::vector<Index>>
        groups;                    ///< of each surface, ascending; the first has at least one element
    std::vector<Index> of_element; ///< surface of each element
};

/// Surfaces are numbered in the order of their first elements.
GmshSurfaces gmsh_surfaces(const MeshData& mesh);

} // namespace morph
