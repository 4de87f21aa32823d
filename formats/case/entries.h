#pragma once

#include "tools/case/toml_table.h"

#include <vector>

namespace morph::tools {

/// One [[pull]]: vertices of the mesh, named by number or as those nearest to points, and how far they shall
/// move.
struct PullEntry {
    int line = 0;                ///< in the case file, for messages
    std::vector<Index> vertices; ///< file numbers; empty: points are given
    Matrix points;               ///< m x 3
    Matrix displacements;        ///< m x 3, length unit of the mesh
};

/// Read the [[pull]] entries of a case file.
/// @throws InputError  "case.toml:12: what is wrong"
std::vector<PullEntry> pull_entries(const TomlTable& root);

} // namespace morph::tools
