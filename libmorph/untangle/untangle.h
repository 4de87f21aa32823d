#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// How untangle() works.
struct UntangleOptions {
    double size = 2;          ///< weight of keeping an element's area against keeping its shape
    double exponent = 1.3;    ///< of an element's energy: larger ones favour the worst elements over the mean
    int rings = 8;            ///< of elements around an inverted one that move with it
    int iterations = 200;     ///< at most, for each patch
    bool reinitialize = true; ///< where patches fail: also from the held vertices' move extended again
};

/// What untangle() came to.
struct UntangleResult {
    bool valid = false;          ///< no element is inverted, decided exactly on the positions
    std::vector<Index> inverted; ///< the elements that still are, ascending
    std::vector<Index>
        unrepairable;         ///< those of them with a corner Jacobian <= 0 all of whose three vertices
                              ///< are held: no positions of the others can repair them
    Index patch_vertices = 0; ///< vertices that were free to move, each time counted
    int iterations = 0;       ///< of all patches together
};

/// Repair the inverted elements of a moved mesh: drive every corner Jacobian positive and bring each element
/// as near to its shape before the move as the boundary allows.
///
/// Minimises a foldover-free energy [Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov 2021, ACM
/// Transactions on Graphics 40(4), 109] on patches around the inverted elements; where a patch is too small
/// it is grown, in the end to the whole mesh. Vertices far from inverted elements stay where they are, and
/// those of a mesh without any all do. Copies of a split vertex stay together. The same bytes for any number
/// of threads.
///
/// @param mesh       planar, n vertices; for its elements only
/// @param reference  n x 3: before the move; the shape that elements aim for
/// @param held       vertices that must not move, in any order
/// @param positions  n x 3, z = 0: after the move; the rows of held vertices stay as they are
/// @param options    limits of the search
/// @throws InputError  the mesh is a surface in space, a number of rows is wrong, a held vertex is out of
///                     range, a position is not finite, an option out of bounds
UntangleResult untangle(const Mesh& mesh, const PositionsView& reference, const std::vector<Index>& held,
                        Eigen::Ref<Points> positions, const UntangleOptions& options = {});

} // namespace morph
