#pragma once

#include "formats/format.h"

namespace morph {

/// Read a Gmsh file of version 2.0 to 2.2, 4.0 or 4.1, text or binary; sections may come in any order.
///
/// Physical groups of lines become markers, those of faces groups, under their names, or their tags where
/// they have none; see GmshGroups for lines of no group, GmshFields for data. Of a volume mesh,
/// surface_of() takes the boundary. What is passed over ($Periodic, $ElementNodeData, …) is warned of.
///
/// @throws InputError  "path:line: …", in binary files "path: byte N: …"
MeshData read_gmsh(const InputBytes& file);

} // namespace morph
