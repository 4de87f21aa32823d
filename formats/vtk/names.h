#pragma once

#include "libmorph/mesh/mesh_data.h"

#include <cstdint>
#include <string>
#include <vector>

namespace morph {

/// How VTK's files name markers and groups: a cell array holds numbers from 1 (0: neither), and strings in
/// the field data, called as the array with `_names` behind, say what each number is called.
///
/// Markers are numbered by the array `marker`, groups by `group`. Where a cell array has such a name
/// already, both names start with `marker_`, `marker__` and so on. A cell in several groups has the number
/// of the first in `group`; each group that this leaves incomplete has an array of 0 and 1 of its own,
/// called `group_N` for group N, which alone counts for it.
struct VtkNames {
    std::string array; ///< empty: the file names none
    std::vector<std::string> names;
};

enum class VtkNamed { marker, group };

/// The name of the field data that name the numbers of the cell array @p array.
std::string names_array(const std::string& array);

/// The inverse: the cell array that field data called @p name speak of; empty when they name something else.
std::string numbered_array(const std::string& name, VtkNamed kind);

/// The array of 0 and 1 for group @p number (from 1).
std::string overlap_array(const std::string& group_array, std::size_t number);

/// The first of `marker`, `marker_`, … that no element field of the mesh is called, nor begins with and `_`.
std::string free_array(const MeshData& mesh, VtkNamed kind);

/// For each element the number of the first group that has it, or 0; and the groups (from 1) that this
/// leaves incomplete.
struct GroupNumbers {
    std::vector<std::int32_t> first;
    std::vector<std::size_t> incomplete;
};
GroupNumbers group_numbers(const MeshData& mesh);

/// 1 for the elements of a group, else 0.
std::vector<std::uint8_t> membership(const MeshData& mesh, const ElementGroup& group);

} // namespace morph
