#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph::test {

/// The kernel passes OpenMesh's own checker, face circulators begin at the first corner, and boundary
/// vertices point to boundary halfedges.
void expect_sound(const Mesh& mesh);

/// Every number of two meshes as files hold them is the same, bit for bit.
void expect_same(const MeshData& a, const MeshData& b);

/// The same mesh with vertices and elements renumbered at random, and elements starting at any corner.
MeshData shuffled(const MeshData& mesh, unsigned seed);

/// Lists about @p share of the elements the other way round.
void turn_some(MeshData& mesh, double share, unsigned seed);

} // namespace morph::test
