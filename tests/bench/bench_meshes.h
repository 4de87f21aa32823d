#pragma once

#include "libmorph/mesh/mesh_data.h"

namespace morph::bench {

/// How vertices and elements are numbered: row by row, or at random, which is worse than what mesh
/// generators leave but of the same kind.
enum class Order { sorted, shuffled };

/// Unit square of about @p vertices vertices and twice as many triangles; markers bottom, right, top, left.
MeshData triangulated_square(Index vertices, Order order);

/// Ring 1 < r < 10 of about @p vertices vertices and twice as many triangles; markers "inner" and "outer".
MeshData triangulated_annulus(Index vertices, Order order);

/// The same mesh with vertices and elements renumbered at random; the same seed gives the same numbers.
void shuffle(MeshData& mesh, unsigned seed = 1);

} // namespace morph::bench
