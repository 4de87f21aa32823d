#pragma once

#include "formats/format.h"
#include "formats/tecplot/zone.h"

namespace morph {

/// One mesh from the zones of a file.
///
/// Zones of triangles and quads (a quad with a corner named twice is a triangle) are its elements, each a
/// group where there are several. Zones of lines are markers; their nodes are vertices of the elements, found
/// by place where the zones do not share coordinates. Nodes of several zones at one place are joined; their
/// values are those of the first. Zones of cells are a volume mesh (see surface_of()).
///
/// x, y and z are the variables of that name ("x", "X [m]", "CoordinateX"), or else the first two. Variables
/// v_0, v_1, …, 2 to 9 of them, are the components of one field v. Further states of a zone (its coordinates
/// and connectivity again, or its strand at another time) are left out with a warning.
///
/// @throws InputError  no zone of elements, or none of the name or number asked for; a variable at nodes in
///                     one zone and at cells in another; a cell with too few corners; as surface_of()
MeshData tecplot_mesh(TecplotFile file, const InputBytes& input);

} // namespace morph
