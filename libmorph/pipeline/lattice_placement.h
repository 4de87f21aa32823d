#pragma once

#include "libmorph/basis/lattice.h"
#include "libmorph/weights/embed.h"
#include "libmorph/weights/weights.h"
#include "tools/case/case_file.h"
#include "tools/deform/placement.h"

#include <string>
#include <vector>

namespace morph::tools {

/// The lattice of a case around its mesh.
struct PlacedLattice {
    Lattice lattice;
    Embedding embedding;     ///< of every vertex of the mesh
    SparseWeights weights;   ///< of every vertex; rows of those outside are empty
    Matrix displacements;    ///< N x dimension of the lattice
    std::vector<Index> held; ///< control points that continuity at the box holds fixed, ascending
    std::vector<std::string> warnings;
};

/// Build the lattice of a case and find every vertex in it.
///
/// @throws InputError  "case.toml:12: …": a lattice that cannot be, one in the plane for a surface or the
/// other
///                     way round, no vertex inside, an SU2 box that the mesh file does not have
PlacedLattice place_lattice(const Mesh& mesh, const CaseFile& file);

/// What a lattice makes of the boundary, when another method carries the rest of the mesh: the nodes of its
/// markers get its basis functions, all other boundary nodes 0.
/// @throws InputError  "case.toml:12: …": a marker that does not exist, that is fixed as well, or no part of
/// which lies
///                     in the lattice
PlacedBoundaries lattice_boundary(const Mesh& mesh, const CaseFile& file, const PlacedLattice& placed);

} // namespace morph::tools
