#pragma once

#include "libmorph/basis/lattice.h"
#include "libmorph/weights/embed.h"
#include "libmorph/weights/weights.h"

namespace morph {

/// The weights of a lattice: each vertex in it has the basis functions of its parameters, one outside none,
/// so that it never moves [Sederberg & Parry 1986, SIGGRAPH 20(4), 151-160; Tavla 2021, 2.2].
///
/// Rows of vertices inside have at most (p + 1)(q + 1)(r + 1) entries, whatever the number of control points.
/// Equal bytes for any thread count.
/// @return n x N, columns called "lattice"
SparseWeights lattice_weights(const Lattice& lattice, const Embedding& embedding);

} // namespace morph
