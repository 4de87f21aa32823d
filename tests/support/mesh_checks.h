#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph::test {

/// The kernel passes OpenMesh's own checker, its links agree with each other, and the numbering has as
/// many rows as it.
void expect_sound(const Mesh& mesh);

/// The same mesh with vertices and elements renumbered at random, and elements starting at any corner.
MeshData shuffled(const MeshData& mesh, unsigned seed);

/// Lists about @p share of the elements the other way round.
void turn_some(MeshData& mesh, double share, unsigned seed);

} // namespace morph::test
