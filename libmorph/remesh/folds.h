#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// Triangles of a remeshed surface that lie on it the wrong way round.
///
/// They are turned by more than 90 degrees against the triangles of the old surface nearest to their centre
/// and to points near their corners: all of these, because on a plate thinner than the sagitta of its
/// triangles the nearest one may be on the other side.
///
/// @return face numbers of @p made, ascending; none for planar meshes
std::vector<Index> folded_triangles(const Mesh& old, const Mesh& made);

} // namespace morph
