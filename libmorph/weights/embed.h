#pragma once

#include "libmorph/basis/lattice.h"
#include "libmorph/weights/lattice_tree.h"

#include <cstdint>
#include <vector>

namespace morph {

/// The parameters of points in a lattice.
struct Embedding {
    Points parameters;                ///< n x 3: (u, v, w) in [0, 1]; w = 0 in the plane; 0 outside
    std::vector<std::uint8_t> inside; ///< n: 1 in the image of the lattice, its boundary included, else 0
    Index inside_count = 0;
};

/// Find the parameters of points in a lattice, which may be deformed: S(parameters) = points.
///
/// A tree of boxes over parts of the lattice gives a start from which Newton's method converges
/// [Tavla 2021, 2.2, with a Newton finish]. Points that follow each other begin in the part of the one
/// before. S is met to 1e-14 of the lattice's size, and to the rounding of the coordinates; points that lie
/// as close to the boundary count as inside. Where the lattice is folded a point gets one of its parameters,
/// or none. Points with a coordinate that is not finite are outside. Equal bytes for any thread count.
///
/// @param tree    of the lattice
/// @param points  n x 3, length unit of the mesh; in the plane z does not count
Embedding embed(const LatticeTree& tree, const Eigen::Ref<const Points>& points);

/// The same where the tree is not needed again.
Embedding embed(const Lattice& lattice, const Eigen::Ref<const Points>& points);

} // namespace morph
