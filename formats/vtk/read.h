#pragma once

#include "formats/format.h"

namespace morph {

/// Read an unstructured, structured or rectilinear grid or polygons from a legacy VTK file; see VtkGrid for
/// what becomes of cells and markers.
/// @throws InputError  "path:line: …"
MeshData read_vtk(const InputBytes& file);

} // namespace morph
