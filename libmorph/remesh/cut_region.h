#pragma once

#include "libmorph/mesh/mesh.h"

#include <array>
#include <vector>

namespace morph {

/// Elements to be cut out of a mesh, and triangles that fill the hole.
struct CutRegion {
    std::vector<bool> cut;                       ///< m: the element is cut out
    std::vector<std::array<Index, 3>> triangles; ///< counter-clockwise, vertices by their numbers in the file
};

/// Find the smallest region to cut out that has an outline which bounds it: the elements not kept, the
/// inverted ones and, where the outline crosses itself, those around the crossing.
///
/// @param mesh            planar
/// @param kept            m: elements to keep
/// @param inner_vertices  triangles may have other vertices than those of the outline and of markers
/// @throws InputError     as retriangulate()
CutRegion cut_region(const Mesh& mesh, const std::vector<bool>& kept, bool inner_vertices);

} // namespace morph
