#pragma once

#include "formats/format.h"
#include "libmorph/mesh/mesh_data.h"

#include <string>
#include <vector>

namespace morph {

/// A part of a file that is a mesh by itself: a piece, a zone, a file that it refers to.
struct MeshPart {
    std::string name;
    MeshData mesh;
};

/// Which of @p names the option `zone` picks, by number from 1 or else by name; their count when it is empty.
/// @param what  one of them, for the message: "piece"
/// @throws InputError  none of them is called so
std::size_t picked_part(const std::vector<std::string>& names, const std::string& what,
                        const InputBytes& file);

/// One mesh of all parts, each a group behind the groups that they have; vertices of different parts stay
/// apart. Markers and groups of the same name become one, fields that not all parts have are left out and
/// warned of.
/// @throws InputError  too many vertices or elements for an Index
MeshData merge_parts(std::vector<MeshPart> parts, const InputBytes& file);

} // namespace morph
