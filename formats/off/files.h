#pragma once

#include "formats/format.h"

#include <string_view>

namespace morph {

/// Fields of vertices that OFF has a place for, with their number of components.
inline constexpr std::string_view kOffNormal = "normal";   ///< 3
inline constexpr std::string_view kOffColor = "color";     ///< 3 or 4
inline constexpr std::string_view kOffTexture = "texture"; ///< 2

/// Read a Geomview OFF mesh, as text or (big-endian, single precision) binary. What the prefixes N, C and ST
/// announce becomes fields of the vertices; the colours of faces, and a colour from a table (one number), are
/// left out and warned of.
/// @throws InputError  "path:line: …" or "path: byte N: …"
MeshData read_off(const InputBytes& file);

/// Write an OFF mesh as text, which keeps double precision, with the fields above.
void write_off(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

/// Nodal fields other than those above.
std::vector<std::string> off_losses(const MeshData& mesh, const WriteOptions& options);

} // namespace morph
