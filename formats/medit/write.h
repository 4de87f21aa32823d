#pragma once

#include "formats/format.h"

namespace morph {

/// Write a MEDIT mesh, binary when @p out is called .meshb, text when it is called .mesh; otherwise as the
/// options say. Names, and how triangles and quads were mixed, go into comments behind the last section.
void write_medit(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

std::vector<std::string> medit_losses(const MeshData& mesh, const WriteOptions& options);

} // namespace morph
