#pragma once

#include "libmorph/geometry/delaunay.h"

#include <Eigen/SparseCore>

#include <vector>

namespace morph {

/// Edge between vertices a and b, and what it adds to a stiffness matrix:
/// weight * (h_a - h_b)^2 / 2 to the energy, so K_ab = K_ba = -weight.
struct WeightedEdge {
    Index a = 0;
    Index b = 0;
    double weight = 0;
};

/// Stiffness of linear finite elements as edges: weight = (cot alpha + cot beta) / 2 with the angles
/// opposite the edge, one where the edge has one triangle [Pinkall & Polthier 1993, Experimental
/// Mathematics 2(1), 15-36].
///
/// On a constrained Delaunay triangulation no weight inside is negative in exact arithmetic; what
/// rounding, or the edge of a natural boundary, leaves below zero is set to 0, so that the matrix is an
/// M-matrix for every mesh and the discrete maximum principle holds [Ciarlet & Raviart 1973, Computer
/// Methods in Applied Mechanics and Engineering 2, 17-31]. A triangle that is flat or inverted in a
/// tangled mesh has no angles to speak of and counts as equilateral.
///
/// @param points  n x 3, z is ignored
/// @return each edge once, in an order that depends on the triangulation only
std::vector<WeightedEdge> stiffness_edges(const Eigen::Ref<const Points>& points,
                                          const Triangulation& triangulation);

/// The n x n stiffness matrix of these edges: symmetric, rows sum to zero, positive semidefinite.
Eigen::SparseMatrix<double> stiffness_matrix(Index vertices, const std::vector<WeightedEdge>& edges);

} // namespace morph
