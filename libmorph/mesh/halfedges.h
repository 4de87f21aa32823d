#pragma once

#include "libmorph/mesh/mesh.h"

#include <array>
#include <vector>

namespace morph {

/// Which halfedge each side of each element is, before there is a kernel.
///
/// Edges are numbered by their smaller vertex, then by their larger one. Edge e consists of halfedge
/// 2e, from the smaller to the larger vertex, and 2e + 1 back: as OpenMesh has it.
struct EdgeTable {
    std::vector<std::array<Index, 4>> sides; ///< m: halfedge from corner k to k + 1; 4th of a triangle: -1
    std::vector<Index>
        first_edge;         ///< n + 1: edges first_edge[v] to first_edge[v + 1] have v as smaller vertex
    bool consistent = true; ///< no halfedge is a side of two elements

    Index edge_count() const { return first_edge.back(); }
};

/// Find the sides that elements share, without hashing: sides are put into a bucket for each smaller
/// vertex, and the few in each bucket are sorted.
///
/// @param elements   m elements in the numbering of the mesh, distinct vertices in each
/// @param vertices   number of vertices n
/// @param numbering  file numbers for the messages
/// @throws InputError  an edge of three or more elements
EdgeTable match_edges(const std::vector<Element>& elements, Index vertices, const Numbering& numbering);

/// Make the connectivity of all elements at once.
///
/// @param kernel    has its n vertices, but no edges or faces yet
/// @param elements  m elements
/// @param edges     of the elements, consistent
/// Where several fans meet in a vertex, each boundary loop stays within its fan; see
/// split_nonmanifold_vertices().
void fill_kernel(Kernel& kernel, const std::vector<Element>& elements, const EdgeTable& edges);

/// The halfedge between two vertices of a kernel as fill_kernel() leaves it; -1 when there is none.
Index find_halfedge(const Kernel& kernel, const EdgeTable& edges, Index from, Index to);

} // namespace morph
