#pragma once

#include "libmorph/mesh/mesh_data.h"
#include "tests/support/paths.h"

#include <string>
#include <vector>

namespace morph::test {

/// Unit square of cells x cells squares, each cut into two triangles; markers bottom, right, top, left.
/// Inner vertices are shifted off the even grid (a wrong stencil passes on an even one).
MeshData uneven_square(Index cells);

/// Unit square of cells x cells quads with the same markers, inner vertices shifted.
MeshData quad_square(Index cells);

/// Ring inner < r < outer: around x radial triangulated cells, geometrically graded; markers
/// "inner" and "outer".
MeshData annulus(double inner, double outer, Index around, Index radial);

/// An annulus turned by an odd angle, its vertices shifted by a smooth map that is the same for every
/// refinement and leaves both circles as they are.
MeshData uneven_annulus(double inner, double outer, Index around);

/// Two uneven squares that touch in the corner (1, 1), which the builder splits; the markers of the second
/// are called "bottom 2", "right 2", "top 2" and "left 2".
MeshData touching_squares(Index cells);

/// The real meshes in tests/data/meshes, as absolute paths.
std::vector<std::string> real_meshes();

} // namespace morph::test
