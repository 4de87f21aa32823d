#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// Vertices one after the other along connected edges of a marker.
struct Chain {
    std::vector<Index> vertices; ///< each once, also when closed
    bool closed = false;         ///< an edge joins the last vertex to the first
};

/// Order the edges of a marker into chains, in the direction most of their edges have.
///
/// A closed chain starts at the first vertex of its first edge in file order; an open one at an end.
/// Chains come in the order of their first edges. A chain passes through a split vertex by one of its copies.
///
/// @param marker     its edges in any order
/// @param numbering  file numbers for the messages
/// @throws InputError  the marker has no edges, lists one twice, or branches at a vertex (three or more
///                     edges meet)
std::vector<Chain> marker_chains(const Marker& marker, const Numbering& numbering);

/// The one chain of a marker.
/// @throws InputError  as marker_chains(), or the marker is not in one piece
Chain marker_chain(const Marker& marker, const Numbering& numbering);

} // namespace morph
