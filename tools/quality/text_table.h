#pragma once

#include "libmorph/core/types.h"

#include <string>
#include <vector>

namespace morph::tools {

/// A histogram for the terminal: a title and a line with bounds, count and bar for each bin. The longest bar
/// has 40 signs, and none that counts anything is empty.
/// @param inverted  counted in a line of their own, when there are any
/// @param counts    of equal bins from 0 to @p end
std::vector<std::string> bar_lines(const std::string& title, Index inverted, const std::vector<Index>& counts,
                                   double end);

/// Rows of cells as lines with the columns below each other.
std::vector<std::string> table_lines(const std::vector<std::vector<std::string>>& rows);

} // namespace morph::tools
