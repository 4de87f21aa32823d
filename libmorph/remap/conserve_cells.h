#pragma once

#include "libmorph/remap/locate.h"
#include "libmorph/remap/transfer.h"

namespace morph {

/// Transfer element values from one planar mesh to another so that their integral is preserved.
///
/// First order: values are constant in each element. An element T of the target gets the mean of the source
/// over what the source covers of it, sum_S |T n S| f_S / sum_S |T n S| [Grandy 1999, Journal of
/// Computational Physics 148(2), 433-466], by exact clipping. So the integral over the common region is that
/// of the source to rounding. A value is never outside the range of those it comes from; where they are all
/// the same it is that value, bit for bit, and onto the same mesh every value is. Equal bytes for any thread
/// count. O(1) for each pair of overlapping elements; see Supermesh, also for tangled meshes.
///
/// @param source  of m elements, planar
/// @param values  m x components, finite, rows in the source's own numbering
/// @return rows for the elements of the target
/// @throws InputError  a mesh lies in space, the source has no element, values has not m rows
Transfer conserve_cells(const Locator& source, const Mesh& target, const Matrix& values);

} // namespace morph
