#pragma once

#include "formats/format.h"

namespace morph {

/// Read an SU2 mesh of triangles and quads: sections in any order, any spacing, `%` comments.
///
/// Vertices that carry ids at the end of their lines are sorted by them, as connectivity refers to
/// ids. Sections that are not understood come back as CarriedText.
///
/// @throws InputError  "path:line: what is wrong"
MeshData read_su2(const InputBytes& input);

} // namespace morph
