#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph {

/// Largest absolute second derivative of a nodal field in any direction, at each vertex: the larger absolute
/// eigenvalue of its Hessian.
///
/// The Hessian is that of the quadratic through the vertex's value that fits the values of the two rings of
/// vertices around it by least squares, near ones more [as zz2 in Vallet, Manole, Dompierre, Dufour &
/// Guibault 2007, Numerical comparison of some Hessian recovery techniques, IJNME 72]; it is exact for
/// quadratics, also at a boundary. VertexLists are scaled along their principal axes first, so that stretched
/// elements do no harm. On a surface the patch is laid out in the tangent plane, every vertex at its
/// distance.
///
/// @param values  n, in the mesh's numbering
/// @return n values, unit of the field / length^2; 0 at a vertex of no element
Eigen::VectorXd largest_second_derivative(const Mesh& mesh, const Eigen::VectorXd& values);

} // namespace morph
