#pragma once

#include "libmorph/pipeline/placement.h"
#include "libmorph/pipeline/settings.h"
#include "libmorph/weights/embed.h"
#include "libmorph/weights/weights.h"

#include <string>
#include <vector>

namespace morph {

/// The lattice of a move around its mesh.
struct PlacedLattice {
    Lattice lattice;
    Embedding embedding;     ///< of every vertex of the mesh
    SparseWeights weights;   ///< of every vertex; rows of those outside are empty
    Matrix displacements;    ///< N x dimension of the lattice
    std::vector<Index> held; ///< control points that continuity at the box holds fixed, ascending
    std::vector<std::string> warnings;
};

/// Build the lattice of a move and find every vertex in it.
///
/// @param mesh      undeformed, n vertices
/// @param settings  with a lattice
/// @throws InputError  names [lattice]: a lattice that cannot be, one in the plane for a surface or the other
///                     way round, no vertex inside, displacements of another number
PlacedLattice place_lattice(const Mesh& mesh, const MotionSettings& settings);

/// How a lattice moves the boundary, when another method moves the rest of the mesh: the nodes of its markers
/// get its basis functions, all other boundary nodes 0.
/// @throws InputError  names [lattice]: a marker that does not exist, that is fixed as well, or no node of which
///                     lies in the lattice
PlacedBoundaries lattice_boundary(const Mesh& mesh, const MotionSettings& settings,
                                  const PlacedLattice& placed);

} // namespace morph
