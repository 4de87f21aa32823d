#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/numerics/assembly.h"
#include "libmorph/numerics/symmetric_matrix.h"
#include "libmorph/numerics/triangle_fans.h"

#include <vector>

namespace morph {

/// M^-1/2 K of linear finite elements, a row for each fan of triangles: K the stiffness, M the lumped mass, a
/// third of the area of the fan. Unlike stiffness_edges() negative weights stay, so that K of a linear
/// function is its flux through the boundary, exactly.
struct FanLaplacian {
    VertexLists patches;       ///< the vertices of each fan
    std::vector<double> entry; ///< of each vertex in patches
    std::vector<Index> vertex; ///< of each fan: the one that it is around
    std::vector<double> root;  ///< of each fan's mass

    /// -K M^-1 (K u - flux). By differences from the fan's vertex, so that a constant u gives exactly 0.
    /// @param u     n x m
    /// @param flux  a row for each fan
    /// @return n x m
    Matrix load(const Matrix& u, const Matrix& flux) const;
};

/// @param triangulation    of the vertices of the mesh
/// @param representatives  for each vertex the one whose unknown it shares
/// @throws InputError  a triangle is flat or inverted
FanLaplacian fan_laplacian(const Mesh& mesh, const Triangulation& triangulation, const TriangleFans& fans,
                           const std::vector<Index>& representatives);

/// K M^-1 K
SymmetricMatrix bilaplacian(Index vertices, const FanLaplacian& laplacian);

} // namespace morph
