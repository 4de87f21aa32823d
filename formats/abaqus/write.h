#pragma once

#include "formats/format.h"

namespace morph {

/// Write an Abaqus input file: CPS3 and CPS4 in the plane, S3 and S4 in space, groups as *ELSET, the edges of
/// markers as T2D2 or T3D2 with an ELSET of their own. A set whose name Abaqus would not take has a plainer
/// one, and a comment before it has the full name.
/// @throws InputError  the file cannot be written
void write_abaqus(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

} // namespace morph
