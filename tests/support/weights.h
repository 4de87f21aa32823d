#pragma once

#include "libmorph/weights/weights.h"

namespace morph::test {

/// Dense weights between -1 and 1.
Weights random_weights(Index rows, Index columns);

/// Four weights between -1 and 1 in each row, in neighbouring columns.
SparseWeights random_sparse_weights(Index rows, Index columns);

/// The same weights with only those stored that are not zero.
SparseWeights sparse(const Weights& weights);

} // namespace morph::test
