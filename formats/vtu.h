#pragma once

#include "formats/format.h"

#include <string>
#include <string_view>

namespace morph {

/// Read the unstructured grid of a VTK XML file; see VtkGrid for what becomes of cells and markers.
/// @throws InputError  "path:line: …"
MeshData read_vtu(const InputBytes& file);

/// A zero ends a string in VTK's files: zeros in @p name become "%00", and a percent sign that would
/// then read as an escape becomes "%25". Every other name stays as it is.
std::string with_escapes(std::string_view name);

/// The inverse of with_escapes().
std::string without_escapes(std::string_view text);

} // namespace morph
