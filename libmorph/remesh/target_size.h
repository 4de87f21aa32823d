#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/corner_table.h"

#include <array>
#include <vector>

namespace morph {

/// Mean length at each vertex of the edges of triangles or, where there are none, of all edges: n values, 0
/// at one of no element. Quads of boundary layers are much thinner than the triangles next to them.
Eigen::VectorXd current_sizes(const Mesh& mesh);

/// Sizes in the proportion that makes the L2 error of linear interpolation of a field least for a number of
/// vertices: the power -1/3 of its largest second derivative [the isotropic case of Alauzet & Loseille 2010,
/// High-order sonic boom modeling based on adaptive methods, JCP 229, for p = 2]; of several components each
/// counts by its range and the one that needs the smallest size decides. Nowhere more than 100 times the
/// smallest. To be scaled, see scale_to_vertices().
///
/// @param values  n x components, finite
/// @return n positive values; all equal for a linear field
Eigen::VectorXd interpolation_sizes(const Mesh& mesh, const Matrix& values);

/// Lower target sizes where they grow too fast: the lengths of edges that follow each other then differ by no
/// more than the factor @p gradation, measured along the edges of the mesh.
/// @param gradation  above 1
void limit_gradation(const Mesh& mesh, double gradation, Eigen::VectorXd& sizes);

/// The same on a corner table, around some of its vertices only: sizes grow from there by no more than that,
/// whereas those far away stay as they are however they grow.
void limit_gradation(CornerTable& table, double gradation, const std::vector<Index>& from);

/// Scale target sizes so that equilateral triangles of them fill the mesh with about this many vertices.
void scale_to_vertices(const Mesh& mesh, Index vertices, Eigen::VectorXd& sizes);

/// How well the edges of a mesh have the target lengths.
struct SizeConformity {
    double share = 1; ///< of the edges: between 0.7 and 1.4 times it
    std::array<Index, 2> worst{
        -1, -1};                ///< ends of the edge whose length is the farthest from it, by its logarithm
    double relative_length = 1; ///< of that edge: its length over the target
};

/// The length of each edge, but those of quads, which are never remeshed, against the mean of the target
/// sizes at its ends.
/// @param sizes  n, positive
SizeConformity edge_conformity(const Mesh& mesh, const Eigen::VectorXd& sizes);

/// The share of edge_conformity() alone.
double size_conformity(const Mesh& mesh, const Eigen::VectorXd& sizes);

} // namespace morph
