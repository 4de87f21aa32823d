#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/weights/boundary_extension.h"

#include <functional>

namespace morph {

/// How a boundary takes a mesh along: the displacement of every vertex, n x 2, for that of the held ones, k
/// x 2. A BoundaryExtension is one; so is extend_with_rotations(), which is not linear.
using BoundaryMove =
    std::function<Matrix(const Mesh& mesh, const DirichletBoundary& held, const Matrix& displacement)>;

} // namespace morph
