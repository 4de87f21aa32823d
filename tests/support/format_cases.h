#pragma once

#include "formats/format.h"
#include "libmorph/mesh/mesh_data.h"

#include <string>
#include <utility>
#include <vector>

namespace morph::test {

/// Meshes with everything a format can be asked to hold: triangles, quads, both, a surface in space,
/// vertices of no element, markers with odd names or no edges, fields of 1 to 9 components with
/// extreme values. Fields of vertices come before those of elements, as most files have them.
std::vector<std::pair<std::string, MeshData>> rich_meshes();

/// The bytes that @p format writes for @p mesh.
std::string written(const MeshData& mesh, const std::string& format, const WriteOptions& options = {});

/// What @p format reads from @p bytes; messages call the file "file".
MeshData read_bytes(const std::string& bytes, const std::string& format);

/// The message of the InputError with which @p format refuses @p bytes; "accepted" if it does not.
std::string refusal(const std::string& bytes, const std::string& format);

/// @p text with the first @p from replaced by @p to. Throws when there is none, so that no test
/// passes because its change was not made.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// Change, cut, repeat or insert a few bytes of @p seeds at random, @p count times: @p format either
/// reads the result into a mesh that is sound (indices in range, sizes that fit) or throws an
/// InputError. Reports a failure otherwise.
void survive_mutations(const std::string& format, const std::vector<std::string>& seeds, int count);

} // namespace morph::test
