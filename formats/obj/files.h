#pragma once

#include "formats/format.h"

#include <string_view>

namespace morph {

/// The field of vertices that the three numbers behind coordinates are: red, green, blue.
inline constexpr std::string_view kObjColor = "color";

/// Groups that one element can be in: each element below a `g` takes memory for each of its names.
inline constexpr std::size_t kMostObjGroups = 64;

/// Read an OBJ mesh. The elements below `g NAME …`, `o NAME` and `usemtl NAME` are in groups of these names;
/// lines (`l`) below them are the edges of markers. Three numbers behind the coordinates of every vertex
/// are the field "color"; %XX in names is a byte.
///
/// Normals, texture coordinates and materials are left out and warned of.
/// @throws InputError  "path:line: …"
MeshData read_obj(const InputBytes& file);

/// Write vertices, faces and lines in their order, a `g` statement where the groups of elements change. Names
/// have blanks and what else would not survive as %XX.
void write_obj(const MeshData& mesh, const WriteOptions& options, OutputFile& out);

/// Fields other than "color", names that would become one, empty markers and groups.
std::vector<std::string> obj_losses(const MeshData& mesh, const WriteOptions& options);

} // namespace morph
