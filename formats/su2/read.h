#pragma once

#include "formats/format.h"

namespace morph {

/// Read an SU2 mesh of triangles and quads, or the surface of one of volume cells: sections in any order, any
/// spacing, `%` comments.
///
/// Vertices with ids at the end of their lines are sorted by them, as connectivity refers to
/// ids. Sections that are not understood come back as OpaqueSection. Of several zones one is taken, or they
/// are put behind one another, each a group "zone_1", …, with markers that several have called
/// "NAME_zone_1", …. The faces of a volume's markers are groups of the surface.
///
/// @throws InputError  "path:line: what is wrong"
MeshData read_su2(const InputBytes& input);

} // namespace morph
