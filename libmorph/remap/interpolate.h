#pragma once

#include "libmorph/mesh/mesh.h"
#include "libmorph/remap/corner_weights.h"
#include "libmorph/remap/locate.h"

#include <span>
#include <vector>

namespace morph {

/// Values of fields at points of the elements that hold them.
///
/// A nodal field is interpolated between the corners of the element (see corner_weights(); thesis, 4.2), an
/// element field has the element's value. A value is never outside the range of those it comes from; at a
/// vertex it is the vertex's, bit for bit, and where all corners have one value, it is that value. Equal
/// bytes for any thread count.
///
/// @param source     its vertices and elements are the rows of the fields
/// @param elements   of n points in it
/// @param at         n x 3: the points
/// @param fields     of the source
/// @return for each field n rows; 0 where no element holds the point
std::vector<Matrix> interpolate(const Mesh& source, const ContainingElements& elements,
                                const Eigen::Ref<const Points>& at, std::span<const Field* const> fields,
                                QuadRule rule);

} // namespace morph
