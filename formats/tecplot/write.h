#pragma once

#include "formats/format.h"

namespace morph {

/// Write an ASCII Tecplot file, variable by variable (BLOCK).
///
/// Elements are one zone, triangles in it as quads with the last corner twice where there are quads too.
/// Two or more groups that cut the elements into runs are a zone each; other groups are lists in auxiliary
/// data. Each marker is a FELINESEG zone behind them. All zones share the nodes of the first.
/// @throws InputError  the file cannot be written
void write_tecplot(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

} // namespace morph
