#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>
#include <vector>

namespace morph {

/// Fields of a mesh from a file of their own.
struct FieldFile {
    std::vector<Field> fields;
    bool su2_restart = false; ///< it is SU2's restart file as text
};

/// Read the fields of a mesh from another file: a CSV table of nodes (an SU2 restart file is one), the
/// thesis's function values (field f), or a mesh file of the same mesh.
///
/// Rows of a table belong to the vertices by PointID if it has that column, else in order.
/// @param format  name of the format; empty: by the extension
/// @throws InputError  the file is for another number of vertices or elements (names both counts), or for
/// vertices
///                     that lie elsewhere, by more than 1e-6 of the mesh's size
FieldFile read_fields(const std::string& path, const MeshData& mesh, const std::string& format = "");

} // namespace morph
