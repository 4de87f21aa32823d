#pragma once

#include "libmorph/mesh/mesh.h"

namespace morph {

/// What a field amounts to over a mesh, one number for each component.
struct FieldTotals {
    Eigen::RowVectorXd min;
    Eigen::RowVectorXd max;
    Eigen::RowVectorXd integral; ///< value x length unit squared; empty for a mesh without elements
};

/// Smallest and largest value and the integral of a field of @p mesh.
///
/// A nodal field is linear in triangles and bilinear in quads, whose integral is exact in the plane (in space
/// the area is measured along the mean normal); an element field is constant in each element. Areas count as
/// positive, whichever way round an element runs. Equal bytes for any thread count.
/// @param field  at least one row
FieldTotals field_totals(const Mesh& mesh, const Field& field);

} // namespace morph
