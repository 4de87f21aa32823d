#pragma once

#include "formats/format.h"

#include <string>
#include <string_view>

namespace morph {

/// The two of VTK's XML files that hold elements.
enum class VtkXmlKind { unstructured_grid, poly_data };

/// The attribute `type` of the root, which is the name of its first element too.
std::string_view name_of(VtkXmlKind kind);

/// Read a VTK XML file of that kind; see VtkGrid for what becomes of cells and markers. Of several pieces
/// `zone` picks one; else they are joined, each a group of elements.
/// @throws InputError  "path:line: …"
MeshData read_vtk_xml(const InputBytes& file, VtkXmlKind kind);

/// Write one piece: raw appended data, compressed with zlib or not, or ASCII.
void write_vtk_xml(const MeshData& mesh, VtkXmlKind kind, const WriteOptions& options, OutputFile& file);

/// A zero ends a string in VTK's files: zeros in @p name become "%00", and a percent sign that would
/// then read as an escape becomes "%25". Every other name stays as it is.
std::string with_escapes(std::string_view name);

/// The inverse of with_escapes().
std::string without_escapes(std::string_view text);

} // namespace morph
