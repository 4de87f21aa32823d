#pragma once

#include "formats/format.h"

namespace morph {

/// Read a MEDIT mesh, text or binary, and the solutions next to it. Edges become markers and faces become
/// groups, by their references; cells are handed to surface_of(). Corners, Ridges, Required… and the
/// references of vertices are carried.
/// @throws InputError  "path:line: …", in binary "path: byte 12: …"
MeshData read_medit(const InputBytes& file);

} // namespace morph
