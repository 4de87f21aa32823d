#pragma once

#include "formats/format.h"

namespace morph {

/// Read STL triangles, as text ("solid NAME … facet … endsolid") or in single precision.
///
/// Equal corners are joined, numbered in the order of their first appearance. Solids with a name are
/// groups; several of one name are one group.
/// @throws InputError  "path:line: …" or "path: byte N: …"
MeshData read_stl(const InputBytes& file);

/// Write triangles, quads cut along the shorter diagonal, in the order of the elements: as text a solid for
/// each run of elements of one group, named for it.
/// @throws InputError  a coordinate is beyond single precision, in which the binary form is
void write_stl(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

/// Quads, numbers of vertices, groups in the binary form, …
std::vector<std::string> stl_losses(const MeshData& mesh, const WriteOptions& options);

} // namespace morph
