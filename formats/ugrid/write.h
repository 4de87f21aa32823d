#pragma once

#include "formats/format.h"

namespace morph {

/// Write an AFLR/UGRID file without volume cells in the layout that the name of @p out says; x.ugrid is text.
/// In a file of another extension the options decide between text and the layout .lb8.
/// @throws InputError  a record of Fortran cannot be that long
void write_ugrid(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

std::vector<std::string> ugrid_losses(const MeshData& mesh, const WriteOptions& options);

} // namespace morph
