#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph {

/// Turn the flat arrays of a file into a halfedge mesh, handling once what OpenMesh refuses but real
/// files hold.
///
/// - Vertices and elements are renumbered along a space-filling curve (see Numbering).
/// - Elements listed the other way round than the neighbours they share an edge with are reversed to
///   the orientation of the majority; in a planar mesh whole parts listed clockwise are reversed too.
///   An element that is inverted by its coordinates alone (its edges agree with its neighbours')
///   is not reversed: it is a tangle to be reported, not a way of listing.
/// - A non-manifold vertex, where several fans of elements meet, is split, one copy for each fan.
/// - Vertices of no element are kept as isolated vertices.
///
/// @throws InputError  a vertex index out of range, a coordinate that is not finite, an element with
///                     a repeated vertex, an element listed twice, an edge of three elements, a surface
///                     that cannot be oriented, a marker edge that is no edge of an element, a group
///                     that names an element twice or one that is none, a field with the wrong number of
///                     rows; each names the ids (file numbers) involved
Mesh build_mesh(MeshData data);

/// The mesh in the numbering, orientation and marker order of its file: the inverse of build_mesh().
MeshData to_mesh_data(const Mesh& mesh);

} // namespace morph
