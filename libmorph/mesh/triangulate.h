#pragma once

#include "libmorph/mesh/mesh_data.h"

namespace morph {

/// The mesh with every quad split into two triangles, in its place in the order of elements.
///
/// The shorter diagonal is taken, unless only the other leaves both triangles facing the same way (a quad
/// that is not convex). Both triangles have the quad's element fields and groups.
MeshData triangulated(MeshData mesh);

} // namespace morph
