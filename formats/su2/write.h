#pragma once

#include "formats/format.h"

namespace morph {

/// Write an SU2 mesh, the text carried from another SU2 file behind the markers.
///
/// @throws InputError  a marker has a name that SU2 would not read back, or the file cannot be written
void write_su2(const MeshData& data, const WriteOptions& options, OutputFile& out);

} // namespace morph
