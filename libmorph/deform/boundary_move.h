#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/spread.h"

#include <functional>

namespace morph {

/// How a boundary takes a mesh along: the displacement of every vertex, n x 2, for that of the held ones, k
/// x 2. A Spread is one; so is spread_with_rotations(), which is not linear, or springs that mix x and y.
using BoundaryMove =
    std::function<Matrix(const Mesh& mesh, const HeldBoundary& held, const Matrix& displacement)>;

} // namespace morph
