#pragma once

#include "formats/format.h"
#include "formats/off/header.h"

namespace morph {

/// Read what follows the line "OFF BINARY": 32-bit integers and single-precision numbers, big-endian, faces
/// with a number of colour components behind their corners, as Geomview has it. OpenMesh writes
/// little-endian numbers and no colour components; such files are read too.
/// @param begin  of the counts in the file
/// @throws InputError  "path: byte N: …", for a file as Geomview has it
MeshData read_off_binary(const InputBytes& file, const OffHeader& header, std::size_t begin);

} // namespace morph
