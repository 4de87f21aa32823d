#pragma once

#include "formats/format.h"

namespace morph {

/// Write a Gmsh file of version 4.1. Each marker is a physical group of a curve of its own; elements of
/// the same groups are a surface with these physical groups. Elements keep their order: a block ends
/// where the surface or the type changes. What GmshNames describes goes into $Comments.
///
/// @throws InputError  the file cannot be written
void write_gmsh(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

} // namespace morph
