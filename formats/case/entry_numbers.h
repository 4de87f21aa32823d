#pragma once

#include "formats/case/toml_table.h"

#include <string>
#include <vector>

namespace morph {

/// Whole numbers from @p base on, lowered by it; none when the key is missing.
std::vector<Index> whole_numbers(const TomlTable& table, const std::string& key, Index base);

/// Rows of two or three numbers, whichever the first row has, as rows of three; no row when the key is
/// missing.
/// @param columns  three names for a file of rows, the first two of them in the plane
Matrix points_of(const TomlTable& table, const std::string& key, const std::vector<std::string>& columns);

} // namespace morph
