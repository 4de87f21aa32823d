#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remesh/triangle_net.h"

#include <vector>

namespace morph {

/// Mean length of the edges at each vertex: n values, 0 at one of no element.
Eigen::VectorXd own_sizes(const Mesh& mesh);

/// Lower wanted sizes where they grow too fast: the lengths of edges that follow each other then differ by no
/// more than the factor @p gradation, measured along the edges of the mesh.
/// @param gradation  above 1
void limit_gradation(const Mesh& mesh, double gradation, Eigen::VectorXd& sizes);

/// The same on a net, around some of its vertices only: sizes grow from there by no more than that, whereas
/// those far away stay as they are however they grow.
void limit_gradation(TriangleNet& net, double gradation, const std::vector<Index>& from);

/// Scale wanted sizes so that equilateral triangles of them fill the mesh with about this many vertices.
void scale_to_vertices(const Mesh& mesh, Index vertices, Eigen::VectorXd& sizes);

/// Share of the edges of a mesh whose length is between 0.7 and 1.4 times the mean of the sizes wanted at
/// their ends.
double size_conformity(const Mesh& mesh, const Eigen::VectorXd& sizes);

} // namespace morph
