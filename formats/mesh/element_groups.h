#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <string>
#include <vector>

namespace morph {

/// For formats that give an element one reference, or a few: in column k, for each element, the number
/// (from 1) of the k-th group that has it, in the order of the groups, or 0. There are as many columns as
/// groups share an element; none without groups.
std::vector<std::vector<Index>> group_columns(const MeshData& mesh);

/// What a format that has one group for each element loses: "3 element(s) of group 'b', which are in
/// another group too". For `losses` of a Format.
std::vector<std::string> overlap_losses(const MeshData& mesh);

} // namespace morph
