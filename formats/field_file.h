#pragma once

#include "formats/format.h"

#include <string>
#include <vector>

namespace morph {

/// Fields of a mesh from a file of their own.
struct FieldFile {
    std::vector<Field> fields;
    bool su2_restart = false; ///< it is SU2's restart file as text
};

/// Read the fields of a mesh from another file: a CSV table of vertices (SU2's restart file is one), the
/// thesis's function values (one field, called f), or a mesh file of the same mesh.
///
/// Rows of a table belong to the vertices by PointID if it has that column, else in order. Columns x and y
/// may be missing from it.
/// @param path    of the file with the fields
/// @param mesh    in the numbering of its file
/// @param format  name of the format; empty: by the extension
/// @throws InputError  the file is for another number of vertices or elements (names both counts), or for
///                     vertices that lie elsewhere, by more than 1e-6 of the diagonal of the mesh's box; a
///                     value is not finite; there are no fields
FieldFile read_fields(const std::string& path, const MeshData& mesh, const std::string& format = "");

/// As read_fields(), from bytes in memory.
FieldFile parse_fields(const InputBytes& file, const MeshData& mesh, const std::string& format = "");

} // namespace morph
