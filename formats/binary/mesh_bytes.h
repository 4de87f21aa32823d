#pragma once

#include "formats/binary/memory_file.h"
#include "formats/mesh/volume_cells.h"

#include <string>
#include <string_view>

namespace morph {

/// Hand a mesh and what its reader noted to another process of this program. No file has these bytes:
/// they are the numbers as they lie in memory.
/// @throws SolverError  there is no memory for them
void append_mesh(MemoryFile& to, const VolumeFile& volume, const ReadNotes& notes);

/// The mesh back. Its indices and sizes are checked, as the process that made it may have been damaged by
/// what it read; the corners of volume cells are not, surface_of() does that.
/// @param notes  what the reader noted is added to it
/// @throws InputError  "path: …": the bytes are not those of a sound mesh
VolumeFile mesh_from_bytes(std::string_view bytes, const std::string& path, ReadNotes& notes);

} // namespace morph
