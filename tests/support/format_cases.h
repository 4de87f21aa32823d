#pragma once

#include "formats/format.h"
#include "libmorph/mesh/mesh_data.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace morph::test {

/// Meshes with everything a format can be asked to hold: triangles, quads, both, a surface in space,
/// vertices of no element, markers with odd names or no edges, fields of 1 to 9 components with
/// extreme values. Fields of vertices come before those of elements, as most files have them.
std::vector<std::pair<std::string, MeshData>> rich_meshes();

/// Those of the rich meshes that are planar and have elements.
std::vector<std::pair<std::string, MeshData>> planar_meshes();

/// The quad with corners (0, 0), (1, 0), (1, 1), (0, 1), beginning at the one of number @p first, and a
/// triangle to its right with the corner (2, 0.5): 5 vertices.
MeshData square_and_triangle(std::size_t first);

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

/// The same for another way of reading, whose messages call the file "file".
void survive_mutations(const std::function<MeshData(const InputBytes&)>& read,
                       const std::vector<std::string>& seeds, int count);

} // namespace morph::test
