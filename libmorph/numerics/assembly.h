#pragma once

#include "libmorph/numerics/symmetric_matrix.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace morph {

/// Small sets of vertices, such as the corners of each element: set p is vertex[start[p]] to
/// vertex[start[p + 1] - 1], each vertex once.
struct VertexLists {
    std::vector<std::size_t> start{0};
    std::vector<Index> vertex;

    std::size_t count() const { return start.size() - 1; }
    std::size_t size(std::size_t p) const { return start[p + 1] - start[p]; }
    const Index* begin(std::size_t p) const { return vertex.data() + start[p]; }

    void close_list() { start.push_back(vertex.size()); }
};

/// Matrix of one patch: unknown k of its i-th vertex is row c i + k, c unknowns at each vertex.
using ElementMatrix = Eigen::MatrixXd;

/// The sum of a dense symmetric matrix for each patch: unknown k of vertex v is row c v + k. Rows are summed
/// in parallel and in the order of the patches, so that the result is as symmetric as what it is made of and
/// the same for any number of threads.
///
/// @param fill  sets the matrix of patch p, already of the right size and zero. Called from several threads,
///              once for each vertex of the patch; may throw
SymmetricMatrix assemble(Index vertices, Index components, const VertexLists& patches,
                         const std::function<void(std::size_t p, ElementMatrix& matrix)>& fill);

} // namespace morph
