#pragma once

#include "formats/format.h"

namespace morph {

/// Read a PLY mesh, as text or binary in either byte order. Properties of one number other than the coordinates
/// are fields; rows of an element `edge` are the edges of markers; faces with numbers in properties `group`
/// are in groups. Their names are in comments: see names.h. Other elements and lists are left out and
/// warned of.
/// @throws InputError  "path:line: …" or "path: byte N: …"
MeshData read_ply(const InputBytes& file);

/// Write a PLY mesh with everything that MeshData holds, numbers in double precision.
void write_ply(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

} // namespace morph
