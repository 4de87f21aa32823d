#pragma once

#include "libmorph/mesh/mesh.h"

#include <vector>

namespace morph {

/// Elements of a mesh and, for each vertex, those around it. Copies of a split vertex are one vertex here,
/// known by the first of them.
struct VertexStars {
    explicit VertexStars(const Mesh& mesh);

    std::vector<Index> vertex_of;   ///< n: the vertex that stands for each
    std::vector<Element> elements;  ///< m: corners by the vertices that stand for them
    std::vector<std::size_t> start; ///< n + 1: elements around vertex v are around[start[v]] to
    std::vector<Index> around;      ///< around[start[v + 1] - 1], ascending
};

} // namespace morph
