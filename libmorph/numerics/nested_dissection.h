#pragma once

#include "libmorph/numerics/symmetric_matrix.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace morph {

/// Order of elimination as a tree: each node eliminates a set of rows that separates what its children
/// eliminate, so that the children do not know of each other.
struct Dissection {
    struct Node {
        Index begin = 0; ///< the node eliminates order[begin] to order[end - 1]
        Index end = 0;
        Index parent = -1;                     ///< -1: a root
        std::array<Index, 2> children{-1, -1}; ///< -1: none
    };
    std::vector<Index> order; ///< n: row eliminated at each position
    std::vector<Node> nodes;  ///< children before parents, positions in ascending order
};

/// Nested dissection of the graph of a matrix by straight cuts through the points that its rows stand for
/// [George 1973, SIAM Journal on Numerical Analysis 10(2), 345-363; by coordinates: Heath & Raghavan 1995,
/// SIAM Journal on Matrix Analysis and Applications 16(1), 235-253].
///
/// Each set is cut near its median across whichever of the axes gives the fewest vertices on the cut. Any
/// points give a valid order; good ones are near their neighbours. The result depends on the arguments only.
///
/// @param where  n x d, finite
Dissection nested_dissection(const SymmetricMatrix& A, const Eigen::Ref<const Matrix>& where);

} // namespace morph
